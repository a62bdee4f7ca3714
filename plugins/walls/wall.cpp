// SPDX-License-Identifier: GPL-3.0-or-later
#include "walls/wall.hpp"

#include <cmath>

namespace interphase::walls {

void PlaneWall::near(const Place& sphere, double reach, std::vector<WallPoint>& points) const
{
    if (!may_touch(sphere, reach)) return;
    const double distance = sphere.centre[axis_] - at_;
    Vector normal = Vector::Zero();
    normal[static_cast<Eigen::Index>(axis_)] = distance > 0 ? -1 : 1;
    points.push_back({normal, std::abs(distance) - sphere.radius, Vector::Zero(), 0});
}

double CylinderWall::distance(const Place& sphere) const
{
    return std::hypot(sphere.centre[first_] - centre_[0], sphere.centre[second_] - centre_[1]);
}

bool CylinderWall::may_touch(const Place& sphere, double reach) const
{
    return std::abs(distance(sphere) - radius_) < sphere.radius + reach;
}

void CylinderWall::near(const Place& sphere, double reach, std::vector<WallPoint>& points) const
{
    const double from_axis = distance(sphere);
    const double to_wall = radius_ - from_axis;  // above 0: inside
    if (std::abs(to_wall) >= sphere.radius + reach || from_axis == 0) return;
    const double sign = to_wall > 0 ? 1 : -1;
    Vector normal = Vector::Zero();
    normal[static_cast<Eigen::Index>(first_)] = sign * (sphere.centre[first_] - centre_[0]) / from_axis;
    normal[static_cast<Eigen::Index>(second_)] = sign * (sphere.centre[second_] - centre_[1]) / from_axis;
    points.push_back({normal, std::abs(to_wall) - sphere.radius, Vector::Zero(), 0});
}

}  // namespace interphase::walls
