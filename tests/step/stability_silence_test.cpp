// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stability watch says nothing of what gas and particles do by themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "step/stability_watch.hpp"
#include "support/heard.hpp"

namespace {

using namespace interphase;
using namespace interphase::test;

constexpr double pi = 3.14159265358979;

TEST(StabilitySilence, InSluggingAndBubblingBeds)
{
    for (const double period : {5.0, 7.3, 12.0, 20.0, 50.0, 300.0}) {
        const Heard heard = hear_gradient(5000, [&](int i) {
            return 1 + 0.5 * std::sin(2 * pi * i / period) + 0.2 * std::sin(2 * pi * i / (0.37 * period + 3));
        });
        EXPECT_TRUE(heard.silent()) << period;
    }
    // sawtooth: the drop builds up and breaks down at once as a slug bursts
    EXPECT_TRUE(hear_gradient(5000, [](int i) { return 0.7 + 0.02 * (i % 37); }).silent());
    EXPECT_TRUE(hear_gradient(5000, [](int i) { return i % 5 < 2 ? 2.0 : 0.5; }).silent());
}

TEST(StabilitySilence, InNoise)
{
    // autoregressive of first order: white at 0; steps that overcorrect at negative numbers
    for (const double memory : {-0.3, 0.0, 0.5, 0.9, 0.99})
        for (const double strength : {0.01, 0.1, 1.0, 5.0}) {
            std::mt19937 random(11);
            std::normal_distribution<double> normal;
            double x = 0;
            const Heard heard = hear_gradient(100000, [&](int) {
                x = memory * x + std::sqrt(1 - memory * memory) * strength * normal(random);
                return 1 + x;
            });
            EXPECT_TRUE(heard.silent()) << memory << ' ' << strength << ": " << heard.messages.size() << ' '
                                        << (heard.messages.empty() ? "" : heard.messages[0]);
        }
}

TEST(StabilitySilence, InNoiseOfRareBlows)
{
    // collisions of few particles: most steps see none, some a large one
    std::mt19937 random(5);
    std::exponential_distribution<double> size(1);
    std::uniform_real_distribution<double> chance(-1, 1);
    const auto blow = [&] {
        const double c = chance(random);
        return std::abs(c) < 0.2 ? std::copysign(size(random), c) : 0.0;
    };
    EXPECT_TRUE(hear_gradient(100000, [&](int) { return 1 + 3 * blow(); }).silent());
    double v = 0;
    EXPECT_TRUE(hear_velocity(100000, [&](int) { return v = 0.95 * v - g * 1e-3 + 0.2 * blow(); }).silent());
}

TEST(StabilitySilence, WhenALatticeFallsOntoTheFloor)
{
    for (const double dt : {1e-4, 1e-3, 1e-2}) {
        // 0.1 m of fall, then at rest in a step, or shaking itself to rest
        for (const double restitution : {0.0, 0.6, 0.9}) {
            double v = 0, z = 0.1;
            const Heard heard = hear_velocity(
                static_cast<int>(1 / dt),
                [&](int) {
                    v -= g * dt;
                    z += v * dt;
                    if (z < 0) {
                        z = 0;
                        v = -restitution * v;
                    }
                    return v;
                },
                dt);
            EXPECT_TRUE(heard.silent()) << dt << ' ' << restitution << ' '
                                        << (heard.messages.empty() ? "" : heard.messages[0]);
        }
    }
}

TEST(StabilitySilence, WhenABallBounces)
{
    // exact flights, any ratio of gas step to the time of a flight, elastic ones too
    for (const double restitution : {0.3, 0.7, 0.9, 0.97, 1.0})
        for (double flight = 0.5; flight < 9; flight *= 1.037) {
            const double dt = 1e-2;
            double v = flight * dt * g / 2, z = 0;
            const Heard heard = hear_velocity(
                300,
                [&](int) {
                    double left = dt;
                    for (int bounces = 0; bounces < 1000; ++bounces) {
                        const double lands = (v + std::sqrt(v * v + 2 * g * z)) / g;
                        if (lands > left) break;
                        v = restitution * (g * lands - v);
                        z = 0;
                        left -= lands;
                        if (v < 1e-6) return v = 0;
                    }
                    z = std::max(z + v * left - g * left * left / 2, 0.0);
                    return v -= g * left;
                },
                dt);
            EXPECT_TRUE(heard.silent()) << restitution << " " << flight
                                        << (heard.messages.empty() ? "" : heard.messages[0]);
        }
}

TEST(StabilitySilence, WhenAnInletIsSwitched)
{
    for (const double jump : {1.0, 30.0, 1000.0}) {
        // inertia of the gas gives one or two high values, then a drop that settles, ringing for some steps
        const auto switched = [&](int since) {
            if (since < 0) return 0.0;
            if (since == 0) return jump;
            if (since == 1) return -0.4 * jump;
            return 1 + jump * std::pow(-0.6, since + 1);
        };
        EXPECT_TRUE(hear_gradient(300, [&](int i) { return switched(i - 1); }).silent()) << jump;
        EXPECT_TRUE(hear_gradient(300, [&](int i) { return switched(i - 100); }).silent()) << jump;
    }
    // pulsed, with a period of 4 steps or more, and a spike at each switch
    for (const int period : {4, 5, 6, 10, 50})
        EXPECT_TRUE(hear_gradient(
                        2000,
                        [&](int i) {
                            const int phase = i % period;
                            return (phase < period / 2 ? 1.0 : 0.2) + (phase == 0 ? 20 : phase == period / 2 ? -20 : 0);
                        })
                        .silent())
            << period;
}

TEST(StabilitySilence, WhenParticlesFollowAGas)
{
    for (const double dt_over_tau : {1e-3, 0.1, 1.0, 100.0})
        for (const int ramp : {1, 10, 100}) {
            double v = 0, gas = 0;
            std::vector<StepState> states;
            for (int i = 0; i < 500; ++i) {
                gas = 10.0 * std::min(1.0, (i + 1.0) / ramp);
                v = gas + (v - gas) * std::exp(-dt_over_tau);
                states.push_back(bed(i, 1e-3));
                states.back().gas_speed = gas;
                states.back().mean_velocity.x() = v;
                states.back().kinetic_energy = 0.5 * v * v;
            }
            EXPECT_TRUE(hear(states).silent()) << dt_over_tau << ' ' << ramp;
        }
}

TEST(StabilitySilence, WhenParticlesComeInEveryOtherStep)
{
    std::vector<StepState> states;
    for (int i = 0; i < 2000; ++i) {
        states.push_back(bed(i, 1e-3));
        states.back().mass = 1 + 0.1 * (i / 2);
        states.back().mean_velocity.z() = -1 + 0.1 * sign(i);
    }
    EXPECT_TRUE(hear(states).silent());
}

TEST(StabilitySilence, BelowWhatMattersAndWithoutParticles)
{
    EXPECT_TRUE(hear_gradient(1000, [](int i) { return 1 + 0.04 * sign(i); }).silent());
    EXPECT_TRUE(hear_velocity(1000, [](int i) { return 0.9 * g * 1e-3 * sign(i); }).silent());
    EXPECT_TRUE(hear_gradient(1000, [](int i) { return 1 + 50 * sign(i) * std::pow(0.97, i); }).silent());  // decays
    EXPECT_TRUE(hear_velocity(
                    1000, [](int i) { return 1e-13 * sign(i); }, 1e-3, 0.0)
                    .silent());
    EXPECT_TRUE(hear(std::vector<StepState>(1000)).silent());
}

}  // namespace
