// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/particle_in_gas.hpp"
#include "forces/response.hpp"

namespace interphase {

/// What one particle asks of the gas in a step, in its cells the sum over all: the gas gets the force source - rate u
/// [N], `following` of the particle's volume feels the pressure gradient as gas, and the particle's volume moves by
/// flux + moving u - mobility grad p (volume times mean velocity over the step), u and grad p of the step's end.
struct Reaction {
    double rate;       ///< [kg/s]
    double source[3];  ///< [N]
    double following;  ///< [m3]
    double moving;     ///< [m3]
    double mobility;   ///< [m6 s/kg]
    double flux[3];    ///< [m4/s]
};

/// How solids move within a gas step, as far as the gas has to know.
enum class Motion {
    by_drift,      ///< their mean velocity over the step
    by_new_forces  ///< through the whole step at the velocity of its end, that of the forces of the new gas
};

/// @param doubt  how far it is a guess that contacts do not hold the particle, 0 to 1 (Hold)
/// @param owed   what it took in the last step beyond what the gas gave then [kg m/s]
Reaction reaction_of(const ParticleInGas& at, const Response& response, double doubt, const Vector& owed,
                     Motion motion);

/// What the gas solve gave to the particle then, by its own account: the impulse of the fluid [kg m/s].
Vector assumed_impulse(const Reaction& reaction, double volume, const Vector& owed, const Vector& gas_velocity,
                       const Vector& pressure_gradient, double duration);

}  // namespace interphase
