// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/fix_wall_tdhs.hpp"

#include "modify.h"

namespace interphase::hard_sphere {

void FixWallTdhs::init()
{
    if (!modify->find_fix_style_strict("tdhs", 0))
        complain(
            "there is no fix tdhs that heeds this wall; add `fix ID all tdhs`, or use wall/gran with a pair_style");
}

}  // namespace interphase::hard_sphere
