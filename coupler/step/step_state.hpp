// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <vector>

#include "base/vector.hpp"

namespace interphase {

/// A gas step in a few numbers, over all ranks: what the stability watch looks at.
struct StepState {
    double time = 0;      ///< at the end of the step [s]
    double duration = 0;  ///< gas step [s]

    double mass = 0;                        ///< of the particles [kg]
    Vector mean_velocity = Vector::Zero();  ///< their mass average at the end of the step [m/s]
    double kinetic_energy = 0;              ///< of their translation, at the end of the step [J]

    Vector mean_pressure_gradient = Vector::Zero();  ///< of the full pressure, solid-volume average [Pa/m]
    /// The gradient that carries the solids [Pa/m]: particle density * phi * |g|, phi their solid fraction where they
    /// are. Take phi to be at least 0.1: thin suspensions are not known to go wrong in this way, and a weight that
    /// vanishes with phi would make any noise of the gas look large.
    double weight_gradient = 0;

    double highest_pressure_gradient = 0;  ///< largest magnitude of any cell that holds solids [Pa/m]
    Vector where = Vector::Zero();         ///< centre of that cell [m]
    double fastest = 0;                    ///< largest speed of any particle [m/s]
    Vector fastest_at = Vector::Zero();    ///< its position [m]
    int fastest_id = 0;
    double gas_speed = 0;         ///< largest of any cell [m/s]
    double largest_crossing = 0;  ///< most gas cells of its own size that a particle crosses in this step
    /// ... and that a wave of the solid fraction does, where drag carries the particles and the step is longer than
    /// their relaxation time.
    double largest_wave_crossing = 0;
};

/// A series of them as text, to look at it later: a line of names, then a line of numbers a step.
void write_names(std::ostream& to);
void write(const StepState& state, std::ostream& to);

/// Reads what `write` wrote, or any table whose first line names some of its columns, in any order (time, duration,
/// mass, mean_velocity_z, ...); a column that is not there is 0, one of another name is an error (std::runtime_error).
std::vector<StepState> read_states(std::istream& from);

}  // namespace interphase
