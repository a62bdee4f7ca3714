// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "base/vector.hpp"
#include "exchange/cell_locator.hpp"

namespace interphase {

/// What the coupler keeps of each particle between gas steps, beside the FluidForce. The particle engine carries both
/// along when particles change rank or place, as plain bytes; a new particle starts with the defaults.
struct ParticleCoupling {
    CellAddress home;                       ///< gas cell that held the centre
    double pressure_force[3] = {0, 0, 0};   ///< of the last gas step [N]
    double assumed_impulse[3] = {0, 0, 0};  ///< of drag and pressure, by the gas solve [kg m/s]
    double start_velocity[3] = {0, 0, 0};   ///< at the start of the gas step [m/s]
    double free_change[3] = {0, 0, 0};      ///< velocity change it would see without contacts [m/s]
};

inline Vector to_vector(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

inline void set(double (&v)[3], const Vector& value)
{
    v[0] = value[0];
    v[1] = value[1];
    v[2] = value[2];
}

static_assert(std::is_trivially_copyable_v<ParticleCoupling>);
static_assert(sizeof(ParticleCoupling) % sizeof(double) == 0);

}  // namespace interphase
