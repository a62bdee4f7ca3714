// SPDX-License-Identifier: GPL-3.0-or-later
#include "momentum/reaction.hpp"

#include <cmath>

#include "momentum/drag_response.hpp"

namespace interphase {

Reaction reaction_of(const ParticleInGas& at, const Response& response, double doubt, const Vector& owed, Motion motion)
{
    const double k = response.rate, m = at.mass, dt = at.duration, added = response.added_mass;
    const double x = k * dt / (m + added);
    const Shares of_motion = shares(x);
    const AssumedDrag drag = assume_drag(m, k, at.held, at.gravity, dt, answered(m, added, of_motion));
    const double stiff = stiffening(k, m, doubt, dt, added);
    const double taken = 1 - drag.following;  // of every force of the gas, by the particle

    Reaction reaction;
    reaction.rate = drag.kappa + stiff;
    // the part of the force that does not wait for the gas solve
    Vector source = drag.kappa * at.velocity + stiff * at.gas_velocity + (drag.carried - owed) / dt;
    source -= taken * response.force;
    reaction.following = drag.following * response.pressed_volume + (at.volume - response.pressed_volume);

    const double share =
        motion == Motion::by_new_forces ? -(1 - at.held) * std::expm1(-x) : (1.0 - at.held) * of_motion.withheld;
    const double moving = share * at.volume, per_rate = k > 0 ? 1.0 / k : 0.0;
    reaction.moving = moving;
    reaction.mobility = moving * response.pressed_volume * per_rate;
    Vector flux = (at.volume - moving) * at.velocity + moving * m * per_rate * at.gravity;
    flux += moving * per_rate * response.force;

    if (response.gas_mass > 0) {  // a force that grows with the change of the gas velocity
        const double per_change = response.gas_mass / dt;
        reaction.rate += taken * per_change;
        source += taken * per_change * at.gas_velocity;
        reaction.moving += moving * per_rate * per_change;
        flux -= moving * per_rate * per_change * at.gas_velocity;
    }
    set(reaction.source, source);
    set(reaction.flux, flux);
    return reaction;
}

Vector assumed_impulse(const Reaction& reaction, double volume, const Vector& owed, const Vector& gas_velocity,
                       const Vector& pressure_gradient, double duration)
{
    const Vector drag = duration * (reaction.rate * gas_velocity - to_vector(reaction.source)) - owed;
    return drag - duration * (volume - reaction.following) * pressure_gradient;
}

}  // namespace interphase
