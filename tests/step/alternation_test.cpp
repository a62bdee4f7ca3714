// SPDX-License-Identifier: GPL-3.0-or-later
//
// An oscillation of two steps is measured exactly, whatever smooth trend it rides on.
#include "step/alternation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace interphase;

double sign(int step) { return step % 2 == 0 ? 1 : -1; }

TEST(Alternation, IsMeasuredOnATrend)
{
    Alternation series;
    for (int i = 0; i < Alternation::window; ++i)
        series.add(Vector(3 - 1e-3 * i * i * i, 0.5 * sign(i), -1200 + 7 * i - 1.2 * sign(i)));
    EXPECT_NEAR(series.amplitude(), 1.3, 1e-9);
    EXPECT_NEAR(series.purity(), 1, 1e-9);
    EXPECT_NEAR(series.persistence(), 1, 1e-9);
    EXPECT_NEAR(series.swing(), 1.3, 0.04);
}

TEST(Alternation, OfTwoPeriodsIsNone)
{
    const double pi = 3.14159265358979;
    for (const double period : {3.0, 4.0, 6.0, 8.0, 24.0, 60.0}) {
        Alternation series;
        for (int i = 0; i < 100; ++i) {
            series.add(Vector(0, 0, 5 + std::sin(2 * pi * i / period)));
            EXPECT_LT(series.purity(), 0.1) << period << ' ' << i;
        }
    }
}

TEST(Alternation, GrowthIsEvenWhereItIsExponential)
{
    Alternation series;
    for (int i = 0; i < 20; ++i) {
        series.add(Vector(0, 0, 1));
        EXPECT_EQ(series.growing(), 0);
    }
    for (int i = 0; i < 12; ++i)
        series.add(Vector(0, 0, 1 + 1e-3 * sign(i) * std::pow(1.6, i)));
    EXPECT_NEAR(series.growth(), std::pow(1.6, Alternation::ratios), 1e-6);
    EXPECT_NEAR(series.unevenness(), 1, 1e-6);
    EXPECT_EQ(series.background(), 0);
    for (int i = 12; i < 15; ++i)
        series.add(Vector(0, 0, 1 + 0.1 * sign(i) * std::pow(0.5, i)));
    EXPECT_EQ(series.growth(), 0);  // it decays
}

}  // namespace
