// SPDX-License-Identifier: GPL-3.0-or-later
//
// The books balance where impulses do, and show by how much where they do not.
#include "momentum/ledger.hpp"
#include "support/world.hpp"

#include <gtest/gtest.h>

namespace {

using namespace interphase;
using test::world;

/// Books one step; the gas gives on the last rank what particles take on the first.
void book(Ledger& ledger, const Vector& given, const Vector& taken, const Vector& owed)
{
    ExchangeAccount::Step& mine = ledger.momentum.step;
    if (world().rank() == world().size() - 1) mine.given_by_gas = given;
    if (world().is_master()) {
        mine.taken_by_particles = taken;
        mine.owed = owed;
    }
    ledger.book();
}

TEST(Ledger, IsEmptyAtFirst)
{
    const Ledger ledger(world());
    for (const Account* account : ledger.accounts())
        EXPECT_EQ(account->residual(), 0) << account->key();
    EXPECT_EQ(ledger.momentum.exchanged(), 0);
}

TEST(Ledger, ClosesOverRanks)
{
    Ledger ledger(world());
    book(ledger, {1, 2, 3}, {1, 2, 3}, Vector::Zero());
    EXPECT_EQ(ledger.momentum.residual(), 0);
    EXPECT_DOUBLE_EQ(ledger.momentum.exchanged(), Vector(1, 2, 3).norm());
}

TEST(Ledger, WhatIsOwedIsGivenInTheNextStep)
{
    Ledger ledger(world());
    // the particles took 5 where the gas gave 4; then the gas gives 3 + 1 where they take 3
    book(ledger, {0, 0, 4}, {0, 0, 5}, {0, 0, 1});
    EXPECT_EQ(ledger.momentum.residual(), 0);
    book(ledger, {0, 0, 4}, {0, 0, 3}, Vector::Zero());
    EXPECT_EQ(ledger.momentum.residual(), 0);
}

TEST(Ledger, ShowsWhatIsMissingRelativeToWhatWasExchanged)
{
    Ledger ledger(world());
    book(ledger, {0, 0, 4}, {0, 0, 4}, Vector::Zero());
    book(ledger, {0, 0, -4}, {0, 0, -4.008}, Vector::Zero());
    EXPECT_NEAR(ledger.momentum.residual(), 0.008 / 8, 1e-15);
    book(ledger, {0, 0, 4}, {0, 0, 4}, Vector::Zero());
    EXPECT_NEAR(ledger.momentum.residual(), 0.008 / 12, 1e-15);  // and it is not forgotten
}

TEST(Ledger, WhatTheGasGaveToParticlesThatLeftIsCarriedOff)
{
    Ledger ledger(world());
    // assumed 4 of all, who took 3.5; of that one who took 0.5 left, of whom 1 was assumed
    ExchangeAccount::Step& mine = ledger.momentum.step;
    if (world().is_master()) {
        mine.given_by_gas = Vector(0, 0, 4);
        mine.taken_by_particles = Vector(0, 0, 3.5);
        mine.carried_off = Vector(0, 0, 0.5);
    }
    ledger.book();
    EXPECT_EQ(ledger.momentum.residual(), 0);
    EXPECT_EQ(ledger.momentum.carried_off(), Vector(0, 0, 0.5));
}

TEST(Ledger, ComparesSolidVolumes)
{
    Ledger ledger(world());
    ledger.solid_volume.step = {world().is_master() ? 2.0 + 1e-3 * world().size() : 2.0, 2.0};
    ledger.book();
    EXPECT_NEAR(ledger.solid_volume.residual(), 1e-3 / 2, 1e-12);
    ledger.solid_volume.step = {2.0, 2.0};
    ledger.book();
    EXPECT_EQ(ledger.solid_volume.residual(), 0);
}

TEST(Ledger, FollowsTheGasVolumeAcrossTheBoundary)
{
    Ledger ledger(world());
    const double ranks = world().size();
    ledger.gas_volume.step = {3.0 / ranks, 0, 0};
    ledger.book();
    ledger.gas_volume.step = {3.5 / ranks, world().is_master() ? 0.7 : 0.0, 0.2 / ranks};
    ledger.book();
    EXPECT_NEAR(ledger.gas_volume.residual(), 0, 1e-15);
    ledger.gas_volume.step = {3.5 / ranks, 0.1 / ranks, 0};  // came in, and is not there
    ledger.book();
    EXPECT_NEAR(ledger.gas_volume.residual(), 0.1 / 3.6, 1e-15);
}

TEST(Ledger, AVesselThatEndsEmptyIsJudgedByWhatItHeld)
{
    Ledger ledger(world());
    const double ranks = world().size();
    const auto residual_after = [&](double content, double in, double out) {
        ledger.solids.step = {content / ranks, in / ranks, out / ranks};
        ledger.book();
        return ledger.solids.residual();
    };
    residual_after(0, 0, 0);
    EXPECT_NEAR(residual_after(2, 2, 0), 0, 1e-15);
    EXPECT_NEAR(residual_after(1e-9, 0, 2), 1e-9 / 2, 1e-15);  // there, and said to have gone
    EXPECT_NEAR(residual_after(0, 0, 0), 0, 1e-15);            // all of it, now
    EXPECT_NEAR(residual_after(0, 1, 0), 0.5, 1e-15);          // came in, and nothing is there
}

TEST(Ledger, ForgetsTheNumbersOfAStepThatIsBooked)
{
    Ledger ledger(world());
    book(ledger, {0, 0, 4}, {0, 0, 4}, Vector::Zero());
    ledger.book();
    EXPECT_DOUBLE_EQ(ledger.momentum.exchanged(), 4);
}

/// A scalar is an account of one component: what heat would be.
TEST(ExchangeAccount, KeepsAScalar)
{
    ExchangeAccount heat("heat", "heat, gas against particles", "of the heat exchanged", 1);
    heat.step.given_by_gas << 2.0;
    heat.step.taken_by_particles << 1.5;
    heat.step.owed << -0.5;
    Scalars numbers;
    heat.hand_in(numbers);
    EXPECT_EQ(numbers.size(), 4u);
    heat.book(numbers.data());
    EXPECT_EQ(heat.residual(), 0);
    EXPECT_EQ(heat.exchanged(), 2);
}

}  // namespace
