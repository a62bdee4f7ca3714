// SPDX-License-Identifier: GPL-3.0-or-later
#include "mp_pic/wall_bounce.hpp"

#include <algorithm>
#include <cmath>

namespace interphase::mp_pic {

namespace {

/// Of a radius, the way in one part of a step: the centre must not get to a wall's other side unseen.
constexpr double part_of_radius = 0.5;
/// Only what moves 50,000 radii in a step comes to it; the coupler's step checks speak up long before.
constexpr double most_parts = 1e5;

/// Takes a sphere that has got into a wall out of it. Returns whether it bounced.
bool leave_wall(Drift& state, const walls::WallPoint& point, const WallLaw& law, double part)
{
    const double depth = -point.gap;
    const double approach = (state.velocity - point.velocity).dot(point.normal);
    if (approach <= 0) {
        state.position -= depth * point.normal;
        ++state.pushed;
        return false;
    }
    // it met the wall `late` ago, and has since then to move as the wall sent it
    const double late = std::min(depth / approach, part);
    const Vector after = point.velocity + bounced(state.velocity - point.velocity, point.normal, law.normal_restitution,
                                                  law.tangential_restitution);
    state.position += late * (after - state.velocity);
    const double left_inside = depth - late * approach;  // of one that started there
    state.position -= left_inside * point.normal;
    state.velocity = after;
    return true;
}

}  // namespace

Vector bounced(const Vector& velocity, const Vector& normal, double normal_restitution, double tangential_restitution)
{
    const double towards = velocity.dot(normal);
    if (towards <= 0) return velocity;
    return tangential_restitution * (velocity - towards * normal) - normal_restitution * towards * normal;
}

Drift drift(const walls::Place& start, const Vector& velocity, double dt,
            const std::vector<std::unique_ptr<walls::Wall>>& walls, const std::vector<WallLaw>& laws)
{
    Drift state{to_vector(start.centre), velocity, {}, 0};
    const double way = dt * velocity.norm();
    const bool near =
        std::any_of(walls.begin(), walls.end(), [&](const auto& wall) { return wall->may_touch(start, way); });
    if (!near) {
        state.position += dt * velocity;
        return state;
    }
    const int parts = static_cast<int>(std::clamp(std::ceil(way / (part_of_radius * start.radius)), 1.0, most_parts));
    std::vector<walls::WallPoint> points;
    walls::Place place = start;
    for (int n = 0; n < parts; ++n) {
        state.position += dt / parts * state.velocity;
        for (std::size_t w = 0; w < walls.size(); ++w) {
            set(place.centre, state.position);
            points.clear();
            walls[w]->near(place, 0.0, points);
            for (const walls::WallPoint& point : points) {
                const Vector before = state.velocity;
                const Vector at = state.position + (start.radius + point.gap) * point.normal;
                if (leave_wall(state, point, laws[static_cast<std::size_t>(walls[w]->type())], dt / parts))
                    state.bounces.push_back({w, point.element, at, state.velocity - before});
            }
        }
    }
    return state;
}

}  // namespace interphase::mp_pic
