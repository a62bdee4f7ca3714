// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/plugin.hpp"

#include "hard_sphere/fix_tdhs.hpp"
#include "hard_sphere/fix_wall_tdhs.hpp"

using interphase::hard_sphere::FixTdhs;
using interphase::hard_sphere::FixWallTdhs;

INTERPHASE_PLUGIN("hard_sphere", {FixTdhs::style_name, &interphase::create<FixTdhs>},
                  {FixWallTdhs::style_name, &interphase::create<FixWallTdhs>})
