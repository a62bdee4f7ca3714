// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vector.hpp"

namespace interphase::walls {

template <class Number>
Vector vector(const Number (&v)[3])
{
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// Of a sphere.
struct alignas(32) Place {
    double centre[3] = {0, 0, 0};  ///< [m]
    double radius = 0;             ///< [m]
};

}  // namespace interphase::walls
