// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/plugin.hpp"

#include "hard_sphere/fix_tdhs_of.hpp"

using interphase::hard_sphere::ConstantRestitution;
using interphase::hard_sphere::FixTdhsOf;
using interphase::hard_sphere::FixWallTdhs;

INTERPHASE_PLUGIN("hard_sphere", {"tdhs", &interphase::create<FixTdhsOf<ConstantRestitution>>},
                  {"wall/tdhs", &interphase::create<FixWallTdhs>})
