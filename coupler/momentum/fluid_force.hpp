// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "momentum/particle_coupling.hpp"

namespace interphase {

/// The force [N] that replaces `other` (all other forces on the particle, N) during one solid substep dt [s], so that the
/// integrator's dv = f dt / m is the exact solution of m dv/dt = k (u - v) + F_p + other for constant other: stable for any
/// k dt / m. Books the drag impulse in `state`.
inline Vector force_with_fluid(ParticleCoupling& state, const Vector& other, const Vector& velocity, double mass,
                               double dt)
{
    const Vector steady = other + ParticleCoupling::vector(state.steady_force);
    const double k = state.drag_rate;
    const Vector slip = ParticleCoupling::vector(state.gas_velocity) - velocity;
    const Vector total = relaxed_share(k * dt / mass) * (k * slip + steady);
    const Vector drag_impulse = (total - steady) * dt;
    for (int axis = 0; axis < 3; ++axis) state.drag_impulse_taken[axis] += drag_impulse[axis];
    return total;
}

}  // namespace interphase
