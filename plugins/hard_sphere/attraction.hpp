// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vector.hpp"

namespace interphase::hard_sphere {

/// Two bodies near enough to each other for a law's attraction.
struct Attraction {
    int i, j;       ///< as the particle engine counts them; j below 0: wall_key of a wall
    int materials;  ///< which pair of types, Materials::between
    double gap;     ///< between the surfaces, below 0: overlap [m]
    double radius;  ///< effective, r_i at a wall [m]
    Vector normal;  ///< from i to j
    double force;   ///< what draws them to each other [N]; by the law
};

}  // namespace interphase::hard_sphere
