// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/sphere_points.hpp"

#include <cmath>

namespace interphase {

const std::array<SpherePoints::Point, 13>& SpherePoints::all()
{
    static const std::array<Point, 13> points = [] {
        const double golden = 0.5 * (1 + std::sqrt(5.0)), to_corner = std::sqrt(1 + golden * golden);
        std::array<Point, 13> all;
        all[0] = {Vector::Zero(), share_of_centre};
        std::size_t n = 1;
        for (const double one : {-1.0, 1.0})
            for (const double other : {-golden, golden})
                for (const Vector& corner : {Vector(0, one, other), Vector(one, other, 0), Vector(other, 0, one)})
                    all[n++] = {radius / to_corner * corner, (1 - share_of_centre) / 12};
        return all;
    }();
    return points;
}

}  // namespace interphase
