// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "walls/fix_wall.hpp"

namespace interphase::hard_sphere {

/// The LIGGGHTS fix style `wall/tdhs`, or `wall/tdhs/LAW`: walls for the fix `tdhs` or `tdhs/LAW`, named as those of
/// `wall/gran`.
class FixWallTdhs : public walls::FixWall {
public:
    using FixWall::FixWall;
    void init() override { demand_heeding_fix(", or use wall/gran with a pair_style"); }
};

}  // namespace interphase::hard_sphere
