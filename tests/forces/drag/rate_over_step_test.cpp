// SPDX-License-Identifier: GPL-3.0-or-later
//
// The drag rate of a step: exact where the law is linear, closer than that of the step's start where it is not, and
// that of balance where the step is long, from whatever slip it starts.
#include "forces/drag/rate_over_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "momentum/drag_response.hpp"

namespace {

using namespace interphase;

constexpr double mass = 2e-6;
const Vector gravity(0, 0, -9.81);

/// k = k_1 (1 + |slip|/speed)^power: Stokes' law at low slip, any power at high.
struct Law {
    double power;
    double k_1 = 1e-5, speed = 0.01;
    double operator()(double slip) const { return k_1 * std::pow(1 + slip / speed, power); }
};

/// Slip of balance [m/s] and its rate, by bisection.
double balance(const Law& law)
{
    double low = 0, high = 1e6;
    for (int n = 0; n < 200; ++n) {
        const double middle = 0.5 * (low + high);
        (law(middle) * middle < mass * gravity.norm() ? low : high) = middle;
    }
    return low;
}

TEST(RateOverStep, OfALinearLawIsTheLaws)
{
    for (const double dt : {1e-4, 1e-1, 1e3})
        EXPECT_DOUBLE_EQ(rate_over_step(
                             Law{0}, {0.1, 0, -0.3}, mass, [] { return gravity; }, dt),
                         1e-5);
}

TEST(RateOverStep, OfALongStepIsThatOfBalanceFromAnySlip)
{
    for (const double power : {0.2, 0.5, 0.7, 1.0}) {
        const Law law{power};
        const double settled = balance(law);
        for (const double start : {0.0, 0.1 * settled, settled, 10 * settled})
            // the last correction is below 1 part in 1000 and takes at least half of what is wrong
            EXPECT_NEAR(rate_over_step(
                            law, {0, 0, start}, mass, [] { return gravity; }, 1e3) /
                            law(settled),
                        1, 2e-3)
                << power << ", from " << start;
    }
}

TEST(RateOverStep, BringsTheFallCloserThanTheRateOfTheStart)
{
    const Law law{0.6};
    const double time = 2 * mass / law(balance(law));
    const auto fallen = [&](int steps, bool predicts) {
        Vector v = Vector::Zero();
        const double dt = time / steps;
        for (int n = 0; n < steps; ++n) {
            const double k = predicts ? rate_over_step(
                                            law, -v, mass, [] { return gravity; }, dt)
                                      : law(v.norm());
            v += free_change(mass, k, -v, gravity, response_time(mass, k, dt));
        }
        return v.z();
    };
    const double exact = fallen(200000, false) + (fallen(200000, false) - fallen(100000, false));
    for (const int steps : {4, 8, 16})  // a half to an eighth of the relaxation time
        EXPECT_LT(std::abs(fallen(steps, true) - exact), 0.45 * std::abs(fallen(steps, false) - exact)) << steps;
}

TEST(RateOverStep, OfAShortStepIsThatOfItsStart)
{
    const Law law{0.6};
    EXPECT_EQ(rate_over_step(
                  law, {0, 0, 0.1}, mass, [] { return gravity; }, 0.09 * mass / law(0.1)),
              law(0.1));
}

}  // namespace
