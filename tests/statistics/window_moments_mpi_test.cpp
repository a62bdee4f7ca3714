// SPDX-License-Identifier: GPL-3.0-or-later
//
// Means and granular temperatures of windows, where the velocities are known functions of the place.
#include "statistics/window_moments.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/user_error.hpp"
#include "support/shared_particles.hpp"

namespace {

using namespace interphase;
using test::Particle;
using test::world;

constexpr SampleWindows windows{4, 0.0, 0.2, 0.1, 0.04, 0.0, 0.003};
constexpr double round_off = 1e-12;

TEST(WindowMoments, OfAVelocityThatIsLinearAcrossTheBed)
{
    // 40 spheres a window, evenly spaced: u = 1 - 20 x, w = -2 + 30 x. Evenly spaced points have a variance of
    // slope^2 L^2/12 (1 - 1/N^2).
    constexpr double length = 0.05, points = 40;
    std::vector<Particle> all;
    for (int n = 0; n < 160; ++n) {
        const double x = (n + 0.5) * length / points;
        all.push_back({n + 1, {x, 0.02, 0.1}, {1 - 20 * x, 7, -2 + 30 * x}});
    }
    auto particles = test::shared(all);
    const WindowMoments found = window_moments(world(), particles.particles(), windows, false);
    for (std::size_t w = 0; w < 4; ++w) {
        const double x = (static_cast<double>(w) + 0.5) * length;
        const double variance = length * length / 12 * (1 - 1 / (points * points));
        EXPECT_EQ(found.number[w], points);
        EXPECT_EQ(found.real[w], points);
        EXPECT_NEAR(found.sum[0][w] / points, 1 - 20 * x, round_off);
        EXPECT_NEAR(found.sum[1][w] / points, -2 + 30 * x, round_off);
        EXPECT_NEAR(found.temperature[0][w], 400 * variance, round_off);
        EXPECT_NEAR(found.temperature[1][w], 900 * variance, round_off);
    }
    const WindowMoments front = window_moments(world(), particles.particles(), windows, true);
    EXPECT_EQ(front.number, Scalars(4, 0.0));
    EXPECT_TRUE(std::isnan(front.temperature[0][0]));
}

TEST(WindowMoments, WeighParcelsAndKnowTheirEdges)
{
    std::vector<Particle> all{{1, {0.05, 0.003, 0.08}, {0, 0, 0}},  // on three edges, and inside
                              {2, {0.06, 0.0, 0.1}, {4, 0, 0}},
                              {3, {0.06, 0.0, 0.12}, {100, 0, 0}},     // at the upper edge: outside
                              {4, {0.2, 0.0, 0.1}, {100, 0, 0}},       // at the right end: outside
                              {5, {0.01, 0.0, 0.1}, {3, 0, 0}},        // alone: no temperature
                              {6, {0.06, 0.0031, 0.1}, {100, 0, 0}}};  // behind the slice
    all[1].weight = 3;
    all[4].weight = 8;
    auto particles = test::shared(all);
    const WindowMoments found = window_moments(world(), particles.particles(), windows, true);
    EXPECT_EQ(found.number, (Scalars{1, 2, 0, 0}));
    EXPECT_EQ(found.real, (Scalars{8, 4, 0, 0}));
    EXPECT_EQ(found.sum[0], (Scalars{24, 12, 0, 0}));
    EXPECT_DOUBLE_EQ(found.temperature[0][1], 3);  // (1 * 3^2 + 3 * 1^2)/4 about a mean of 3
    EXPECT_TRUE(std::isnan(found.temperature[0][0]));
}

TEST(StatisticsScene, IsChosenByTheBedWhereNothingIsGiven)
{
    const std::vector<Particle> all{{1, {0.01, 0.01, 0.02}, Vector::Zero(), 0.01},
                                    {2, {0.05, 0.01, 0.04}, Vector::Zero(), 0.01}};
    auto particles = test::shared(all);
    Box vessel;
    vessel << 0, 0.2, 0, 0.1, 0, 1;
    const Bed bed = bed_of(world(), particles, &vessel);
    const StatisticsScene scene = scene_of(world(), {}, bed, nullptr);
    EXPECT_EQ(scene.windows->count, 5);  // 0.2 m hold five of four diameters
    EXPECT_EQ(scene.windows->left, 0);
    EXPECT_EQ(scene.windows->right, 0.2);
    EXPECT_DOUBLE_EQ(scene.windows->centre, 0.03);
    EXPECT_DOUBLE_EQ(scene.windows->height, 0.04);
    EXPECT_DOUBLE_EQ(scene.windows->front_depth, 0.01);
    EXPECT_EQ(scene.columns, 5);
}

TEST(StatisticsScene, RefusesWindowsOutsideTheVessel)
{
    auto particles = test::shared({{1, {0.01, 0.01, 0.02}}, {2, {0.05, 0.01, 0.04}}});
    Box vessel;
    vessel << 0, 0.2, 0, 0.1, 0, 1;
    const Bed bed = bed_of(world(), particles, &vessel);
    const auto refused = [&](const StatisticsSettings& settings, const std::string& says) {
        try {
            scene_of(world(), settings, bed, nullptr);
            FAIL() << says;
        } catch (const UserError& error) {
            EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
        }
    };
    StatisticsSettings settings;
    settings.windows.centre = 5.0;
    refused(settings, "outside of the vessel: z = ");
    settings = {};
    settings.windows.left = 0.3;
    refused(settings, "the windows are empty");
    settings = {};
    settings.windows.front = 0.2;
    refused(settings, "outside of the vessel: y = 0.2");
    settings = {};
    settings.windows.left = -0.2;
    refused(settings, "window 1 of 5, x = -0.2 to -0.12 m");
    try {
        auto none = test::shared({});
        scene_of(world(), {}, bed_of(world(), none, &vessel), nullptr);
        FAIL();
    } catch (const UserError& error) {
        EXPECT_NE(std::string(error.what()).find("windows/centre is not given"), std::string::npos) << error.what();
    }
}

TEST(StatisticsScene, RefusesWindowsBesideTheMesh)
{
    // a step in the floor: below z = 0.5 m there is the left half only
    MeshView mesh;
    if (world().is_master()) {
        mesh.centre = {{0.05, 0.05, 0.25}, {0.1, 0.05, 0.75}};
        mesh.extent = {{0.1, 0.1, 0.5}, {0.2, 0.1, 0.5}};
        mesh.volume = {0.005, 0.01};
    }
    auto particles = test::shared({{1, {0.01, 0.01, 0.02}}, {2, {0.05, 0.01, 0.04}}});
    Box vessel;
    vessel << 0, 0.2, 0, 0.1, 0, 1;
    const Bed bed = bed_of(world(), particles, &vessel);
    StatisticsSettings settings;
    settings.windows.count = 4;
    settings.windows.height = 0.1;
    const auto refusal = [&] {
        try {
            scene_of(world(), settings, bed, &mesh);
        } catch (const UserError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    settings.windows.centre = 0.4;
    EXPECT_NE(refusal().find("window 3 of 4, x = 0.1 to 0.15 m at z = 0.35 to 0.45 m, has no part in the vessel"),
              std::string::npos)
        << refusal();
    settings.windows.centre = 0.6;
    EXPECT_EQ(refusal(), "");
    settings.windows.centre = 0.4;
    settings.windows.right = 0.1;
    EXPECT_EQ(refusal(), "");
}

TEST(StatisticsScene, TakesZAsUp)
{
    Box vessel;
    vessel << 0, 0.2, 0, 0.1, 0, 1;
    StatisticsSettings settings;
    const auto refusal = [&](const Vector& gravity) {
        auto particles = test::shared({{1, {0.01, 0.01, 0.02}}, {2, {0.05, 0.01, 0.04}}}, gravity);
        try {
            scene_of(world(), settings, bed_of(world(), particles, &vessel), nullptr);
        } catch (const UserError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    for (const Vector& down : {Vector(0, 0, -9.81), Vector(0, 0, 0), Vector(4, 0, -9)})
        EXPECT_EQ(refusal(down), "");
    for (const Vector& other : {Vector(0, -9.81, 0), Vector(0, 0, 9.81), Vector(-9, 0, -4)}) {
        const std::string words = refusal(other);
        EXPECT_NE(words.find("these take z as up: windows, surface"), std::string::npos) << words;
        EXPECT_NE(words.find("set `windows none; surface none;`"), std::string::npos) << words;
    }
    settings.windows.wanted = settings.surface.wanted = false;
    EXPECT_EQ(refusal({0, -9.81, 0}), "");
}

}  // namespace
