// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "walls/fix_wall.hpp"

namespace interphase::mp_pic {

/// The LIGGGHTS fix style `wall/mp_pic`: walls for fix mp_pic, named as those of `wall/gran`.
class FixWallMpPic : public walls::FixWall {
public:
    static constexpr const char* style_name = "wall/mp_pic";

    using FixWall::FixWall;
    void init() override;
};

}  // namespace interphase::mp_pic
