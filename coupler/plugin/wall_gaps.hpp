// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase {

/// WallGaps* (exactly that type, as void*), by Fix::extract of a fix whose style begins with `wall/`: how far spheres
/// are from its wall. The coupler looks at a run's start whether particles stand in it.
constexpr const char* extract_wall_gaps = "wall_gaps";

class WallGaps {
public:
    virtual ~WallGaps() = default;

    /// From the surface of a sphere to the wall [m], below 0 where they overlap; any number above 0 where they do not.
    virtual double gap(const double centre[3], double radius) const = 0;
};

}  // namespace interphase
