// SPDX-License-Identifier: GPL-3.0-or-later
#include "mp_pic/fix_wall_mp_pic.hpp"

#include "modify.h"

namespace interphase::mp_pic {

void FixWallMpPic::init()
{
    if (!modify->find_fix_style_strict("mp_pic", 0))
        complain("there is no fix mp_pic that heeds this wall; add `fix ID all mp_pic`");
}

}  // namespace interphase::mp_pic
