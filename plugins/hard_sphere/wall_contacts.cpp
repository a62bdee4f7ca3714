// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/wall_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace interphase::hard_sphere {

namespace {

using walls::PlaneWall;
using walls::Wall;
using walls::WallPoint;

/// Adds those of the bodies that may touch the wall: planes are many a scene's only walls, and quick about the others.
void choose(const Wall& wall, const Bodies& bodies, double reach, std::vector<int>& chosen)
{
    const int n = static_cast<int>(bodies.size());
    const auto* plane = dynamic_cast<const PlaneWall*>(&wall);
    if (!plane) {
        for (int i = 0; i < n; ++i)
            if (wall.may_touch(bodies.path[static_cast<std::size_t>(i)].place, reach)) chosen.push_back(i);
        return;
    }
    const Coarse& coarse = bodies.coarse;
    const auto axis = static_cast<std::size_t>(plane->axis());
    const float *centre = coarse.centre[axis].data(), *radius = coarse.radius.data();
    const auto at = static_cast<float>(plane->position() - coarse.middle[axis]),
               gap = static_cast<float>(reach + coarse.rounding);
    for (int i = 0; i < n; ++i)
        if (std::abs(centre[i] - at) < radius[i] + gap) chosen.push_back(i);
}

/// Of a wall that is not flat, or ends, the normal where the sphere touches is not the one where it comes from: moves
/// time and normal of `contact` to where it touches (Newton's iteration on the gap).
void follow_to_touch(Contact& contact, const Wall& wall, const Place& from, const Vector& meeting, double step)
{
    constexpr int iterations = 3;
    for (int k = 0; k < iterations && contact.touch_time > 0; ++k) {
        Place place = from;
        for (int axis = 0; axis < 3; ++axis)
            place.centre[axis] -= contact.touch_time * meeting[axis];
        std::vector<WallPoint> points;
        wall.near(place, 0.1 * place.radius, points);
        if (points.empty()) return;
        // of several, the one that continues this contact
        const WallPoint& point =
            *std::max_element(points.begin(), points.end(), [&](const WallPoint& a, const WallPoint& b) {
                return a.normal.dot(contact.normal) < b.normal.dot(contact.normal);
            });
        const double speed = meeting.dot(point.normal);
        if (speed >= 0) return;
        contact.normal = point.normal;
        contact.touch_time = std::clamp(contact.touch_time - point.gap / speed, 0.0, step);
    }
}

}  // namespace

void find_wall_contacts(Bodies& bodies, const std::vector<std::unique_ptr<walls::Wall>>& walls,
                        const Materials& materials, const StepLimits& limits, std::vector<Contact>& found)
{
    found.clear();
    std::vector<WallPoint> points;
    std::vector<int> chosen;
    for (std::size_t w = 0; w < walls.size(); ++w) {
        const Wall& wall = *walls[w];
        const double way = limits.step * wall.fastest();
        chosen.clear();
        choose(wall, bodies, limits.margin + limits.farthest + way, chosen);
        for (const int body : chosen) {
            const auto i = static_cast<std::size_t>(body);
            if (bodies.label[i].ghost || bodies.label[i].fixed) continue;
            const Place& place = bodies.path[i].place;
            const Vector velocity = to_vector(bodies.path[i].velocity);
            const double reach = limits.margin + limits.step * velocity.norm() + way;
            if (!wall.may_touch(place, reach)) continue;
            points.clear();
            wall.near(place, reach, points);
            for (const WallPoint& point : points) {
                const Vector meeting = point.velocity - velocity;
                const double end = point.gap + limits.step * meeting.dot(point.normal);
                if (std::min(point.gap, end) > limits.margin) continue;
                Contact contact{body,
                                static_cast<int>(bodies.size()),
                                point.normal,
                                point.gap,
                                point.gap > 0 ? point.gap / limits.step : relieving_speed(point.gap, limits),
                                std::min(point.gap, end) < limits.touching,
                                false,
                                0,
                                0,
                                0,
                                materials.between(bodies.label[i].type, wall.type()),
                                wall_key(w, point.element, walls.size())};
                if (!point.velocity.isZero()) contact.j = bodies.add_wall(point.velocity);
                if (end < 0 && end < point.gap) {
                    contact.touch_time = limits.step * std::max(0.0, point.gap) / (point.gap - end);
                    follow_to_touch(contact, wall, place, meeting, limits.step);
                    judge_impact(contact, meeting, -to_vector(bodies.push[i].change), limits);
                }
                found.push_back(contact);
            }
        }
    }
}

void find_wall_attractions(const Bodies& bodies, const std::vector<std::unique_ptr<walls::Wall>>& walls,
                           const Materials& materials, double range, std::vector<Attraction>& found)
{
    std::vector<WallPoint> points;
    std::vector<int> chosen;
    for (std::size_t w = 0; w < walls.size(); ++w) {
        const Wall& wall = *walls[w];
        chosen.clear();
        choose(wall, bodies, range, chosen);
        for (const int i : chosen) {
            const Label& label = bodies.label[static_cast<std::size_t>(i)];
            if (label.ghost || label.fixed) continue;
            const Place& place = bodies.path[static_cast<std::size_t>(i)].place;
            points.clear();
            wall.near(place, range, points);
            for (const WallPoint& point : points)
                found.push_back({i, wall_key(w, point.element, walls.size()),
                                 materials.between(label.type, wall.type()), point.gap, place.radius, point.normal, 0});
        }
    }
}

}  // namespace interphase::hard_sphere
