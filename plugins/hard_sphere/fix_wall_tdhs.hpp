// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "walls/fix_wall.hpp"

namespace interphase::hard_sphere {

/// The LIGGGHTS fix style `wall/tdhs`: walls for fix tdhs, named as those of `wall/gran`.
class FixWallTdhs : public walls::FixWall {
public:
    static constexpr const char* style_name = "wall/tdhs";

    using FixWall::FixWall;
    void init() override;
};

}  // namespace interphase::hard_sphere
