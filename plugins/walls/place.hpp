// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase::walls {

/// Of a sphere.
struct alignas(32) Place {
    double centre[3] = {0, 0, 0};  ///< [m]
    double radius = 0;             ///< [m]
};

}  // namespace interphase::walls
