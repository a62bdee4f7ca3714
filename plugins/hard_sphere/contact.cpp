// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/contact.hpp"

#include "hard_sphere/impact.hpp"

namespace interphase::hard_sphere {

void judge_impact(Contact& contact, const Vector& meeting, const Vector& push, const StepLimits& limits)
{
    const Divisor<double> step(limits.step);
    const auto met =
        approach(contact.touch_time, dot(meeting, contact.normal), dot(push, contact.normal), step, limits);
    if (met.speed <= met.least) return;
    contact.impact = true;
    contact.speed = met.speed;
    contact.later = met.later;
}

double relieving_speed(double gap, const StepLimits& limits)
{
    return relieving_speed(gap, Divisor<double>(limits.step), limits);
}

Contact contact_of_spheres(const Bodies& bodies, const Pair& pair, const Materials& materials, const StepLimits& limits)
{
    const auto a = static_cast<std::size_t>(pair.i), b = static_cast<std::size_t>(pair.j);
    const Path &path_a = bodies.path[a], &path_b = bodies.path[b];
    const Vector apart = to_vector(path_b.place.centre) - to_vector(path_a.place.centre);
    const Vector meeting = to_vector(path_b.velocity) - to_vector(path_a.velocity);
    const double touching = path_a.place.radius + path_b.place.radius;
    const Encounter<double> met = encounter(apart, meeting, touching, limits.step);
    const Vector normal = met.apart / met.distance;
    const double closing = closing_speed(met, touching, meeting.dot(normal), Divisor<double>(limits.step), limits);
    const int types = materials.between(bodies.label[a].type, bodies.label[b].type);
    Contact contact{pair.i, pair.j, normal, met.gap, closing, pair.touch == 1, false, met.time, 0, 0, types, 0};
    if (met.touch > 0)
        judge_impact(contact, meeting, to_vector(bodies.push[b].change) - to_vector(bodies.push[a].change), limits);
    return contact;
}

}  // namespace interphase::hard_sphere
