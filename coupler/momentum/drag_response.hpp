// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vector.hpp"

namespace interphase {

// How a particle of mass m [kg] with drag rate k [kg/s] answers the gas over a step dt [s]. With the gas velocity u
// held, dv/dt = (k/m)(u - v) + a has the solution v(dt) = v + (1 - e^-x)(u + a m/k - v), x = k dt / m, and the impulse
// of drag is
//     J = m (1 - e^-x)(u - v) - m a (dt - (1 - e^-x) m/k).
// A particle that its contacts hold in place takes k dt (u - v) instead. Both are J = kappa dt (u - v) - carried, with
// kappa between m/dt (1 - e^-x) and k: that is what the gas solve treats implicitly, whatever x is.

/// (1 - e^-x)/x, 1 at x = 0: the share of a constant force that changes the velocity of a particle with drag.
double relaxed_share(double x);

/// 1 - relaxed_share(x), accurate at small x.
double withheld_share(double x);

/// What the gas solve assumes of a particle's drag impulse over a step: J = kappa dt (u - v) - carried.
struct AssumedDrag {
    double kappa;    ///< [kg/s]
    Vector carried;  ///< what other forces take over from drag [kg m/s]

    Vector impulse(const Vector& gas_velocity, const Vector& velocity, double dt) const
    {
        return kappa * dt * (gas_velocity - velocity) - carried;
    }
};

/// `held` in [0, 1]: how far contacts held the particle in the last step (see held_by_contacts); `acceleration` a
/// [m/s2]: gravity and pressure gradient.
AssumedDrag assume_drag(double mass, double drag_rate, double held, const Vector& acceleration, double dt);

/// The change of velocity over dt of a particle without contacts [m/s].
Vector free_change(double mass, double drag_rate, const Vector& slip, const Vector& acceleration, double dt);

/// 1 where the particle did not answer to the gas at all, or where nothing is known of it (`free_change` 0); 0 where it
/// moved as a free one.
double held_by_contacts(const Vector& change, const Vector& free_change);

}  // namespace interphase
