// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "base/vector.hpp"

namespace interphase {

/// Points that stand for a sphere whose neighbours are no further apart than the cells of the mesh: its centre and the
/// corners of an icosahedron. A single point would leave the pattern of a regular packing in such cells, as counting
/// lattice planes does. Radius and shares are such that the points' spectrum is small over the wave numbers of
/// packings, 5 to 9 over the diameter: |0.13 + 0.87 sin(kr)/(kr)| < 0.15 there.
struct SpherePoints {
    static constexpr double radius = 0.65;  ///< [diameter]
    static constexpr double share_of_centre = 0.13;
    /// Of a coordinate [diameter squared].
    static constexpr double variance = (1 - share_of_centre) * radius * radius / 3;

    struct Point {
        Vector offset;  ///< from the centre of the sphere [diameter]
        double share;
    };
    static const std::array<Point, 13>& all();
};

}  // namespace interphase
