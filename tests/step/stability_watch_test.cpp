// SPDX-License-Identifier: GPL-3.0-or-later
//
// A time stepping that goes wrong is told in time, ended where it diverges, and the gas step obeys.
#include "step/stability_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/heard.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

constexpr double pi = 3.14159265358979;

TEST(StabilityWatch, TellsOfAnAlternationThatStaysAsItIs)
{
    const Heard heard = hear_gradient(2000, [](int i) { return i < 500 ? 1 : 1 + 0.1 * sign(i); });
    EXPECT_GT(heard.first(Stability::doubtful), 500);
    EXPECT_LE(heard.first(Stability::doubtful), 500 + Alternation::window);
    EXPECT_EQ(heard.first(Stability::hopeless), 0);
    ASSERT_EQ(heard.messages.size(), 1u);
    EXPECT_GT(heard.counts.alternating, 1470);
    EXPECT_EQ(heard.counts.episodes, 1);
    for (const char* part : {"the mean pressure gradient", "alternates from gas step to gas step",
                             "\n  where:  ", "\n  when:   t = 0.5", "\n  remedy: a gas step below 0.0005 s"})
        EXPECT_NE(heard.messages[0].find(part), std::string::npos) << part << " in\n" << heard.messages[0];
}

TEST(StabilityWatch, TellsOfAnAlternationOnASluggingBed)
{
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const Heard heard = hear_gradient(600, [&](int i) {
        return 1 + 0.5 * std::sin(2 * pi * i / 40) + 0.03 * normal(random) + (i < 300 ? 0 : 0.15 * sign(i));
    });
    EXPECT_GT(heard.first(Stability::doubtful), 300);
    EXPECT_LE(heard.first(Stability::doubtful), 340);
}

// Issue 9: packed bed in gas, gas step 5 ms; the weight is 172 Pa per area.
TEST(StabilityWatch, EndsARunThatGrowsBySixtyPercentAStep)
{
    for (const double start : {1e-3, 1e-2, 0.1, 1.5}) {
        const Heard heard = hear_gradient(
            40, [&](int i) { return 1 + (i < 5 ? 0 : start * sign(i) * std::pow(1.6, i - 5)); }, 5e-3);
        const int until_ten_weights = static_cast<int>(std::ceil(std::log(10 / start) / std::log(1.6)));
        EXPECT_GT(heard.first(Stability::hopeless), 5) << start;
        EXPECT_LE(heard.first(Stability::hopeless), 5 + std::max(until_ten_weights + 3, 11)) << start;
        EXPECT_LT(heard.first(Stability::doubtful), heard.first(Stability::hopeless)) << start;
    }
    // as it was seen, from the first alternation on: -92, 418, -306 ... 30708 Pa, without a calm beginning
    const Heard seen = hear_gradient(
        20, [](int i) { return (172 - 264 * sign(i) * std::pow(1.6, i)) / 172; }, 5e-3);
    EXPECT_GT(seen.first(Stability::hopeless), 0);
    EXPECT_LE(seen.first(Stability::hopeless), 11);  // the one of 30 kPa
    for (const char* part : {"diverges", "\n  where:  ", "\n  when:   ", "\n  remedy: a gas step below 0.0025 s"})
        EXPECT_NE(seen.messages.back().find(part), std::string::npos) << part << " in\n" << seen.messages.back();
}

TEST(StabilityWatch, TellsOfAnyRateOfGrowth)
{
    for (const double rate : {1.02, 1.05, 1.08, 1.1, 1.15, 1.3, 1.6, 2.0, 3.0}) {
        const double start = 0.005;
        const Heard heard = hear_gradient(1000, [&](int i) { return 1 + start * sign(i) * std::pow(rate, i - 100); });
        const auto size = [&](int step) { return start * std::pow(rate, step - 101); };
        ASSERT_GT(heard.first(Stability::hopeless), 0) << rate;
        EXPECT_LT(size(heard.first(Stability::doubtful)), 1.5) << rate;
        EXPECT_LT(size(heard.first(Stability::hopeless)), 35) << rate;
    }
}

TEST(StabilityWatch, EndsARunThatSwingsByManyWeightsForLong)
{
    // issue 9: DEM in the packed bed, -768/+804 Pa at a weight of 172
    const Heard heard = hear_gradient(
        300, [](int i) { return 1 + 4.6 * sign(i); }, 5e-3);
    EXPECT_EQ(heard.first(Stability::doubtful), Alternation::window);
    EXPECT_EQ(heard.first(Stability::hopeless), Alternation::window + 95);
}

TEST(StabilityWatch, SeesItInTheVelocityToo)
{
    const double dt = 1e-3, unit = g * dt;
    const Heard steady = hear_velocity(
        200, [&](int i) { return 2 * unit * sign(i); }, dt);
    EXPECT_EQ(steady.first(Stability::doubtful), Alternation::window);
    ASSERT_EQ(steady.messages.size(), 1u);
    EXPECT_NE(steady.messages[0].find("mean velocity of the particles"), std::string::npos);

    const Heard growing = hear_velocity(
        40, [&](int i) { return 0.1 * unit * sign(i) * std::pow(1.5, i); }, dt);
    EXPECT_GT(growing.first(Stability::hopeless), 0);
    EXPECT_LE(growing.first(Stability::hopeless), 15);

    const Heard weightless = hear_velocity(
        200, [&](int i) { return 0.3 * sign(i); }, dt, 0.0);
    EXPECT_EQ(weightless.first(Stability::doubtful), Alternation::window);
}

TEST(StabilityWatch, SeesSpeedBeyondGravityAndGas)
{
    // exponential growth without alternation
    const Heard heard = hear_velocity(60, [](int i) { return i < 20 ? 0.02 : 0.02 * std::pow(1.5, i - 19); });
    EXPECT_GT(heard.first(Stability::doubtful), 28);  // 3 m/s, three times the gas, is reached in step 33
    EXPECT_LE(heard.first(Stability::hopeless), 37);
    EXPECT_GT(heard.first(Stability::hopeless), 0);
    EXPECT_GT(heard.counts.accelerating, 0);
    EXPECT_NE(heard.messages[0].find("beyond what gravity and a gas of 1 m/s can give"), std::string::npos)
        << heard.messages[0];
}

TEST(StabilityWatch, EndsWhatIsNotFinite)
{
    EXPECT_EQ(hear_gradient(3, [](int i) { return i < 2 ? 1 : std::nan(""); }).first(Stability::hopeless), 3);
}

// --- the step

TEST(StabilityWatch, StepIsHalvedUntilCalmAndGrowsAgain)
{
    StabilityWatch watch(g);
    EXPECT_EQ(watch.longest_step(), DBL_MAX);
    double dt = 8e-3, amplitude = 0.01, shortest = dt, time = 0;
    const auto observe = [&](int i, double limit) {
        amplitude = std::min(std::max(amplitude * (dt > limit ? 1.2 : 0.5), 1e-6), 1e3);
        StepState state = bed(i, dt);
        state.time = time += dt;
        state.mean_pressure_gradient.z() *= 1 + amplitude * sign(i);
        const Finding finding = watch.observe(state);
        dt = std::min(8e-3, watch.longest_step());
        shortest = std::min(shortest, dt);
        return finding.stability;
    };
    int i = 0;
    for (; i < 200; ++i)
        EXPECT_NE(observe(i, 3e-3), Stability::hopeless) << i;
    EXPECT_DOUBLE_EQ(shortest, 2e-3);
    EXPECT_LT(dt, 3e-3);  // it grows by 5 % now and then
    for (; i < 2000; ++i)
        observe(i, 1);  // nothing is wrong any longer
    EXPECT_EQ(dt, 8e-3);
    EXPECT_GT(watch.longest_step(), 8e-3);
}

TEST(StabilityWatch, AFixedStepIsNotHalvedAgainAndAgain)
{
    StabilityWatch watch(g);
    for (int i = 0; i < 500; ++i) {
        StepState state = bed(i, 1e-3);
        state.mean_pressure_gradient.z() *= 1 + 0.2 * sign(i);
        watch.observe(state);
    }
    EXPECT_DOUBLE_EQ(watch.longest_step(), 5e-4);
}

TEST(StabilityWatch, NoParticleCrossesMoreThanACell)
{
    StabilityWatch watch(g);
    StepState state = bed(0, 1e-3);
    state.largest_crossing = 0.5;
    EXPECT_EQ(watch.observe(state).message(), "");
    EXPECT_DOUBLE_EQ(watch.longest_step(), 2e-3);
    state.largest_crossing = 2.5;
    const Finding finding = watch.observe(state);
    EXPECT_EQ(finding.stability, Stability::calm);
    EXPECT_NE(finding.message().find("a particle crosses 2.5 gas cells in a gas step"), std::string::npos);
    EXPECT_DOUBLE_EQ(watch.longest_step(), 4e-4);
    EXPECT_EQ(watch.observe(state).message(), "");  // told once
    EXPECT_EQ(watch.counts().crossing, 2);
}

TEST(StabilityWatch, WavesRunHalfACellAtMost)
{
    StabilityWatch watch(g);
    StepState state = bed(0, 1e-2);
    state.largest_wave_crossing = 0.4;
    EXPECT_EQ(watch.observe(state).message(), "");
    state.largest_wave_crossing = 2;
    const Finding finding = watch.observe(state);
    EXPECT_EQ(finding.stability, Stability::calm);
    EXPECT_NE(finding.message().find("waves of the solid fraction run 2 gas cells in a gas step"), std::string::npos);
    EXPECT_NE(finding.message().find("remedy: a gas step below 0.0025 s"), std::string::npos) << finding.message();
    EXPECT_DOUBLE_EQ(watch.longest_step(), 2.5e-3);
    EXPECT_EQ(watch.observe(state).message(), "");  // told once
    EXPECT_EQ(watch.counts().outrun, 2);
}

}  // namespace
