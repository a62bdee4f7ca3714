// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/plugin.hpp"

#include "mp_pic/fix_mp_pic.hpp"
#include "mp_pic/fix_wall_mp_pic.hpp"

using interphase::mp_pic::FixMpPic;
using interphase::mp_pic::FixWallMpPic;

INTERPHASE_PLUGIN("mp_pic", {FixMpPic::style_name, &interphase::create<FixMpPic>},
                  {FixWallMpPic::style_name, &interphase::create<FixWallMpPic>})
