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
    double assumed_impulse[3] = {0, 0, 0};  ///< of drag and pressure, by the gas solve [kg m/s]

    // only what the next step's assumption starts from, hence single precision
    float pressure_force[3] = {0, 0, 0};  ///< of the last gas step [N]
    float start_velocity[3] = {0, 0, 0};  ///< at the start of the gas step [m/s]
    float free_change[3] = {0, 0, 0};     ///< velocity change it would see without contacts [m/s]
};

template <class Number>
Vector to_vector(const Number (&v)[3])
{
    return {v[0], v[1], v[2]};
}

template <class Number>
void set(Number (&v)[3], const Vector& value)
{
    for (int axis = 0; axis < 3; ++axis)
        v[axis] = static_cast<Number>(value[axis]);
}

static_assert(std::is_trivially_copyable_v<ParticleCoupling>);

}  // namespace interphase
