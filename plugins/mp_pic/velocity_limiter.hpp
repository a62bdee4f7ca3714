// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vector.hpp"
#include "plugin/solid_stress.hpp"

namespace interphase::mp_pic {

/// The change of velocity [m/s] that the stress wants of a particle over `dt` [s]: eq. 7 of the paper per mass, with
/// its drag implicit (Andrews and O'Rourke, Int. J. Multiphase Flow 22 (1996) 379),
///     -dt grad tau / (rho_p phi (1 + dt/t_r)).
Vector stress_change(const StressState& state, double density, double dt);

/// How a particle moves against the mean solid motion, along one axis [m/s].
struct Approach {
    double to_mean;  ///< mean motion less the particle's, after drag and gravity
    double before;   ///< the same before drag and gravity
    double
        closing;  ///< by how much what lies ahead is slower than the mean motion, where that compresses the cell; >= 0
};

/// The part of `change` [m/s] that a particle gets along one axis, along which the stress rises with `slope` [Pa/m].
/// One that moves towards higher stress relative to the mean motion is slowed to what lies ahead, and reflected with
/// `restitution` at most as fast as it came; one that moves away already gets nothing. So none is flung, however steep
/// the stress is. What forces added in this step is not reflected: a bed at rest is held and not shaken.
double limited_change(double change, double slope, const Approach& approach, double restitution);

/// Both, axis by axis: what the stress does to a particle that had `before` [m/s] and would have `velocity` without it.
Vector limited_stress_change(const StressState& state, const Vector& before, const Vector& velocity, double density,
                             double restitution, double dt);

/// The longest step [s] of eq. 28 of the paper for one particle: the least of courant * cell_size/|v| by axis and
/// `share` of its relaxation time. Not eq. 29's of Stokes, which is many times too long beyond Re = 1 (37 s for the
/// paper's particle), but the one that the drag law has now. (The third limit, the gas step, is the coupler's.)
struct LongestStep {
    double crossing;    ///< so that it stays within the part of a cell [s]
    double relaxation;  ///< [s]
};
LongestStep longest_step(const StressState& state, const Vector& velocity, double courant, double share);

}  // namespace interphase::mp_pic
