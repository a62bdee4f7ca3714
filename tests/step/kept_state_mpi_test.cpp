// SPDX-License-Identifier: GPL-3.0-or-later
//
// A coupling step that is made anew, with what the old one kept, goes on to the last bit: books, contacts, pressure,
// watch and counts.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "support/scene.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::Particle;
using test::Scene;
using test::world;

constexpr double cell = 0.01, solid_step = 2e-4;
constexpr int substeps = 5;

std::unique_ptr<Scene> scene()
{
    std::vector<Particle> all;
    for (int n = 0; n < 150; ++n) {
        Particle p;
        p.id = n + 1;
        const double x = 0.5 + 0.5 * std::sin(12.9898 * n), y = 0.5 + 0.5 * std::sin(78.233 * n + 1);
        p.position = Vector(0.2 + 2.6 * x, 0.2 + 2.6 * y, 1 + 5.0 * n / 150) * cell;
        p.velocity = 0.05 * Vector(x - 0.5, y - 0.5, x * y);
        p.diameter = 1e-3 * (1 + x);
        p.density = 900 + 1500 * y;
        p.held = n % 4 == 0;
        all.push_back(p);
    }
    Settings rules;
    rules.forces = {"virtualMass", "saffmanMeiLift"};
    rules.outside_mesh = OutsideMesh::ignore;
    auto made = std::make_unique<Scene>(
        world(),
        test::BoxMesh::Planes{test::even_planes(0, 3 * cell, 3), test::even_planes(0, 3 * cell, 3),
                              test::even_planes(0, 8 * cell, 8)},
        1000, 1e-3, all, Vector(0, 0, -9.81), solid_step, rules);
    made->gas.set_pressure_gradient({20, 0, -9810});
    made->gas.set_body_force({0, 0, -9810});
    made->gas.set_velocity({0.1, -0.05, 0.2});
    return made;
}

TEST(KeptState, LetsARunGoOnToTheLastBit)
{
    const auto whole = scene();
    for (int n = 0; n < 30; ++n)
        whole->advance(substeps);

    const auto before = scene();
    for (int n = 0; n < 12; ++n)
        before->advance(substeps);
    Archive saved;
    before->step.keep(saved);

    const auto after = scene();
    after->particles = before->particles;
    for (std::size_t c = 0; c < after->mesh.view().size(); ++c)
        after->gas.set_velocity(c, before->gas.velocity_in(c));
    Archive loaded = saved.to_load();
    after->step.keep(loaded);
    for (int n = 12; n < 30; ++n)
        after->advance(substeps);

    ASSERT_EQ(after->particles.size(), whole->particles.size());
    for (std::size_t i = 0; i < whole->particles.size(); ++i) {
        EXPECT_EQ(after->particles.velocity(i), whole->particles.velocity(i)) << i;
        EXPECT_EQ(after->particles.position(i), whole->particles.position(i)) << i;
    }
    const auto &books = after->step.ledger().accounts(), &of_whole = whole->step.ledger().accounts();
    for (std::size_t n = 0; n < books.size(); ++n)
        EXPECT_EQ(books[n]->residual(), of_whole[n]->residual()) << books[n]->key();
    EXPECT_EQ(after->step.ledger().momentum.exchanged(), whole->step.ledger().momentum.exchanged());
    const std::vector<Count> counts = after->step.counts(), expected = whole->step.counts();
    for (std::size_t n = 0; n < counts.size(); ++n) {
        EXPECT_EQ(counts[n].number, expected[n].number) << counts[n].kind->key;
        EXPECT_EQ(counts[n].off, expected[n].off) << counts[n].kind->key;
    }
    EXPECT_EQ(after->step.wholes().particle_steps, whole->step.wholes().particle_steps);
    EXPECT_EQ(after->step.wholes().gas_steps, 30);
    EXPECT_EQ(after->step.longest_step(), whole->step.longest_step());
}

/// What is not kept would be missed: without it the run is another.
TEST(KeptState, IsNeeded)
{
    const auto whole = scene(), after = scene();
    for (int n = 0; n < 12; ++n)
        whole->advance(substeps);
    after->particles = whole->particles;
    for (std::size_t c = 0; c < after->mesh.view().size(); ++c)
        after->gas.set_velocity(c, whole->gas.velocity_in(c));
    for (int n = 0; n < 3; ++n) {
        whole->advance(substeps);
        after->advance(substeps);
    }
    EXPECT_GT(after->step.ledger().momentum.residual(), 1e-6);  // nobody knows what was owed and exchanged
}

}  // namespace
