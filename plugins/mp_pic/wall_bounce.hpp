// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "walls/wall.hpp"

namespace interphase::mp_pic {

/// What a wall leaves of the velocity of a particle without rotation that meets it: -e_n of the part along `normal`
/// (towards the wall), e_t of the part along the wall [m/s].
Vector bounced(const Vector& velocity, const Vector& normal, double normal_restitution, double tangential_restitution);

/// e_n and e_t of a particle type on each type of wall, from 0.
struct WallLaw {
    double normal_restitution = 1;
    double tangential_restitution = 1;
};

/// What a wall gave a particle.
struct Bounce {
    std::size_t wall;
    int element;             ///< of the wall, WallPoint::element
    Vector point;            ///< where [m]
    Vector velocity_change;  ///< of the particle [m/s]
};

struct Drift {
    Vector position;
    Vector velocity;
    std::vector<Bounce> bounces;
    int pushed = 0;  ///< times that it was put back out of a wall that it did not approach
};

/// Moves a particle straight on for `dt` [s], off the walls that it meets, in parts so short that it passes through
/// none. `laws`: by type of wall. Exact at flat walls met one at a time.
Drift drift(const walls::Place& start, const Vector& velocity, double dt,
            const std::vector<std::unique_ptr<walls::Wall>>& walls, const std::vector<WallLaw>& laws);

}  // namespace interphase::mp_pic
