// SPDX-License-Identifier: GPL-3.0-or-later
// A collision of two spheres, or of one with a wall, is eqs. 10 to 15 of the paper, with the smaller of its two
// tangential impulses, and conserves linear and angular momentum.
#include "hard_sphere/collision.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

using namespace interphase;
using namespace interphase::hard_sphere;

namespace {

constexpr double round_off = 1e-13;

Sphere sphere(double radius, double density, const Vector& velocity, const Vector& spin)
{
    const double mass = density * 4 / 3 * M_PI * radius * radius * radius;
    return {velocity, spin, radius, 1 / mass, 1 / (0.4 * mass * radius * radius)};
}

Sphere wall() { return {Vector::Zero(), Vector::Zero(), 0, 0, 0}; }

struct Draw {
    std::mt19937 generator{7};
    double operator()(double low, double high) { return std::uniform_real_distribution<>(low, high)(generator); }
    Vector vector(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
};

}  // namespace

TEST(Collision, ConservesLinearAndAngularMomentum)
{
    Draw draw;
    for (int k = 0; k < 1000; ++k) {
        Sphere a = sphere(draw(1e-3, 1e-2), draw(500, 3000), draw.vector(1), draw.vector(100));
        Sphere b = sphere(draw(1e-3, 1e-2), draw(500, 3000), draw.vector(1), draw.vector(100));
        const Vector normal = draw.vector(1).normalized();
        const Response response{draw(0, 1), draw(0, 1), draw(0, 1)};
        const Vector centre = (a.radius + b.radius) * normal;  // of b; a is at the origin
        const auto momentum = [&]() -> Vector { return a.velocity / a.inverse_mass + b.velocity / b.inverse_mass; };
        const auto angular = [&]() -> Vector {
            return a.spin / a.inverse_inertia + b.spin / b.inverse_inertia + centre.cross(b.velocity) / b.inverse_mass;
        };
        const Vector p = momentum(), l = angular();
        const double size = a.velocity.norm() / a.inverse_mass + b.velocity.norm() / b.inverse_mass;
        apply_impulse(a, b, normal, collision_impulse(a, b, normal, response));
        EXPECT_LT((momentum() - p).norm(), round_off * size);
        EXPECT_LT((angular() - l).norm(), round_off * (l.norm() + centre.norm() * size));
    }
}

TEST(Collision, NormalVelocityComesBackTimesRestitution)
{
    Draw draw;
    for (int k = 0; k < 200; ++k) {
        const Vector normal = draw.vector(1).normalized();
        Sphere a = sphere(1e-3, 1000, normal + draw.vector(0.1), draw.vector(50));
        Sphere b = k % 2 ? wall() : sphere(2e-3, 2000, draw.vector(0.1), draw.vector(50));
        const Response response{draw(0, 1), draw(0, 1), draw(0, 1)};
        const double approach = contact_velocity(a, b, normal).dot(normal);
        apply_impulse(a, b, normal, collision_impulse(a, b, normal, response));
        EXPECT_NEAR(contact_velocity(a, b, normal).dot(normal), -response.restitution * approach, 1e-13);
    }
}

TEST(Collision, StickingContactReturnsSlipTimesTangentialRestitution)
{
    const Vector normal = Vector::UnitX();
    Sphere a = sphere(1e-3, 1000, {1, 0.2, -0.1}, {20, -30, 10}), b = sphere(3e-3, 700, {-1, 0.1, 0}, {5, 0, 0});
    const Response response{0.9, 0.6, 10};
    const Vector before = contact_velocity(a, b, normal);
    apply_impulse(a, b, normal, collision_impulse(a, b, normal, response));
    const Vector after = contact_velocity(a, b, normal);
    EXPECT_NEAR(after.y(), -0.6 * before.y(), 1e-13);
    EXPECT_NEAR(after.z(), -0.6 * before.z(), 1e-13);
}

TEST(Collision, StickingImpulseIsThatOfEquation11)
{
    const Vector normal = Vector::UnitX();
    const Sphere a = sphere(1e-3, 1000, {1, 0.2, 0}, Vector::Zero()),
                 b = sphere(1e-3, 1000, Vector::Zero(), Vector::Zero());
    const double reduced = 1 / (a.inverse_mass + b.inverse_mass);
    const Vector impulse = collision_impulse(a, b, normal, {0.84, 0.84, 10});
    EXPECT_NEAR(impulse.x(), 1.84 * reduced, 1e-13 * reduced);
    EXPECT_NEAR(impulse.y(), 2.0 / 7 * reduced * 1.84 * 0.2, 1e-13 * reduced);
}

TEST(Collision, SlidingContactObeysCoulomb)
{
    const Vector normal = Vector::UnitX();
    const Sphere a = sphere(1e-3, 1000, {0.1, 2, 0}, Vector::Zero()), b = wall();
    const Vector impulse = collision_impulse(a, b, normal, {0.5, 0.5, 0.3});
    EXPECT_NEAR(impulse.y(), 0.3 * impulse.x(), 1e-13 * impulse.x());
    EXPECT_EQ(impulse.z(), 0);
}

TEST(Collision, BodiesThatPartGetNothing)
{
    const Sphere a = sphere(1e-3, 1000, {-1, 0, 0}, Vector::Zero()),
                 b = sphere(1e-3, 1000, Vector::Zero(), Vector::Zero());
    EXPECT_TRUE(collision_impulse(a, b, Vector::UnitX(), {1, 1, 1}).isZero(0));
}
