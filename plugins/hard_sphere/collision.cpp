// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/collision.hpp"

#include "hard_sphere/impact.hpp"

namespace interphase::hard_sphere {

Vector contact_velocity(const Sphere& a, const Sphere& b, const Vector& normal)
{
    return surface_velocity(a, b, a.radius, b.radius, normal);
}

Vector contact_impulse(const Sphere& a, const Sphere& b, const Vector& normal, double parting,
                       double tangential_restitution, double friction)
{
    const auto [apart, slip] = in_parts(contact_velocity(a, b, normal), normal);
    if (apart >= parting) return Vector::Zero();
    const InverseMass mass{a.inverse_mass + b.inverse_mass};
    const InverseMass tangential_mass{mass.value + a.radius * a.radius * a.inverse_inertia +
                                      b.radius * b.radius * b.inverse_inertia};
    const double along = normal_impulse(0.0, mass, apart, -parting), speed = slip.norm();
    const double sticking = tangential_mass * ((1 + tangential_restitution) * speed);
    return along * normal - within_cone(slip, speed, sticking, friction * along);
}

Vector collision_impulse(const Sphere& a, const Sphere& b, const Vector& normal, const Response& response)
{
    const double apart = contact_velocity(a, b, normal).dot(normal);
    if (apart >= 0) return Vector::Zero();
    return contact_impulse(a, b, normal, -response.restitution * apart, response.tangential_restitution,
                           response.friction);
}

void apply_impulse(Sphere& a, Sphere& b, const Vector& normal, const Vector& impulse)
{
    exchange_impulse(a, b, a.radius, b.radius, normal, impulse);
}

}  // namespace interphase::hard_sphere
