// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/plugin.hpp"

#include "hard_sphere/counters.hpp"
#include "hard_sphere/fix_tdhs_of.hpp"

using interphase::hard_sphere::ConstantRestitution;
using interphase::hard_sphere::FixTdhsOf;
using interphase::hard_sphere::FixWallTdhs;

using interphase::method;

INTERPHASE_PLUGIN("hard_sphere", {"tdhs", &interphase::create<FixTdhsOf<ConstantRestitution>>},
                  {"wall/tdhs", &interphase::create<FixWallTdhs>})
INTERPHASE_METHODS(
    method("TDHS", "impulses between hard spheres, time-driven").of_particles("CGHS").steps_per_collision(1),
    method("CGHS", "impulses between hard spheres, each a parcel").steps_per_collision(1))
INTERPHASE_COUNTERS(interphase::hard_sphere::counters)
