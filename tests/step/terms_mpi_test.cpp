// SPDX-License-Identifier: GPL-3.0-or-later
//
// No interphase term opens the books, alone or with all others, in gas steps of a thousandth to a hundred relaxation
// times, on any number of ranks; and what terms and drag laws look at is what is there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "forces/terms.hpp"
#include "support/measured.hpp"
#include "support/scene.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::alone;
using test::Particle;
using test::Scene;
using test::world;

constexpr double cell = 0.01;

/// Spheres of several sizes, densities and weights in a liquid; every fifth is held.
std::vector<Particle> crowd()
{
    std::mt19937 random(11);
    const auto uniform = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::vector<Particle> all;
    for (int n = 0; n < 200; ++n) {
        Particle p;
        p.id = n + 1;
        p.position = Vector(uniform(0.3, 3.7), uniform(0.3, 2.7), uniform(1.5, 6.5)) * cell;
        p.velocity = Vector(uniform(-0.1, 0.1), uniform(-0.1, 0.1), uniform(-0.1, 0.1));
        p.diameter = uniform(1e-3, 3e-3);
        p.density = uniform(200, 3000);
        p.weight = 1 + 2.5 * (n % 3);
        p.held = n % 5 == 0;
        all.push_back(p);
    }
    return all;
}

struct Case {
    std::vector<std::string> forces;
    std::string law = "BVK";
    double viscosity = 1e-3, gas_step = 1e-3;
    int steps = 20;
};

std::unique_ptr<Scene> made(const Communicator& comm, const Case& of)
{
    constexpr int substeps = 4;
    Settings rules;
    rules.forces = of.forces;
    rules.drag_law = of.law;
    rules.outside_mesh = OutsideMesh::ignore;
    auto scene = std::make_unique<Scene>(
        comm,
        test::BoxMesh::Planes{test::even_planes(0, 4 * cell, 4), test::graded_planes(0, 3 * cell, 3, 1.3),
                              test::even_planes(0, 8 * cell, 8)},
        1000, of.viscosity, crowd(), Vector(0, 0, -9.81), of.gas_step / substeps, rules);
    for (std::size_t c = 0; c < scene->mesh.view().size(); ++c) {
        const auto n = static_cast<double>(scene->mesh.global_number(c));
        scene->gas.set_velocity(c, 0.1 * Vector(std::sin(n), std::cos(n), std::sin(2 * n)));
    }
    Eigen::Matrix3d gradient;
    gradient << 3, -20, 8, 15, -1, 4, -6, 9, -2;
    scene->gas.set_velocity_gradient(gradient);
    scene->gas.set_viscous_force({40, -30, 20});
    scene->gas.set_pressure_gradient({100, -50, -9810});
    scene->gas.set_body_force({0, 0, -9810});
    for (int n = 0; n < of.steps; ++n)
        scene->advance(substeps);
    return scene;
}

/// Round-off of some ten steps, relative to the impulse exchanged.
constexpr double balance = 1e-12;

/// Returns the imbalance of momentum.
double expect_closed_books(const Case& of)
{
    const auto scene = made(world(), of);
    std::string names = of.law;
    for (const std::string& name : of.forces)
        names += " " + name;
    EXPECT_GT(scene->step.ledger().momentum.exchanged(), 0);
    EXPECT_LT(scene->step.ledger().momentum.residual(), balance) << names << ", gas step " << of.gas_step << " s";
    EXPECT_LT(scene->step.ledger().solid_volume.residual(), balance) << names;
    return scene->step.ledger().momentum.residual();
}

TEST(Terms, EachKeepsTheBooksClosed)
{
    for (const std::string& name : names_of_optional_terms())
        expect_closed_books({{name}});
}

TEST(Terms, AllOfThemKeepTheBooksClosedAtAnyStep)
{
    // the relaxation time of the mean sphere is 2e-4 s/(viscosity in Pa s), by Stokes
    double worst = 0;
    for (const double x : {1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0})
        worst = std::max(worst, expect_closed_books({names_of_optional_terms(), "BVK", 0.2 * x}));
    test::expect_below({"drag, virtual mass, lift and viscous stress together, gas step of 1e-3 to 100 relaxation "
                        "times: imbalance of momentum",
                        "", "conservation"},
                       worst, balance);
}

TEST(Terms, WithEveryDragLawToo)
{
    for (const DragLaw& law : drag_laws())
        expect_closed_books({names_of_optional_terms(), std::string(law.name)});
}

TEST(Terms, DoNotDependOnTheRanks)
{
    for (const std::string law : {"BVK", "BVKPolydisperse", "RadlSundaresan"}) {
        const Case of{names_of_optional_terms(), law, 1e-2, 2e-3, 10};
        const auto many = made(world(), of), one = made(alone(), of);
        Scalars velocities(3 * 201, 0.0);
        for (std::size_t i = 0; i < many->particles.size(); ++i)
            set_vector_at(velocities, static_cast<std::size_t>(many->particles.id(i)), many->particles.velocity(i));
        world().sum(velocities);
        for (std::size_t i = 0; i < one->particles.size(); ++i) {
            const Vector expected = one->particles.velocity(i);
            const Vector there = vector_at(velocities, static_cast<std::size_t>(one->particles.id(i)));
            // FluidForce is in single precision, and sums over cells have another order
            EXPECT_LT((there - expected).norm(), 1e-5 * (0.01 + expected.norm()))
                << law << ", " << one->particles.id(i);
        }
    }
}

/// The drag rate over a particle's mass, from the share of the slip that one short step takes away [1/s].
double relaxation(const Scene& scene, int id, const Vector& slip, double time)
{
    double mine = 0;
    for (std::size_t i = 0; i < scene.particles.size(); ++i)
        if (scene.particles.id(i) == id) mine = scene.particles.velocity(i).norm() / (slip.norm() * time);
    return world().sum(mine);
}

std::unique_ptr<Scene> at_rest_in_flow(const std::vector<Particle>& all, const std::string& law, const Vector& u,
                                       double solid_step)
{
    Settings rules;
    rules.drag_law = law;
    rules.mapping.type = MappingType::cell_centre;
    rules.self_disturbance = false;  // this gas does not give way
    auto scene =
        std::make_unique<Scene>(world(),
                                test::BoxMesh::Planes{test::even_planes(0, cell, 1), test::even_planes(0, cell, 1),
                                                      test::even_planes(0, 4 * cell, 4)},
                                1.2, 1.8e-5, all, Vector::Zero(), solid_step, rules);
    scene->gas.set_velocity(u);
    scene->gas.hold_velocity();
    return scene;
}

/// Two sizes in one cell: each feels its own share of the mixture's drag, of d over the Sauter mean.
TEST(DragLaws, SeeTheMeanDiameterAround)
{
    std::vector<Particle> all;
    double volume = 0, per_diameter = 0;
    for (int n = 0; n < 60; ++n) {
        Particle p;
        p.id = n + 1;
        p.position = Vector(0.5, 0.5, 1.5) * cell;  // point particles: only the volumes count
        p.diameter = n % 3 == 0 ? 2e-3 : 1e-3;
        p.density = 5000;
        all.push_back(p);
        const double v = M_PI / 6 * std::pow(p.diameter, 3);
        volume += v;
        per_diameter += v / p.diameter;
    }
    const double mean = volume / per_diameter, eps = 1 - volume / std::pow(cell, 3);
    const Vector u(0.5, 0, 0);
    const double step = 1e-7;  // the velocity that half a kick leaves is 1e-5 of the slip
    const auto scene = at_rest_in_flow(all, "BVKPolydisperse", u, step);
    scene->advance(1);
    scene->advance(1);
    for (const int id : {1, 2}) {
        const double d = all[static_cast<std::size_t>(id - 1)].diameter;
        DragState state;
        state.diameter_ratio = d / mean;
        const double rate =
            drag_rate_per_volume(*find_drag_law("BVKPolydisperse"), eps, u.norm(), d, 1.2, 1.8e-5, state) / 5000;
        // two steps, of which the first begins with half a kick without gas
        EXPECT_NEAR(relaxation(*scene, id, u, 1.5 * step) / rate, 1, 1e-3) << d;
    }
}

/// In the gas of each cell another viscosity: Stokes drag is proportional to it.
TEST(DragLaws, SeeTheGasOfTheirCell)
{
    std::vector<Particle> all;
    for (int n = 0; n < 4; ++n) {
        Particle p;
        p.id = n + 1;
        p.position = Vector(0.5, 0.5, n + 0.5) * cell;
        p.diameter = 1e-5;
        p.density = 2000;
        all.push_back(p);
    }
    const Vector u(1e-6, 0, 0);
    const double step = 1e-8;
    const auto scene = at_rest_in_flow(all, "SchillerNaumann", u, step);
    Scalars densities, viscosities;
    for (std::size_t c = 0; c < scene->mesh.view().size(); ++c) {
        viscosities.push_back(1e-5 * (1 + static_cast<double>(scene->mesh.global_number(c))));
        densities.push_back(1);
    }
    scene->gas.set_properties(densities, viscosities);
    scene->advance(1);
    scene->advance(1);
    for (int n = 0; n < 4; ++n) {
        const double rate = 18 * 1e-5 * (1 + n) / (2000 * 1e-10);
        EXPECT_NEAR(relaxation(*scene, n + 1, u, 1.5 * step) / rate, 1, 1e-3) << n;
    }
}

}  // namespace
