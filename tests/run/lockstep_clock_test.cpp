// SPDX-License-Identifier: GPL-3.0-or-later
//
// A gas step is a whole number of solid substeps, the nearest below what is wanted, and ends at the end of the run.
#include "run/lockstep_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace interphase;

constexpr double far_away = 1e300;

TEST(LockstepClock, RoundsDownToWholeSubsteps)
{
    const LockstepClock clock(1e-5);
    const GasStep step = clock.next(1.079e-4, far_away);
    EXPECT_EQ(step.substeps, 10);
    EXPECT_DOUBLE_EQ(step.duration, 1e-4);
}

TEST(LockstepClock, AWholeRatioSurvivesRoundOff)
{
    // 3e-4 / 1e-5 is 29.999999999999996 in floating point
    EXPECT_EQ(LockstepClock(1e-5).next(3e-4, far_away).substeps, 30);
    EXPECT_EQ(LockstepClock(0.1).next(0.3, far_away).substeps, 3);
}

TEST(LockstepClock, TakesAtLeastOneSubstep)
{
    const GasStep step = LockstepClock(1e-5).next(1e-7, far_away);
    EXPECT_EQ(step.substeps, 1);
    EXPECT_DOUBLE_EQ(step.duration, 1e-5);
}

TEST(LockstepClock, DoesNotPassTheEndByASubstep)
{
    const LockstepClock clock(1e-5);
    EXPECT_EQ(clock.next(1e-3, 4e-5).substeps, 4);             // ends on it
    EXPECT_EQ(clock.next(1e-3, 4.2e-5).substeps, 5);           // passes it by less than one
    EXPECT_EQ(clock.next(1e-3, 4.0000000001e-5).substeps, 4);  // round-off is not another substep
    EXPECT_EQ(clock.next(1e-3, 1e-12).substeps, 1);
}

TEST(LockstepClock, CoversARunWithoutDrift)
{
    const LockstepClock clock(1.7e-5);
    const double end = 0.05;
    double time = 0;
    long substeps = 0;
    while (time < end - 0.5 * clock.solid_step()) {
        const GasStep step = clock.next(2.3e-4, end - time);
        EXPECT_DOUBLE_EQ(step.duration, step.substeps * clock.solid_step());
        time += step.duration;
        substeps += step.substeps;
    }
    EXPECT_LT(std::abs(time - end), clock.solid_step());
    EXPECT_EQ(substeps, std::lround(std::ceil(end / clock.solid_step())));
}

TEST(DividingStep, IsTheLargestThatDividesEvenly)
{
    EXPECT_DOUBLE_EQ(dividing_step(1e-3, 3e-4), 1e-3 / 4);
    EXPECT_DOUBLE_EQ(dividing_step(1e-3, 2.5e-4), 2.5e-4);  // divides already
    EXPECT_DOUBLE_EQ(dividing_step(3e-4, 1e-4), 1e-4);      // but for round-off
    EXPECT_DOUBLE_EQ(dividing_step(1e-4, 1e-3), 1e-4);      // never longer than the gas step
}

}  // namespace
