// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "records/results.hpp"
#include "run/case_gas.hpp"
#include "step/solids.hpp"

namespace interphase {

/// What the series record of the whole scene at one time.
struct Observation {
    long particles = 0;
    double came = 0, went = 0;     ///< particles inserted, and those that left or were deleted, since the start
    double kinetic_energy = 0;     ///< of translation [J]
    double bed_height = 0;         ///< twice the centre of mass above the lowest point of the domain [m]
    double vertical_velocity = 0;  ///< mass average, against gravity [m/s]

    struct OfGas {
        std::optional<double> pressure_drop;  ///< first tap less last [Pa]; none without taps
        double bed_weight = 0;                ///< of all particles, over the vessel's mean cross-section [Pa]
        double lowest_voidage = 1;
        double highest_voidage = 1;
        double courant_number = 0;  ///< of the last step; before the first, of the fields as the case gives them
    };
    std::optional<OfGas> gas;  ///< none in a scene without gas

    /// What there is, and always the same in one run.
    std::vector<Results::Entry> row(double time) const;
};

/// `mass` [kg] of particles as a weight over the mean cross-section of the gas mesh across gravity [Pa]; 0 without
/// gravity. Collective.
double weight_per_area(const CaseGas& gas, double mass);

/// `gas` may be null; `pressure_taps` are two points of its mesh or more, or none. Collective.
Observation observe(const Communicator& comm, Solids& solids, const CaseGas* gas, const Scalars& voidage,
                    const std::vector<Vector>& pressure_taps);

}  // namespace interphase
