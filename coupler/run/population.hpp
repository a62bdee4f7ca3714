// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/communicator.hpp"
#include "step/solids.hpp"

namespace interphase {

/// The particles of all ranks, tracked and real.
struct Population {
    long tracked = 0;
    double real = 0;  ///< the sum of the weights
    double lowest_weight = 1, highest_weight = 1;
    double smallest_diameter = 0, largest_diameter = 0;  ///< of the real particles [m]

    double mean_weight() const { return lowest_weight == highest_weight ? lowest_weight : real / tracked; }
};

/// Collective.
Population counted(const Communicator& comm, const ParticleView& particles);

/// "weight 8", or "weights 1 to 27".
std::string weights_of(const Population& all);

/// "11875 of weight 8, for 95000 real ones of 0.003256 m", and what is said of spheres of radii still to come [m].
std::string numbers_of(const Population& all, const Scalars& radii_to_come);

}  // namespace interphase
