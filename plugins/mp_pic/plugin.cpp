// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/plugin.hpp"

#include "mp_pic/counters.hpp"
#include "mp_pic/fix_mp_pic.hpp"
#include "mp_pic/fix_wall_mp_pic.hpp"

using interphase::mp_pic::FixMpPic;
using interphase::mp_pic::FixWallMpPic;

using interphase::method;

INTERPHASE_PLUGIN("mp_pic", {FixMpPic::style_name, &interphase::create<FixMpPic>},
                  {FixWallMpPic::style_name, &interphase::create<FixWallMpPic>})
INTERPHASE_METHODS(method("MPPIC", "a stress of the solids on the gas mesh").without_single_collisions())
INTERPHASE_COUNTERS(interphase::mp_pic::counters)
