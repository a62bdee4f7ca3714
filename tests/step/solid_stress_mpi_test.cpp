// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a collision model with a stress of the solids gets: the stress's gradient on the gas mesh, solid fraction and
// mean velocity where each particle is, whichever rank it lives on. And nothing of it is sent where none asks.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "base/user_error.hpp"
#include "momentum/drag_response.hpp"
#include "support/scene.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::Particle;
using test::Scene;
using test::world;

constexpr double cell = 0.01, diameter = 2e-3, solid_step = 1e-4;
constexpr double stiffness = 50;  // Pa
const Vector gravity(0, 0, -9.81);

/// tau = stiffness * solid fraction: its gradient is as well known as that of the solid fraction.
class LinearStress : public SolidStress {
public:
    explicit LinearStress(double packing = 0.6) : packing_(packing) {}
    double stress(double solid_fraction) const override { return stiffness * solid_fraction; }
    double close_packing() const override { return packing_; }
    bool refuses_overfilled_start() const override { return true; }
    StressState* states() override
    {
        states_.resize(1000);
        return states_.data();
    }
    StepTooLong begin(double gas_step) override
    {
        gas_step_ = gas_step;
        return {1, 2};
    }
    const char* complaint() const override { return refuses_ ? "no step\n  remedy: none" : nullptr; }
    void refuse() { refuses_ = true; }
    const StressState& operator[](std::size_t i) const { return states_[i]; }
    double gas_step() const { return gas_step_; }

private:
    double packing_;
    std::vector<StressState> states_;
    double gas_step_ = 0;
    bool refuses_ = false;
};

test::BoxMesh::Planes planes()
{
    return {test::even_planes(0, 4 * cell, 4), test::even_planes(0, 4 * cell, 4), test::even_planes(0, 12 * cell, 12)};
}

/// `layers[k]` particles evenly in each cell of layer k.
std::vector<Particle> stack(const std::vector<int>& layers)
{
    std::vector<Particle> all;
    for (std::size_t k = 0; k < layers.size(); ++k)
        for (int n = 0; n < layers[k]; ++n)
            for (int i = 0; i < 4; ++i)
                for (int j = 0; j < 4; ++j) {
                    Particle p;
                    p.id = static_cast<int>(all.size()) + 1;
                    p.diameter = diameter;
                    p.position = cell * Vector(i + 0.5, j + 0.5, static_cast<double>(k) + (n + 0.5) / layers[k]);
                    all.push_back(p);
                }
    return all;
}

Settings rules(bool two_way = true)
{
    Settings settings;
    settings.mapping.type = MappingType::cell_centre;
    settings.two_way = two_way;
    return settings;
}

double solid_fraction(int particles) { return particles * M_PI / 6 * std::pow(diameter / cell, 3); }

TEST(SolidStress, GradientIsThatOfTheStressAndNoneWhereTheBedIsUniform)
{
    const std::vector<int> layers{3, 3, 3, 3, 1, 1, 2, 2, 2, 2, 2, 2};
    for (const bool two_way : {true, false}) {
        LinearStress model;
        Scene s(world(), planes(), 1.2, 1.8e-5, stack(layers), gravity, solid_step, rules(two_way), &model);
        std::vector<Vector> start;
        for (std::size_t i = 0; i < s.particles.size(); ++i)
            start.push_back(s.particles.position(i));
        s.advance(1);
        EXPECT_EQ(model.gas_step(), solid_step);
        for (std::size_t i = 0; i < s.particles.size(); ++i) {
            const int k = static_cast<int>(start[i].z() / cell);
            const int below = layers[static_cast<std::size_t>(std::max(k - 1, 0))],
                      above = layers[static_cast<std::size_t>(std::min(k + 1, 11))];
            const double expected = stiffness * (solid_fraction(above) - solid_fraction(below)) / (2 * cell);
            const StressState& state = model[i];
            const Vector difference = to_vector(state.gradient) - Vector(0, 0, expected);
            // round-off of the solid volumes, relative to the gradient of one particle
            EXPECT_LT(difference.norm(), 1e-12 * stiffness * solid_fraction(1) / cell) << "layer " << k;
            EXPECT_NEAR(state.solid_fraction, solid_fraction(layers[static_cast<std::size_t>(k)]), 1e-14);
            EXPECT_NEAR(state.cell_size[0], cell, 1e-15);
            EXPECT_GT(state.relaxation_time, 0);
        }
    }
}

TEST(SolidStress, MeanVelocityIsWeightedByMass)
{
    // three particles in each cell of one layer: two at 1 m/s, one of eight times the mass at -1 m/s
    std::vector<Particle> all = stack({0, 0, 0, 0, 0, 3});
    for (std::size_t n = 0; n < all.size(); ++n) {
        const bool heavy = n < 16;
        all[n].velocity = Vector(heavy ? -1 : 1, 0, heavy ? 0 : 0.5);
        if (heavy) all[n].diameter *= 2;
    }
    LinearStress model;
    Scene s(world(), planes(), 1.2, 1.8e-5, all, gravity, solid_step, rules(), &model);
    s.advance(1);
    for (std::size_t i = 0; i < s.particles.size(); ++i)
        EXPECT_LT((to_vector(model[i].mean_velocity) - Vector(-0.6, 0, 0.1)).norm(), 1e-14);
}

TEST(SolidStress, RelaxationTimeIsThatOfTheRealParticles)
{
    // parcels of 1, 8 and 2.5 of the same particles in each cell of one layer, at rest in gas of 2 m/s
    std::vector<Particle> all = stack({0, 0, 0, 0, 0, 3});
    const double weights[] = {1, 8, 2.5};
    double solids = 0;
    for (std::size_t n = 0; n < all.size(); ++n) {
        Particle& p = all[n];
        p.weight = weights[n / 16];
        p.diameter = 1e-3 * std::cbrt(p.weight);
        if (n % 16 == 0) solids += M_PI / 6 * std::pow(p.diameter, 3);
    }
    LinearStress model;
    Settings of_law = rules();
    of_law.self_disturbance = false;  // the law's own rate, of the slip that is seen
    Scene s(world(), planes(), 1.2, 1.8e-5, all, Vector::Zero(), solid_step, of_law, &model);
    s.gas.set_velocity({0, 0, 2});
    s.advance(1);
    const double eps = 1 - solids / std::pow(cell, 3);
    const double expected = all[0].density / drag_rate_per_volume(*find_drag_law("BVK"), eps, 2, 1e-3, 1.2, 1.8e-5);
    for (std::size_t i = 0; i < s.particles.size(); ++i)
        EXPECT_NEAR(model[i].relaxation_time / expected, 1, 1e-12);
}

TEST(SolidStress, WhatMovesTogetherIsItsOwnMean)
{
    // also with a kernel that spreads particles over cells, where the mean is one of cells
    std::vector<Particle> all = stack({0, 0, 4, 1, 3, 0, 2});
    for (Particle& p : all)
        p.velocity = Vector(0.3, -0.2, 0.1);
    Settings spread = rules();
    spread.mapping.type = MappingType::kernel;
    LinearStress model;
    Scene s(world(), planes(), 1.2, 1.8e-5, all, gravity, solid_step, spread, &model);
    s.advance(1);
    for (std::size_t i = 0; i < s.particles.size(); ++i)
        EXPECT_LT((to_vector(model[i].mean_velocity) - Vector(0.3, -0.2, 0.1)).norm(), 1e-14);
}

TEST(SolidStress, LeavesTheBooksBalancedAndCounts)
{
    LinearStress model;
    Scene s(world(), planes(), 1.2, 1.8e-5, stack({3, 3, 1, 1, 2}), gravity, solid_step, rules(), &model);
    for (int n = 0; n < 20; ++n)
        s.advance(2);
    EXPECT_LT(s.step.ledger().momentum.residual(), 1e-12);  // round-off
    EXPECT_LT(s.step.ledger().solid_volume.residual(), 1e-12);
    EXPECT_EQ(s.counted("cells_beyond_close_packing"), 0);
    EXPECT_EQ(s.counted("step_crosses_cells"), 20 * world().size());
    EXPECT_EQ(s.counted("step_beyond_relaxation"), 40 * world().size());
}

/// Holds every particle at rest against whatever it would do, as a stress may: half of it is enough to see it booked.
class HoldingStress : public LinearStress {
public:
    StepTooLong begin(double gas_step) override
    {
        const StepTooLong found = LinearStress::begin(gas_step);
        for (StressState* state = states(); state != states() + 100; ++state)
            state->change[2] = given_;
        return found;
    }
    void give(double change) { given_ = change; }

private:
    double given_ = 0;
};

TEST(SolidStress, WhatDragGivesBackOfItIsTakenFromTheGas)
{
    // particles all alike, step of some relaxation times: the fluid's impulse differs by what drag gives back of the
    // stress's, and the books stay closed
    const auto taken = [](double change) {
        HoldingStress model;
        model.give(change);
        Scene s(world(), planes(), 1.2, 18, stack({1, 1, 1, 1}), gravity, solid_step, rules(), &model);
        s.gas.hold_velocity();
        s.advance(2);
        EXPECT_LT(s.step.ledger().momentum.residual(), 1e-12);
        Vector booked = Vector::Zero();
        const ParticleView view = s.particles.particles();
        for (std::size_t i = 0; i < view.size(); ++i)
            booked += solid_step * view.booked_force(i);
        return std::pair(world().sum(booked).z(), model[0].relaxation_time);
    };
    const auto [without, relaxation_time] = taken(0.0);
    const double change = 1e-3, mass = 64 * 1000 * M_PI / 6 * std::pow(diameter, 3), x = solid_step / relaxation_time;
    EXPECT_NEAR((taken(change).first - without) / (-withheld_share(x) / relaxed_share(x) * mass * change), 1, 1e-9);
}

TEST(SolidStress, IsNotSentWhereNoneAsks)
{
    const auto sent = [](SolidStress* model, bool two_way) {
        Scene s(world(), planes(), 1.2, 1.8e-5, stack({3, 3, 1, 1, 2}), gravity, solid_step, rules(two_way), model);
        s.advance(1);
        return static_cast<long>(s.step.bytes_sent());
    };
    LinearStress model;
    if (world().size() == 1) {
        // the particles' gas cells are all at home: with a stress or without, nothing travels
        EXPECT_EQ(sent(&model, true), 0);
        EXPECT_EQ(sent(nullptr, true), 0);
        return;
    }
    EXPECT_GT(world().sum(sent(&model, true)), world().sum(sent(nullptr, true)));
    EXPECT_GT(world().sum(sent(&model, false)), world().sum(sent(nullptr, false)));
}

TEST(SolidStress, AComplaintOfOneRankStopsAll)
{
    LinearStress model;
    if (world().rank() == world().size() - 1) model.refuse();
    Scene s(world(), planes(), 1.2, 1.8e-5, stack({1, 1}), gravity, solid_step, rules(), &model);
    EXPECT_THROW(s.advance(1), UserError);
}

TEST(SolidStress, ClosingSpeedIsThatOfTheMeanMotionTowardsWhatLiesAhead)
{
    // a stack of four layers on the floor, all falling at 2 m/s: the lowest meets the floor, the others their like, and
    // the highest has empty cells above, which say nothing
    std::vector<Particle> all = stack({3, 3, 3, 3});
    for (Particle& p : all)
        p.velocity = Vector(0, 0, -2);
    LinearStress model;
    Scene s(world(), planes(), 1.2, 1.8e-5, all, gravity, solid_step, rules(), &model);
    std::vector<int> layers;
    for (std::size_t i = 0; i < s.particles.size(); ++i)
        layers.push_back(static_cast<int>(s.particles.position(i).z() / cell));
    s.advance(1);
    for (std::size_t i = 0; i < layers.size(); ++i)
        EXPECT_LT((to_vector(model[i].closing_speed) - Vector(0, 0, layers[i] == 0 ? 2 : 0)).norm(), 1e-12)
            << layers[i];
}

TEST(SolidStress, AnOverfilledStartIsRefusedAndNamesTheCell)
{
    LinearStress model(0.5 * solid_fraction(5));
    Scene s(world(), planes(), 1.2, 1.8e-5, stack({1, 1, 5}), gravity, solid_step, rules(), &model);
    try {
        s.advance(1);
        FAIL() << "a cell at twice close packing was taken";
    } catch (const UserError& error) {
        const std::string words = error.what();
        EXPECT_NE(words.find("beyond close packing at the start"), std::string::npos) << words;
        EXPECT_NE(words.find("0.025"), std::string::npos) << words;  // the height of the layer
    }
}

}  // namespace
