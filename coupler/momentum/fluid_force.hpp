// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "momentum/drag_response.hpp"

namespace interphase {

/// The fluid force on one particle during the substeps of a gas step. With drag rate k, gas velocity u, the other
/// forces F_g of the gas (pressure gradient and the like), an added mass m' and the sum F of all other forces held over
/// a substep dt_s, the exact solution of
///     (m + m') dv/dt = k (u - v) + F_g + F
/// changes the velocity by f dt_s / m with f = s (k (u - v) + F_g + F), s = m/(m + m') relaxed_share(k dt_s/(m + m')):
/// stable for any k dt_s / m and m' / m.
///
/// It is read in every substep, where memory traffic is what it costs; hence single precision. That takes nothing from
/// the balances: what was applied is booked in double precision, and goes back to the gas as it was.
struct FluidForce {
    float constant[3] = {0, 0, 0};  ///< s (k u + F_g) [N]
    float rate = 0;                 ///< s k [kg/s]
    float share = 1;                ///< s: kept rather than 1 - s, which would lose it where drag is stiff

    FluidForce() = default;
    FluidForce(double mass, double drag_rate, const Vector& gas_velocity, const Vector& other_force, double dt_s,
               double added_mass = 0)
    {
        const double relaxed = answered(mass, added_mass, drag_rate, dt_s).relaxed;
        rate = static_cast<float>(relaxed * drag_rate);
        share = static_cast<float>(relaxed);
        for (int axis = 0; axis < 3; ++axis)
            constant[axis] = static_cast<float>(relaxed * (drag_rate * gas_velocity[axis] + other_force[axis]));
    }

    /// Replaces F in `force` by f, and adds the difference to `booked` [N].
    void apply(double* force, const double* velocity, double* booked) const
    {
        const double withheld = 1.0 - share;
        for (int axis = 0; axis < 3; ++axis) {
            const double fluid = constant[axis] - rate * velocity[axis] - withheld * force[axis];
            booked[axis] += fluid;
            force[axis] += fluid;
        }
    }

    /// The fluid's part of a force [N] that apply() made, at the velocity that it saw.
    Vector part_of(const Vector& force, const Vector& velocity) const
    {
        Vector fluid;
        for (int axis = 0; axis < 3; ++axis) {
            const double others = (force[axis] - constant[axis] + rate * velocity[axis]) / share;
            fluid[axis] = force[axis] - others;
        }
        return fluid;
    }
};

static_assert(std::is_trivially_copyable_v<FluidForce>);

}  // namespace interphase
