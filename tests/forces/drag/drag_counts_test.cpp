// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many particles were beyond the range of a drag law, and how far the law is off there.
#include <gtest/gtest.h>

#include "forces/drag/beetstra.hpp"
#include "forces/drag/drag.hpp"
#include "forces/drag/ergun.hpp"
#include "forces/drag/wen_yu.hpp"

namespace {

using namespace interphase;

constexpr double diameter = 1e-3, density = 1.2, viscosity = 1.8e-5;

/// A sphere of 1 mm that moves by itself through gas of that voidage, at that superficial Reynolds number.
ParticleInGas sphere(double voidage, double reynolds)
{
    ParticleInGas at;
    at.voidage = voidage;
    at.gas_velocity = Vector(0, 0, reynolds * viscosity / (voidage * density * diameter));
    at.density = density;
    at.viscosity = viscosity;
    at.diameter = diameter;
    at.volume = 5.236e-10;
    at.mass = 2500 * at.volume;
    at.duration = 1e-4;
    return at;
}

/// How far off one such sphere is counted to be; none where it is within the range.
std::optional<double> off(const char* law, double voidage, double reynolds)
{
    Drag drag(*find_drag_law(law));
    Response response;
    drag.act(sphere(voidage, reynolds), response);
    const Count count = drag.counts().at(0);
    return count.number == 1 ? std::optional(count.off) : std::nullopt;
}

double departure(DragFactor law, DragFactor from, double voidage, double reynolds)
{
    DragState state;
    state.voidage = voidage;
    state.reynolds = reynolds;
    return std::abs(law(state) / from(state) - 1);
}

constexpr double round_off = 1e-9;  // of the Reynolds number, which the gas velocity is made from and to

TEST(DragCounts, NothingIsCountedWithinTheRange)
{
    for (const double voidage : {0.41, 0.6, 0.89})
        EXPECT_FALSE(off("BVK", voidage, 500)) << voidage;
}

TEST(DragCounts, WhatIsBeyondIsWeighedWithItsDistanceFromALawThatHoldsThere)
{
    EXPECT_NEAR(off("BVK", 0.95, 100).value(), departure(beetstra, wen_yu, 0.95, 100), round_off);
    EXPECT_NEAR(off("BVK", 0.5, 1200).value(), departure(beetstra, wen_yu, 0.5, 1200), round_off);
    EXPECT_NEAR(off("BVK", 0.37, 100).value(), departure(beetstra, ergun, 0.37, 100), round_off);
    EXPECT_GT(off("Ergun", 0.99, 1000).value(), 1);  // a packed bed's law in a dilute gas is off by more than itself
}

TEST(DragCounts, WhereNoLawHoldsItsOwnSizeIsTaken)
{
    EXPECT_EQ(off("BVK", 0.3, 100).value(), 1);
    EXPECT_EQ(off("WenYu", 0.9, 3e5).value(), 1);
}

}  // namespace
