// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vector.hpp"

namespace interphase {

/// The box of the solids, and along which axes it repeats.
struct PeriodicBox {
    Box box = empty_box();  ///< [m]
    std::array<bool, 3> periodic{};

    bool any() const { return std::find(periodic.begin(), periodic.end(), true) != periodic.end(); }
    double length(int axis) const { return box(axis, 1) - box(axis, 0); }

    /// The image within the box. An engine may move a particle back only from time to time.
    Vector wrapped(Vector x) const
    {
        for (int axis = 0; axis < 3; ++axis)
            if (periodic[static_cast<std::size_t>(axis)])
                x[axis] -= length(axis) * std::floor((x[axis] - box(axis, 0)) / length(axis));
        return x;
    }
};

}  // namespace interphase
