// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "walls/fix_wall.hpp"

namespace interphase::mp_pic {

/// The LIGGGHTS fix style `wall/mp_pic`, or `wall/mp_pic/NAME`: walls for the fix `mp_pic` or `mp_pic/NAME`, named as
/// those of `wall/gran`.
class FixWallMpPic : public walls::FixWall {
public:
    using FixWall::FixWall;
    void init() override { demand_heeding_fix(); }
};

}  // namespace interphase::mp_pic
