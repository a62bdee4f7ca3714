// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase {

/// One gas step: a whole number of solid substeps.
struct GasStep {
    int substeps;
    double duration;  ///< substeps * solid step [s]
};

/// Keeps gas and solids in lockstep.
class LockstepClock {
public:
    /// `solid_step` [s] > 0.
    explicit LockstepClock(double solid_step) : solid_step_(solid_step) {}

    double solid_step() const { return solid_step_; }

    /// The gas step nearest below `wanted` [s], at least one substep, that does not pass `remaining` [s] by a whole
    /// substep or more.
    GasStep next(double wanted, double remaining) const;

private:
    double solid_step_;
};

/// The largest solid step of at most `most` [s] that divides `gas_step` [s] evenly.
double dividing_step(double gas_step, double most);

}  // namespace interphase
