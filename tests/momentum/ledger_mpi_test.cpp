// SPDX-License-Identifier: GPL-3.0-or-later
//
// The books balance where impulses do, and show by how much where they do not.
#include "momentum/ledger.hpp"
#include "support/world.hpp"

#include <gtest/gtest.h>

namespace {

using namespace interphase;
using test::world;

/// One rank's part; the gas gives on the last rank what particles take on the first.
Transactions step(const Vector& given, const Vector& taken, const Vector& pending)
{
    Transactions mine;
    if (world().rank() == world().size() - 1) mine.given_by_gas = given;
    if (world().is_master()) {
        mine.taken_by_particles = taken;
        mine.pending = pending;
        mine.assumed_of_particles = taken - pending;
    }
    mine.solid_volume_in_cells = mine.solid_volume_of_particles = 0.5;
    return mine;
}

TEST(Ledger, IsEmptyAtFirst)
{
    const Ledger ledger(world());
    EXPECT_EQ(ledger.momentum_residual(), 0);
    EXPECT_EQ(ledger.volume_residual(), 0);
    EXPECT_EQ(ledger.exchanged(), 0);
}

TEST(Ledger, ClosesOverRanks)
{
    Ledger ledger(world());
    ledger.book(step({1, 2, 3}, {1, 2, 3}, Vector::Zero()), Vector::Zero(), false);
    EXPECT_EQ(ledger.momentum_residual(), 0);
    EXPECT_DOUBLE_EQ(ledger.exchanged(), Vector(1, 2, 3).norm());
}

TEST(Ledger, WhatIsPendingIsOwedUntilTheNextStepGivesIt)
{
    Ledger ledger(world());
    // the particles took 5 where the gas gave 4; then the gas gives 3 + 1 where they take 3
    ledger.book(step({0, 0, 4}, {0, 0, 5}, {0, 0, 1}), Vector::Zero(), false);
    EXPECT_EQ(ledger.momentum_residual(), 0);
    ledger.book(step({0, 0, 4}, {0, 0, 3}, Vector::Zero()), Vector::Zero(), false);
    EXPECT_EQ(ledger.momentum_residual(), 0);
}

TEST(Ledger, ShowsWhatIsMissingRelativeToWhatWasExchanged)
{
    Ledger ledger(world());
    ledger.book(step({0, 0, 4}, {0, 0, 4}, Vector::Zero()), Vector::Zero(), false);
    ledger.book(step({0, 0, -4}, {0, 0, -4.008}, Vector::Zero()), Vector::Zero(), false);
    EXPECT_NEAR(ledger.momentum_residual(), 0.008 / 8, 1e-15);
    ledger.book(step({0, 0, 4}, {0, 0, 4}, Vector::Zero()), Vector::Zero(), false);
    EXPECT_NEAR(ledger.momentum_residual(), 0.008 / 12, 1e-15);  // and it is not forgotten
}

TEST(Ledger, WhatTheGasGaveToParticlesThatLeftIsCarriedOff)
{
    Ledger ledger(world());
    // assumed 4 of all; those that are left took 3, as assumed of them
    const Vector assumed_here = world().is_master() ? Vector(0, 0, 4) : Vector::Zero();
    ledger.book(step({0, 0, 4}, {0, 0, 3}, Vector::Zero()), assumed_here, true);
    EXPECT_EQ(ledger.momentum_residual(), 0);
    EXPECT_EQ(ledger.carried_off(), Vector(0, 0, 1));
}

TEST(Ledger, ComparesSolidVolumes)
{
    Ledger ledger(world());
    Transactions mine;
    mine.solid_volume_of_particles = 2.0;
    mine.solid_volume_in_cells = world().is_master() ? 2.0 + 1e-3 * world().size() : 2.0;
    ledger.book(mine, Vector::Zero(), false);
    EXPECT_NEAR(ledger.volume_residual(), 1e-3 / 2, 1e-12);
    mine.solid_volume_in_cells = 2.0;
    ledger.book(mine, Vector::Zero(), false);
    EXPECT_EQ(ledger.volume_residual(), 0);
}

}  // namespace
