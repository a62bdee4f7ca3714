// SPDX-License-Identifier: GPL-3.0-or-later
//
// One particle falls through gas at rest, from cell to cell and rank to rank: its velocity on the way and at the end is
// that of the equation of motion, for each drag law from Re = 0.1 to 1000, and the error falls with the gas step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "forces/drag/drag_law.hpp"
#include "support/measured.hpp"
#include "support/scene.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::expect_below;
using test::Particle;
using test::Scene;
using test::world;

constexpr double gas_density = 1.2, viscosity = 1.8e-5, particle_density = 1131, g = 9.81;

double drag_factor(const std::string& law, double reynolds) { return find_drag_law(law)->factor({1.0, reynolds}); }

/// A sphere that settles at a given Reynolds number: (pi/6) d^3 (rho_p - rho) g = 3 pi mu d F v with v = Re mu / (rho
/// d).
struct Settling {
    Settling(const std::string& name, double at_reynolds) : law(name), reynolds(at_reynolds)
    {
        const double factor = drag_factor(law, reynolds);
        diameter = std::cbrt(18 * viscosity * viscosity * factor * reynolds /
                             (gas_density * (particle_density - gas_density) * g));
        velocity = reynolds * viscosity / (gas_density * diameter);
        relaxation_time = particle_density * diameter * diameter / (18 * viscosity * factor);
    }

    /// Downward acceleration at a downward velocity v [m/s2].
    double acceleration(double v) const
    {
        const double re = gas_density * std::abs(v) * diameter / viscosity;
        const double rate_per_mass = 18 * viscosity * drag_factor(law, re) / (particle_density * diameter * diameter);
        return g * (1 - gas_density / particle_density) - rate_per_mass * v;
    }

    /// Runge-Kutta of fourth order over `time`, in steps so short that its error is below 1e-9.
    double after(double time, double v) const
    {
        const int steps = 1 + static_cast<int>(std::ceil(200 * time / relaxation_time));
        const double h = time / steps;
        for (int n = 0; n < steps; ++n) {
            const double a = acceleration(v), b = acceleration(v + 0.5 * h * a), c = acceleration(v + 0.5 * h * b);
            v += h / 6 * (a + 2 * b + 2 * c + acceleration(v + h * c));
        }
        return v;
    }

    std::string law;
    double reynolds, diameter, velocity, relaxation_time;
};

/// The particle in a column of gas that is long enough for it. Two-way, cells are so wide (1000 d) that the particle
/// takes less than 1e-9 of them, and the gas is held at rest: it sees the isolated sphere's drag either way.
std::unique_ptr<Scene> drop(const Settling& settling, double fall, double solid_step, bool two_way)
{
    const double cell = 1000 * settling.diameter;
    const int layers = std::max(8, static_cast<int>(std::ceil(fall / cell)) + 2);
    Particle particle;
    particle.position = Vector(1.3 * cell, 1.6 * cell, (layers - 1) * cell);
    particle.diameter = settling.diameter;
    particle.density = particle_density;
    Settings rules;
    rules.drag_law = settling.law;
    rules.two_way = two_way;
    const test::BoxMesh::Planes planes{test::even_planes(0, 3 * cell, 3), test::even_planes(0, 3 * cell, 3),
                                       test::even_planes(0, layers * cell, layers)};
    auto scene = std::make_unique<Scene>(world(), planes, gas_density, viscosity, std::vector<Particle>{particle},
                                         Vector(0, 0, -g), solid_step, rules);
    scene->gas.hold_velocity();
    scene->gas.set_pressure_gradient({0, 0, -gas_density * g});
    return scene;
}

/// Downward [m/s], on all ranks.
double falling(const Scene& scene)
{
    double mine = 0;
    for (std::size_t i = 0; i < scene.particles.size(); ++i)
        mine -= scene.particles.velocity(i).z();
    return world().sum(mine);
}

class EachDragLaw : public testing::TestWithParam<std::string> {};

std::vector<std::string> names_of_laws()
{
    std::vector<std::string> names;
    for (const DragLaw& law : drag_laws())
        names.emplace_back(law.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(, EachDragLaw, testing::ValuesIn(names_of_laws()),
                         [](const auto& test) { return test.param; });

// A law's published range does not matter here: whatever the formula gives is what both sides integrate. The error is
// of first order in the gas step (drag is that of the slip at its start), here a hundredth of the relaxation time:
// below 0.5 %.
TEST_P(EachDragLaw, FallsAsTheEquationOfMotionSays)
{
    if (world().size() > 1 && GetParam() != "BVK") GTEST_SKIP() << "all laws on one rank, one on several";
    double worst = 0;
    for (const double reynolds : {0.1, 1.0, 10.0, 100.0, 300.0, 1000.0}) {
        const Settling settling(GetParam(), reynolds);
        const int substeps = 2, steps = 1200, steps_between_looks = 50;
        const double gas_step = settling.relaxation_time / 100;
        const auto scene = drop(settling, steps * gas_step * settling.velocity, gas_step / substeps, true);
        double exact = 0;
        for (int n = 1; n <= steps; ++n) {
            scene->advance(substeps);
            if (n % steps_between_looks) continue;
            exact = settling.after(steps_between_looks * gas_step, exact);
            const double off = std::abs(falling(*scene) / exact - 1);
            ASSERT_LT(off, 0.005) << "Re = " << reynolds << ", t = " << n / 100.0 << " relaxation times";
            worst = std::max(worst, off);
        }
        EXPECT_NEAR(exact / settling.velocity, 1.0, 1e-3);  // it has arrived; exp(-12) and the jump of a law at Re 1000
        EXPECT_NEAR(falling(*scene) / settling.velocity, 1.0, 0.005) << "Re = " << reynolds;
        EXPECT_LT(scene->step.ledger().momentum.residual(), 1e-12);
    }
    expect_below({GetParam() + ", one sphere at Re 0.1 to 1000: v(t) off the equation of motion", "%",
                  "Runge-Kutta of fourth order"},
                 100 * worst, 0.5);
}

TEST(OneParticle, OneWayIsTheSameFall)
{
    const Settling settling("WenYu", 50.0);
    const int substeps = 2, steps = 300;
    const double gas_step = settling.relaxation_time / 100;
    const auto scene = drop(settling, steps * gas_step * settling.velocity, gas_step / substeps, false);
    for (int n = 0; n < steps; ++n)
        scene->advance(substeps);
    EXPECT_NEAR(falling(*scene) / settling.after(steps * gas_step, 0), 1.0, 0.005);
}

TEST(OneParticle, TheErrorFallsWithTheGasStepInFirstOrder)
{
    const Settling settling("SchillerNaumann", 200.0);
    const double time = settling.relaxation_time;  // midway, where the slip still changes
    const double exact = settling.after(time, 0);
    std::vector<double> errors;
    for (const int steps : {20, 40, 80, 160}) {
        const int substeps = 1600 / steps;  // the solid step stays
        const auto scene = drop(settling, time * settling.velocity, time / 1600, true);
        for (int n = 0; n < steps; ++n)
            scene->advance(substeps);
        errors.push_back(std::abs(falling(*scene) - exact) / settling.velocity);
    }
    double lowest = 10;
    for (std::size_t n = 1; n < errors.size(); ++n)
        lowest = std::min(lowest, std::log2(errors[n - 1] / errors[n]));
    test::expect_above({"one sphere, order in the gas step", "", "first: drag is of the slip at the step's start"},
                       lowest, 0.9);
    EXPECT_LT(errors.back(), 2e-3);
}

TEST(OneParticle, WhereDragIsLinearTheGasStepDoesNotMatter)
{
    // Stokes drag to within 0.15 Re^0.687 = 1e-5: the exact solution over each step, whatever its length
    Settling settling("SchillerNaumann", 1e-6);
    for (const int substeps : {10, 100, 1000}) {
        const double time = settling.relaxation_time;
        const auto scene = drop(settling, time * settling.velocity, time / 1000, true);
        for (int n = 0; n < 1000 / substeps; ++n)
            scene->advance(substeps);
        // the leapfrog's own error: (1e-3)^2 / 12 of the exponential, and the half step without drag at the very start
        EXPECT_NEAR(falling(*scene) / settling.after(time, 0), 1.0, 1e-3) << substeps;
    }
}

TEST(OneParticle, AParcelOfWFallsAsOneOfItsParticles)
{
    const Settling settling("BVK", 100.0);
    const double weight = 8, gas_step = settling.relaxation_time / 100;
    const double cell = 1000 * settling.diameter;
    Particle parcel;
    parcel.position = Vector(1.5 * cell, 1.5 * cell, 7 * cell);
    parcel.diameter = std::cbrt(weight) * settling.diameter;
    parcel.density = particle_density;
    parcel.weight = weight;
    Scene scene(
        world(),
        {test::even_planes(0, 3 * cell, 3), test::even_planes(0, 3 * cell, 3), test::even_planes(0, 8 * cell, 8)},
        gas_density, viscosity, {parcel}, {0, 0, -g}, gas_step / 2, {});
    scene.gas.hold_velocity();
    scene.gas.set_pressure_gradient({0, 0, -gas_density * g});
    for (int n = 0; n < 300; ++n)
        scene.advance(2);
    EXPECT_NEAR(falling(scene) / settling.after(300 * gas_step, 0), 1.0, 0.005);
}

}  // namespace
