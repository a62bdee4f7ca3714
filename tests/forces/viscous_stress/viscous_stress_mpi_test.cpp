// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gas's viscous stress takes a particle along as it takes the gas that the particle displaces.
#include <gtest/gtest.h>

#include <cmath>

#include "support/measured.hpp"
#include "support/scene.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::Particle;
using test::Scene;
using test::world;

TEST(ViscousStress, PushesAParticleByItsVolume)
{
    Particle sphere;
    sphere.position = Vector(0.5, 0.5, 0.5);
    sphere.diameter = 1e-3;
    sphere.density = 2000;
    Settings rules;
    rules.drag_law = "SchillerNaumann";
    rules.forces = {"viscousStress"};
    const double solid_step = 1e-4;
    const Vector per_volume(30, -20, 5);
    Scene scene(world(), {test::even_planes(0, 1, 4), test::even_planes(0, 1, 4), test::even_planes(0, 1, 4)}, 1.2,
                1e-12, {sphere}, Vector::Zero(), solid_step, rules);
    scene.gas.set_viscous_force(per_volume);
    scene.advance(10);
    const auto velocity = [&] {
        Vector mine = Vector::Zero();
        for (std::size_t i = 0; i < scene.particles.size(); ++i)
            mine += scene.particles.velocity(i);
        return world().sum(mine);
    };
    const Vector before = velocity();  // after the first half kick, without gas
    scene.advance(100);
    // drag is none at this viscosity: 2e-8 of the slip in this time
    const Vector expected = 100 * solid_step * per_volume / 2000;
    test::expect_below(
        {"viscous stress: a sphere's velocity after 100 steps, off div tau t/rho_p", "", "closed solution"},
        ((velocity() - before) - expected).norm() / expected.norm(), 1e-6);
    EXPECT_LT(scene.step.ledger().momentum.residual(), 1e-12);
}

}  // namespace
