// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vector.hpp"
#include "hard_sphere/bodies.hpp"
#include "hard_sphere/material.hpp"
#include "hard_sphere/pair_search.hpp"

namespace interphase::hard_sphere {

/// Two bodies near enough to each other for a law's attraction.
struct Attraction {
    int i, j;       ///< places in Bodies; j below 0: wall_key of a wall
    int materials;  ///< which pair of types, Materials::between
    double gap;     ///< between the surfaces, below 0: overlap [m]
    double radius;  ///< effective, r_i at a wall [m]
    Vector normal;  ///< from i to j
    double force;   ///< what draws them to each other [N]; by the law
};

/// Adds those of `pairs` whose gap is below `range` [m] where they are now, and that this rank resolves.
void find_attractions(const Bodies& bodies, const PairSearch& pairs, const Materials& materials, double range,
                      std::vector<Attraction>& found);

}  // namespace interphase::hard_sphere
