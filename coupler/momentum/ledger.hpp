// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/communicator.hpp"

namespace interphase {

/// One gas step's impulses between gas and particles [kg m/s], and volumes [m3], on one rank.
struct Transactions {
    Vector given_by_gas = Vector::Zero();          ///< from the cells' side: drag and pressure gradient
    Vector taken_by_particles = Vector::Zero();    ///< from the particles' side, summed over the substeps
    Vector pending = Vector::Zero();               ///< taken less assumed: the next gas step's
    Vector assumed_of_particles = Vector::Zero();  ///< what the gas step assumed, of those still there
    double solid_volume_in_cells = 0;
    double solid_volume_of_particles = 0;
    double gas_volume = 0;           ///< of all cells at the end, cell by cell what was there less what flowed out
    double gas_in = 0, gas_out = 0;  ///< across the boundary of the mesh
};

/// Keeps the books of momentum, solid volume and gas volume over a run. The two sides of each are summed independently,
/// one over the cells and one over the particles or the boundary.
class Ledger {
public:
    explicit Ledger(const Communicator& comm) : comm_(comm) {}

    /// Books one step. `particles_left`: whether particles were removed during it; what the gas gave to them counts as
    /// taken away by them. Collective.
    void book(const Transactions& of_this_rank, const Vector& assumed_at_start, bool particles_left);

    /// |given - taken + pending| over all steps, relative to the impulse exchanged.
    double momentum_residual() const;

    /// Solid volume in the cells against that of the particles, relative to the total, in the last step.
    double volume_residual() const { return volume_residual_; }

    /// |gas volume of the cells - what was there at first - in + out| over all steps, relative to the volume of gas.
    double gas_volume_residual() const { return gas_volume_residual_; }

    double exchanged() const { return exchanged_; }
    const Vector& carried_off() const { return carried_off_; }

private:
    Communicator comm_;
    Vector given_ = Vector::Zero();
    Vector taken_ = Vector::Zero();
    Vector pending_ = Vector::Zero();
    Vector carried_off_ = Vector::Zero();
    double exchanged_ = 0;
    double volume_residual_ = 0;
    std::optional<double> gas_expected_;  ///< by the boundary's side [m3]
    double gas_volume_residual_ = 0;
};

}  // namespace interphase
