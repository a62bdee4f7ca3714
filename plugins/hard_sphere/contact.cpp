// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/contact.hpp"

#include <algorithm>
#include <cmath>

namespace interphase::hard_sphere {

namespace {

constexpr double resting_pushes = 2;

/// When within the step the spheres touch; the step's end where they do not.
double time_of_touch(const Vector& apart, const Vector& meeting, double touching, double step)
{
    const double closing = apart.dot(meeting);
    if (closing >= 0) return step;
    const double distance = apart.squaredNorm() - touching * touching;
    if (distance <= 0) return 0;
    const double discriminant = closing * closing - meeting.squaredNorm() * distance;
    if (discriminant <= 0) return step;
    return std::min(step, distance / (-closing + std::sqrt(discriminant)));
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

Contact contact_of_spheres(const Bodies& bodies, int i, int j, const Materials& materials, const StepLimits& limits)
{
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    const Vector apart = vector(bodies.place[b].centre) - vector(bodies.place[a].centre);
    const Vector meeting = vector(bodies.body[b].velocity) - vector(bodies.body[a].velocity);
    const double touching = bodies.place[a].radius + bodies.place[b].radius;
    const double length = apart.norm();
    Contact contact{i, j, apart / length, length - touching, false, 0, 0,
                    &materials.between(bodies.label[a].type, bodies.label[b].type), 0};
    contact.touch_time = time_of_touch(apart, meeting, touching, limits.step);
    if (contact.touch_time >= limits.step) return contact;
    const Vector across = contact.normal;
    if (contact.touch_time > 0) contact.normal = (apart + contact.touch_time * meeting) / touching;
    judge_impact(contact, meeting, bodies.push[b] - bodies.push[a], limits);
    if (!contact.impact) contact.normal = across;
    return contact;
}

}  // namespace interphase::hard_sphere
