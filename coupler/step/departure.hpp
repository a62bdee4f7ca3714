// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vector.hpp"
#include "momentum/particle_coupling.hpp"

namespace interphase {

/// How a particle leaves the particles' engine.
enum class Exit {
    boundary,  ///< it was outside the particles' domain
    mesh,      ///< a surface mesh deletes what goes through it
    script     ///< anything else in the script deletes it
};

/// A particle that left, as it was then.
struct Departure {
    Exit exit;
    bool is_new;  ///< it was made in the same gas step
    int id;
    double position[3];   ///< [m]
    double velocity[3];   ///< [m/s]
    double mass, radius;  ///< of the tracked sphere [kg, m]
    double booked[3];     ///< sum of the fluid force over the substeps until then [N]
    ParticleCoupling coupling;
};

}  // namespace interphase
