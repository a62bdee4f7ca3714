// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/contact.hpp"

#include <algorithm>
#include <cmath>

namespace interphase::hard_sphere {

namespace {

/// The moment within the step at which two spheres touch, or are nearest if they do not.
struct Encounter {
    double time;
    bool touch;
};

Encounter encounter(const Vector& apart, const Vector& meeting, double touching, double step)
{
    const double closing = apart.dot(meeting);
    const double distance = apart.squaredNorm() - touching * touching;
    if (closing >= 0) return {0, false};
    if (distance <= 0) return {0, true};
    const double speed2 = meeting.squaredNorm();
    const double discriminant = closing * closing - speed2 * distance;
    if (discriminant > 0) {
        const double time = distance / (-closing + std::sqrt(discriminant));
        if (time < step) return {time, true};
    }
    return {std::min(step, -closing / speed2), false};
}

}  // namespace

void judge_impact(Contact& contact, const Vector& meeting, const Vector& push, const StepLimits& limits)
{
    // velocities belong to the middle of the step; the one at the moment of touching, and afterwards back again
    const double phase = contact.touch_time / limits.step - 0.5;
    const double gained = push.dot(contact.normal);
    const double approach = -(meeting.dot(contact.normal) + phase * gained);
    if (approach <= std::max(limits.resting_speed, resting_pushes * std::abs(gained))) return;
    contact.impact = true;
    contact.parting = std::max(0.0, contact.law->restitution * approach - phase * gained);
}

double relieving_speed(double gap, const StepLimits& limits)
{
    return std::min(0.0, limits.relief * (gap + limits.tolerated) / limits.step);
}

Contact contact_of_spheres(const Bodies& bodies, const Pair& pair, const Materials& materials, const StepLimits& limits)
{
    const auto a = static_cast<std::size_t>(pair.i), b = static_cast<std::size_t>(pair.j);
    const Path &path_a = bodies.path[a], &path_b = bodies.path[b];
    const Vector apart = vector(path_b.place.centre) - vector(path_a.place.centre);
    const Vector meeting = vector(path_b.velocity) - vector(path_a.velocity);
    const double touching = path_a.place.radius + path_b.place.radius;
    const double gap = apart.norm() - touching;
    const auto [time, touch] = encounter(apart, meeting, touching, limits.step);
    const Vector then = apart + time * meeting;
    const double distance = then.norm();
    Contact contact{pair.i,
                    pair.j,
                    then / distance,
                    gap,
                    0,
                    pair.touch == 1,
                    false,
                    time,
                    0,
                    &materials.between(bodies.label[a].type, bodies.label[b].type),
                    0};
    const double speed = meeting.dot(contact.normal);
    if (touch) {
        contact.closing = -speed * time / limits.step;
        judge_impact(contact, meeting, vector(bodies.push[b].change) - vector(bodies.push[a].change), limits);
    } else if (gap > 0) {
        contact.closing = (distance - touching) / limits.step - (time > 0 ? speed : 0);
    }
    if (gap < 0) contact.closing = relieving_speed(gap, limits);
    return contact;
}

}  // namespace interphase::hard_sphere
