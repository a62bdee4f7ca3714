// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spheres in liquids, in steps of any length: the start and the way to the terminal velocity of one that rises, and one
// that an accelerated liquid takes along.
#include "forces/virtual_mass/virtual_mass.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "support/measured.hpp"
#include "support/scene.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::Particle;
using test::Scene;
using test::world;

constexpr double g = 9.81, diameter = 1e-3, water = 1000, light = 500;
const double volume = M_PI / 6 * diameter * diameter * diameter;

/// A sphere at rest in a liquid, in cells so wide (1000 d) that it takes less than 1e-9 of them. Drag is Stokes', of
/// the sphere alone.
std::unique_ptr<Scene> released(double viscosity, double density, double solid_step, const Vector& gravity)
{
    const double cell = 1000 * diameter;
    Particle sphere;
    sphere.position = Vector(1.3, 1.6, 1.5) * cell;
    sphere.diameter = diameter;
    sphere.density = density;
    Settings rules;
    rules.drag_law = "SchillerNaumann";
    rules.forces = {"virtualMass"};
    const auto planes = test::even_planes(0, 4 * cell, 4);
    return std::make_unique<Scene>(world(), test::BoxMesh::Planes{planes, planes, planes}, water, viscosity,
                                   std::vector<Particle>{sphere}, gravity, solid_step, rules);
}

Vector velocity_in(const Scene& scene)
{
    Vector mine = Vector::Zero();
    for (std::size_t i = 0; i < scene.particles.size(); ++i)
        mine += scene.particles.velocity(i);
    return world().sum(mine);
}

/// 500 kg/m3 in water: (1000 - 500) g/(500 + 1000/2) = g/2, and from there towards the terminal velocity with the
/// relaxation time (m + m')/k. The liquid is so viscous that Re stays below 1e-3, where Schiller and Naumann add
/// 0.15 Re^0.687 = 0.1 % to Stokes.
TEST(VirtualMass, ALightSphereRisesAsTheClosedSolutionSays)
{
    const double viscosity = 20, added = 0.5 * water * volume, mass = light * volume;
    const double k = 3 * M_PI * viscosity * diameter, tau = (mass + added) / k;
    const double terminal = (water - light) * volume * g / k;
    double worst = 0;
    for (const int substeps : {1, 10, 100, 1000}) {  // gas steps of 2e-4 to 0.2 tau
        const double solid_step = 2e-4 * tau;
        const auto scene = released(viscosity, light, solid_step, {0, 0, -g});
        scene->gas.hold_velocity();
        scene->gas.set_pressure_gradient({0, 0, -water * g});
        for (int n = 1; n <= 15000 / substeps; ++n) {
            scene->advance(substeps);
            const double time = n * substeps * solid_step;
            if (time < 0.1 * tau) continue;  // LIGGGHTS's first half kick is by the weight alone: 0.3 % at this time
            const double exact = terminal * (1 - std::exp(-time / tau));
            const double off = std::abs(velocity_in(*scene).z() / exact - 1);
            ASSERT_LT(off, 0.01) << substeps << " substeps, t = " << time / tau << " tau";
            worst = std::max(worst, off);
        }
        EXPECT_LT(scene->step.ledger().momentum.residual(), 1e-12);
    }
    test::expect_below({"virtual mass: 500 kg/m3 rising in water, v(t) off the closed solution, gas steps of 2e-4 to "
                        "0.2 relaxation times",
                        "%", "exponential approach with m + m_liquid/2"},
                       100 * worst, 1);
}

TEST(VirtualMass, ALightSphereStartsWithHalfOfGravity)
{
    const double solid_step = 1e-5;
    const auto scene = released(1e-6, light, solid_step, {0, 0, -g});  // drag is none
    scene->gas.hold_velocity();
    scene->gas.set_pressure_gradient({0, 0, -water * g});
    scene->advance(10);
    const Vector before = velocity_in(*scene);  // after the first half kick, by the weight alone
    scene->advance(100);
    test::expect_within({"virtual mass: the same at its release", "m/s2", "g/2"},
                        (velocity_in(*scene) - before).z() / (100 * solid_step), 4.905, 0.01 * 4.905);
}

/// Without drag and gravity a liquid of acceleration a takes a sphere along by (1 + C) rho/(rho_p + C rho) of it:
/// faster than itself where the sphere is lighter (G. I. Taylor's limit, 3 for a bubble).
TEST(VirtualMass, AnAcceleratedLiquidTakesASphereAlong)
{
    double worst = 0;
    for (const double density : {10.0, 500.0, 1000.0, 8000.0})
        for (const int substeps : {1, 50}) {
            const double solid_step = 1e-5, acceleration = 2;
            const auto scene = released(1e-9, density, solid_step, Vector::Zero());
            scene->gas.set_pressure_gradient({-water * acceleration, 0, 0});
            for (int n = 0; n < 200 / substeps; ++n)
                scene->advance(substeps);
            const double liquid = acceleration * 200 * solid_step;
            const double expected = 1.5 * water / (density + 0.5 * water) * liquid;
            worst = std::max(worst, std::abs(velocity_in(*scene).x() / expected - 1));
            EXPECT_LT(scene->step.ledger().momentum.residual(), 1e-12);
        }
    // the last kick of velocity Verlet is half made at the end: 1/400; the rest is the gas step's half
    test::expect_below({"virtual mass: spheres of 10 to 8000 kg/m3 in accelerated water, velocity off 3/2 rho/(rho_p + "
                        "rho/2) of the water's",
                        "%", "G. I. Taylor's limit"},
                       100 * worst, 1);
}

TEST(VirtualMass, FollowsTheLiquidWhereItsVelocityChangesAlongTheWay)
{
    ParticleInGas at;
    at.gas_velocity = Vector(2, 1, 0);
    at.density = water;
    at.volume = volume;
    at.velocity_gradient(0, 0) = 3;   // du_x/dx
    at.velocity_gradient(1, 2) = -4;  // du_z/dy
    Response response;
    VirtualMass().act(at, response);
    const double displaced = 0.5 * water * volume;
    EXPECT_DOUBLE_EQ(response.added_mass, displaced);
    EXPECT_DOUBLE_EQ(response.gas_mass, displaced);
    EXPECT_LT((response.force - displaced * Vector(6, 0, -4)).norm(), 1e-12 * displaced);  // u.grad u
}

}  // namespace
