// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/bodies.hpp"

#include <algorithm>
#include <limits>

namespace interphase::hard_sphere {

void Coarse::start(const std::array<double, 3>& low, const std::array<double, 3>& high)
{
    double extent = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        middle[axis] = 0.5 * (low[axis] + high[axis]);
        extent = std::max(extent, high[axis] - middle[axis]);
    }
    rounding = 4 * extent * std::numeric_limits<float>::epsilon();
}

void Bodies::write_coarse(std::size_t first, std::size_t last)
{
    for (std::size_t b = first; b < last; ++b) {
        for (int axis = 0; axis < 3; ++axis) {
            coarse.centre[axis][b] = static_cast<float>(path[b].place.centre[axis] - coarse.middle[axis]);
            coarse.velocity[axis][b] = static_cast<float>(path[b].velocity[axis]);
        }
        coarse.radius[b] = static_cast<float>(path[b].place.radius);
    }
}

}  // namespace interphase::hard_sphere
