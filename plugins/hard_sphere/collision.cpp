// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/collision.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace interphase::hard_sphere {

Vector contact_velocity(const Sphere& a, const Sphere& b, const Vector& normal)
{
    return b.velocity - a.velocity - (b.radius * b.spin + a.radius * a.spin).cross(normal);
}

Vector contact_impulse(const Sphere& a, const Sphere& b, const Vector& normal, double parting,
                       double tangential_restitution, double friction)
{
    const Vector velocity = contact_velocity(a, b, normal);
    const double apart = velocity.dot(normal);
    if (apart >= parting) return Vector::Zero();
    const double inverse_mass = a.inverse_mass + b.inverse_mass;
    const double inverse_tangential =
        inverse_mass + a.radius * a.radius * a.inverse_inertia + b.radius * b.radius * b.inverse_inertia;
    const double along_normal = (parting - apart) / inverse_mass;

    const Vector slip = velocity - apart * normal;
    const double speed = slip.norm();
    if (speed == 0) return along_normal * normal;
    const double sticking = (1 + tangential_restitution) * speed / inverse_tangential;
    return along_normal * normal - std::min(sticking, friction * along_normal) / speed * slip;
}

Vector collision_impulse(const Sphere& a, const Sphere& b, const Vector& normal, const ContactLaw& law)
{
    const double apart = contact_velocity(a, b, normal).dot(normal);
    if (apart >= 0) return Vector::Zero();
    return contact_impulse(a, b, normal, -law.restitution * apart, law.tangential_restitution, law.friction);
}

void apply_impulse(Sphere& a, Sphere& b, const Vector& normal, const Vector& impulse)
{
    const Vector twist = normal.cross(impulse);
    a.velocity -= a.inverse_mass * impulse;
    b.velocity += b.inverse_mass * impulse;
    a.spin -= a.radius * a.inverse_inertia * twist;
    b.spin -= b.radius * b.inverse_inertia * twist;
}

}  // namespace interphase::hard_sphere
