// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/collision.hpp"

#include "hard_sphere/impact.hpp"

namespace interphase::hard_sphere {

Vector contact_velocity(const Sphere& a, const Sphere& b, const Vector& normal)
{
    return surface_velocity(a, b, a.radius, b.radius, normal);
}

namespace {

/// m_t, by which a tangential impulse changes the slip.
InverseMass tangential_mass(const Sphere& a, const Sphere& b)
{
    return {a.inverse_mass + b.inverse_mass + a.radius * a.radius * a.inverse_inertia +
            b.radius * b.radius * b.inverse_inertia};
}

}  // namespace

Vector contact_impulse(const Sphere& a, const Sphere& b, const Vector& normal, double parting,
                       double tangential_restitution, double friction)
{
    const auto [apart, slip] = in_parts(contact_velocity(a, b, normal), normal);
    if (apart >= parting) return Vector::Zero();
    const InverseMass mass{a.inverse_mass + b.inverse_mass};
    const double along = normal_impulse(0.0, mass, apart, -parting), speed = slip.norm();
    const double sticking = tangential_mass(a, b) * ((1 + tangential_restitution) * speed);
    return along * normal - within_cone(slip, speed, sticking, friction * along);
}

Vector collision_impulse(const Sphere& a, const Sphere& b, const Vector& normal, const Response& response)
{
    const double apart = contact_velocity(a, b, normal).dot(normal);
    if (apart >= 0) return Vector::Zero();
    return contact_impulse(a, b, normal, -response.restitution * apart, response.tangential_restitution,
                           response.friction);
}

void resist_rolling(Sphere& a, Sphere& b, const Vector& normal, const Vector& impulse, const Response& response,
                    bool impact)
{
    // a sphere on a plane comes nearer to rest by 5/7 each time; alone it has no memory of the last step to start from
    constexpr int times = 20;
    const double along = impulse.dot(normal);
    Vector tangential = impulse - along * normal, couple = Vector::Zero();
    for (int k = 0; k < times; ++k) {
        const Vector turn = rolling_couple<double>(a, b, normal, couple, response.rolling_arm * along);
        exchange_couple<double>(a, b, turn - couple);
        if (impact || turn == couple) return;
        couple = turn;
        const Vector slip = in_parts(contact_velocity(a, b, normal), normal).slip;
        const Vector wanted = tangential - (tangential_mass(a, b) * 1.0) * slip;
        const double size = wanted.norm();
        const Vector held = within_cone(wanted, size, size, response.friction * along);
        apply_impulse(a, b, normal, held - tangential);
        tangential = held;
    }
}

void apply_impulse(Sphere& a, Sphere& b, const Vector& normal, const Vector& impulse)
{
    exchange_impulse(a, b, a.radius, b.radius, normal, impulse);
}

}  // namespace interphase::hard_sphere
