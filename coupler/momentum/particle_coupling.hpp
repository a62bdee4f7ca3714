// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "base/vector.hpp"
#include "exchange/cell_locator.hpp"
#include "momentum/drag_response.hpp"

namespace interphase {

/// What the coupler keeps of each particle between steps. The particle engine carries it along when particles change
/// rank or place, as plain bytes; a new particle starts with this default.
struct ParticleCoupling {
    CellAddress home;  ///< gas cell that held the centre

    // constant over a gas step: the fluid force is drag_rate (gas_velocity - v) + steady_force
    double drag_rate = 0;                      ///< k [kg/s]
    double gas_velocity[3] = {0, 0, 0};        ///< u at the particle [m/s]
    double steady_force[3] = {0, 0, 0};        ///< pressure gradient force [N]

    double drag_impulse_taken[3] = {0, 0, 0};    ///< by the substeps since the gas solve [kg m/s]
    double drag_impulse_assumed[3] = {0, 0, 0};  ///< by the gas solve [kg m/s]

    double start_velocity[3] = {0, 0, 0};  ///< at the start of the gas step [m/s]
    double free_change[3] = {0, 0, 0};     ///< velocity change it would see without contacts [m/s]

    /// What it took differently from what the gas gave: the next gas step's to settle.
    Vector pending() const { return vector(drag_impulse_taken) - vector(drag_impulse_assumed); }

    static Vector vector(const double (&v)[3]) { return {v[0], v[1], v[2]}; }
    static void set(double (&v)[3], const Vector& value)
    {
        v[0] = value[0];
        v[1] = value[1];
        v[2] = value[2];
    }
};

static_assert(std::is_trivially_copyable_v<ParticleCoupling>);
static_assert(sizeof(ParticleCoupling) % sizeof(double) == 0);

}  // namespace interphase
