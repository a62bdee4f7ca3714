// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "walls/fix_wall.hpp"

namespace interphase::hard_sphere {

/// The LIGGGHTS fix style `wall/tdhs`, or `wall/tdhs/LAW`: walls for the fix `tdhs` or `tdhs/LAW`, named as those of
/// `wall/gran`.
class FixWallTdhs : public walls::FixWall {
public:
    using FixWall::FixWall;
    void init() override;

    /// `style`: of the fix that asks.
    bool is_heeded_by(const std::string& style) const;
};

}  // namespace interphase::hard_sphere
