// SPDX-License-Identifier: GPL-3.0-or-later
//
// Particles that come and go in a coupling step: who they were is known and counted by cause, and gas gives way to
// their volume, or takes its place, without being asked to flow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/sphere.hpp"
#include "base/user_error.hpp"
#include "support/methods.hpp"
#include "support/scene.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::Particle;
using test::Scene;
using test::world;

constexpr double cell = 0.01, diameter = 3e-3, solid_step = 1e-4, gas_density = 1.2;
constexpr int substeps = 5;
const Vector gas_velocity(0.1, 0, 1.5);

Particle sphere(int id, const Vector& in_cells)
{
    Particle p;
    p.id = id;
    p.position = cell * in_cells;
    p.diameter = diameter;
    p.held = true;  // so that solids change by coming and going alone
    return p;
}

std::vector<Particle> some(int count)
{
    std::vector<Particle> all;
    for (int n = 0; n < count; ++n)
        all.push_back(sphere(n + 1, {0.5 + 0.4 * (n % 7), 0.4 + 0.5 * (n % 5), 0.5 + 7.0 * n / count}));
    return all;
}

std::unique_ptr<Scene> scene(const std::vector<Particle>& all, const Settings& rules = {})
{
    const test::BoxMesh::Planes planes{test::even_planes(0, 3 * cell, 3), test::even_planes(0, 3 * cell, 3),
                                       test::even_planes(0, 8 * cell, 8)};
    auto made =
        std::make_unique<Scene>(world(), planes, gas_density, 1.8e-5, all, Vector(0, 0, -9.81), solid_step, rules);
    made->gas.set_velocity(gas_velocity);
    made->gas.hold_velocity();
    return made;
}

/// What the gas is asked to let out in a step beside what it was asked `before`, in the cell where that is most, as a
/// share of the cell.
double largest_surplus(const Scene& s, const Scalars& before = {})
{
    double largest = 0;
    for (std::size_t c = 0; c < s.gas.surplus().size(); ++c) {
        const double more = s.gas.surplus()[c] - (before.empty() ? 0.0 : before[c]);
        largest = std::max(largest, std::abs(more) * substeps * solid_step);
    }
    return world().max(largest);
}

void expect_closed(const Scene& s)
{
    for (const Account* account : s.step.ledger().accounts())
        EXPECT_LT(account->residual(), 1e-12) << account->key();  // round-off
}

const double volume = sphere_volume(diameter / 2);

TEST(Population, WhatIsInsertedDisplacesGasWhereItIs)
{
    const auto s = scene(some(40));
    s->advance(substeps);
    // made during a step, it is mapped in the next one
    if (world().rank() == world().size() - 1)
        for (int n = 0; n < 20; ++n)
            s->particles.insert_next(sphere(100 + n, {0.3 + 0.12 * n, 1.5, 4.2}));
    s->advance(substeps);
    EXPECT_EQ(s->step.population().inserted.particles, 20);
    for (int n = 0; n < 2; ++n) {
        s->advance(substeps);
        EXPECT_LT(largest_surplus(*s), 1e-14);
        expect_closed(*s);
    }
    const PopulationTotals all = s->step.population();
    EXPECT_NEAR(all.inserted.volume, 20 * volume, 1e-12 * volume);
    EXPECT_NEAR(all.gas_displaced.volume, 20 * volume, 1e-12 * volume);
    EXPECT_LT((to_vector(all.gas_displaced.momentum) - gas_density * 20 * volume * gas_velocity).norm(),
              1e-12 * volume);
    EXPECT_EQ(all.gas_restored.volume, 0);
    EXPECT_EQ(s->counted("cells_pushed"), 0);
}

TEST(Population, WhatIsRemovedLeavesGasWhereItWas)
{
    for (const Exit exit : {Exit::mesh, Exit::script}) {
        const auto s = scene(some(40));
        s->particles.allow_removal(exit);
        for (int n = 1; n <= 10; ++n) {
            s->particles.remove_next(3 * n);
            s->advance(substeps);
            expect_closed(*s);
            EXPECT_LT(largest_surplus(*s), 1e-14);
        }
        const PopulationTotals all = s->step.population();
        const Passage& way = exit == Exit::mesh ? all.deleted_by_mesh : all.deleted_by_script;
        EXPECT_EQ(way.particles, 10);
        EXPECT_EQ(all.went(), 10);
        EXPECT_NEAR(way.volume, 10 * volume, 1e-12 * volume);
        EXPECT_NEAR(all.gas_restored.volume, 10 * volume, 1e-12 * volume);
    }
}

TEST(Population, InThePackingLimitToo)
{
    Settings rules;
    rules.mapping.maximum_packing = 0.12;
    auto all = some(40);
    for (int n = 0; n < 12; ++n)
        all.push_back(sphere(50 + n, {1.3 + 0.03 * n, 1.5, 4.5}));  // a heap beyond the limit
    const auto s = scene(all, rules);
    s->particles.allow_removal();
    for (int n = 0; n < 6; ++n) {
        s->particles.remove_next(50 + n);
        if (world().is_master()) s->particles.insert_next(sphere(80 + n, {1.4 + 0.02 * n, 1.5, 4.5}));
        s->advance(substeps);
        expect_closed(*s);
    }
    EXPECT_GT(s->counted("cells_relieved"), 0);
}

TEST(Population, WhoLeavesTheMeshAndComesBackIsCountedAndJoltsNothing)
{
    Settings rules;
    rules.outside_mesh = OutsideMesh::ignore;
    auto all = some(40);
    for (int n = 0; n < 10; ++n) {
        Particle& p = all[static_cast<std::size_t>(n)];
        p.held = false;
        p.position.z() = (7.95 - 0.01 * n) * cell;
        p.velocity.z() = 0.3;  // up and out, and back with gravity
    }
    const auto s = scene(all, rules);
    const double moving = 0.3 * substeps * solid_step / cell;  // share of a cell that a sphere crosses in a step
    for (int n = 0; n < 200; ++n) {
        const Scalars before = s->gas.surplus();  // nothing flows in this gas, so what is asked for adds up
        s->advance(substeps);
        expect_closed(*s);
        // ten spheres that move ask for room by the way that they make; one that vanished would ask for 2 to 6 times
        // this
        EXPECT_LT(largest_surplus(*s, before), 10 * moving * volume / std::pow(cell, 3)) << n;
    }
    const PopulationTotals found = s->step.population();
    EXPECT_EQ(found.left_gas_mesh.particles, 10);
    EXPECT_NEAR(found.gas_restored.volume - found.gas_displaced.volume,
                (found.left_gas_mesh.particles - found.entered_gas_mesh.particles) * volume, 1e-11 * volume);
}

TEST(Population, CellsThatAreTooFullForWhatIsInsertedAreCounted)
{
    auto all = some(40);
    for (int n = 0; n < 40; ++n)
        all.push_back(sphere(50 + n, {1.5, 1.5, 4.5}));
    const auto s = scene(all);
    s->advance(substeps);
    if (world().is_master())
        for (int n = 0; n < 40; ++n)
            s->particles.insert_next(sphere(100 + n, {1.5, 1.5, 4.5}));
    for (int n = 0; n < 3; ++n) {
        s->advance(substeps);
        expect_closed(*s);
    }
    EXPECT_GT(s->counted("cells_pushed"), 0);
}

std::string message_of(Scene& s)
{
    try {
        s.advance(substeps);
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

TEST(Population, TwoThatComeDoNotHideOneThatIsLost)
{
    const auto s = scene(some(40));
    EXPECT_EQ(message_of(*s), "");
    if (world().is_master())
        for (int id : {101, 102})
            s->particles.insert_next(sphere(id, {1.5, 1.5, 3}));
    s->particles.remove_next(17);  // without a word
    const std::string message = message_of(*s);
    EXPECT_NE(message.find("1 of 40 particles were lost"), std::string::npos) << message;
    EXPECT_NE(message.find("particle 17 "), std::string::npos) << message;
}

TEST(Population, TheBoundaryIsAWayOutWhereTheSceneSaysSo)
{
    for (const OutsideMesh rule : {OutsideMesh::ignore, OutsideMesh::stop}) {
        Settings rules;
        rules.outside_mesh = rule;
        const auto s = scene(some(40), rules);
        s->particles.allow_removal(Exit::boundary);
        s->particles.remove_next(17);
        const std::string message = message_of(*s);
        if (rule == OutsideMesh::ignore) {
            EXPECT_EQ(message, "");
            EXPECT_EQ(s->step.population().left_through_boundary.particles, 1);
        } else {
            EXPECT_NE(message.find("1 of 40 particles were lost"), std::string::npos) << message;
            EXPECT_NE(message.find("outsideMesh ignore"), std::string::npos) << message;
        }
    }
}

TEST(Population, WhoComesAndGoesInOneStepIsCountedTwice)
{
    const auto s = scene(some(40));
    s->particles.allow_removal();
    if (world().is_master()) s->particles.insert_next(sphere(101, {1.5, 1.5, 3}));
    s->particles.remove_next(101);
    EXPECT_EQ(message_of(*s), "");
    EXPECT_EQ(s->step.population().inserted.particles, 1);
    EXPECT_EQ(s->step.population().deleted_by_mesh.particles, 1);
    s->advance(substeps);
    expect_closed(*s);
    EXPECT_EQ(s->step.population().gas_displaced.volume, 0);
}

TEST(Population, ParcelsAmongRealParticlesAreRefused)
{
    for (const Method& method : {test::springs(), test::impulses(), test::parcels()}) {
        Settings rules;
        rules.method = method;
        const auto s = scene(some(40), rules);
        Particle parcel = sphere(101, {1.5, 1.5, 3});
        parcel.weight = 8;
        if (world().is_master()) s->particles.insert_next(parcel);
        EXPECT_EQ(message_of(*s).find("with a weight of 8") != std::string::npos, !method.tracks_parcels);
    }
}

}  // namespace
