// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/fix_wall_tdhs.hpp"

#include <cstring>

#include "modify.h"

namespace interphase::hard_sphere {

bool FixWallTdhs::is_heeded_by(const std::string& asking) const { return style == "wall/" + asking; }

void FixWallTdhs::init()
{
    const std::string heeding = style + std::strlen("wall/");
    if (!modify->find_fix_style_strict(heeding.c_str(), 0))
        complain("there is no fix " + heeding + " that heeds this wall; add `fix ID all " + heeding +
                 "`, or use wall/gran with a pair_style");
}

}  // namespace interphase::hard_sphere
