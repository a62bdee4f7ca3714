// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a count comes to: its share, and what is said of it.
#include "base/count.hpp"

#include <gtest/gtest.h>

namespace {

using namespace interphase;

constexpr CountKind of_pairs{"pairs", "pairs", Whole::particle_steps, "", Worry::share, "", ""};
constexpr CountKind of_steps{"steps", "steps", Whole::gas_steps, "", Worry::any, "", ""};
constexpr CountKind allowed{"allowed", "allowed", Whole::cell_steps, "", Worry::never, "", ""};
constexpr CountKind of_nothing{"words", "words", Whole::nothing, "", Worry::any, "", ""};

Wholes wholes()
{
    Wholes all;
    all.particle_steps = 1000;
    all.cell_steps = 10;
    all.gas_steps = 4;
    return all;
}

TEST(Count, HasAShareOfWhatItIsAPartOf)
{
    EXPECT_DOUBLE_EQ(share_of({of_pairs, 20}, wholes()).value(), 0.02);
    EXPECT_DOUBLE_EQ(share_of({of_steps, 1}, wholes()).value(), 0.25);
    EXPECT_DOUBLE_EQ(share_of({allowed, 1}, wholes()).value(), 0.1);
    EXPECT_FALSE(share_of({of_nothing, 1}, wholes()));
    EXPECT_FALSE(share_of({of_pairs, 0}, Wholes{}));  // before the first step
}

TEST(Count, IsShownInPercentWithoutAnExponent)
{
    EXPECT_EQ(percent(0.0037), "0.37 %");
    EXPECT_EQ(percent(0.994), "99 %");
    EXPECT_EQ(percent(0.995), "100 %");
    EXPECT_EQ(percent(1.2), "120 %");
}

TEST(Count, SaysWhenToLookAtIt)
{
    EXPECT_EQ(verdict({of_pairs, 0}, wholes()), "");
    EXPECT_EQ(verdict({of_pairs, 10}, wholes()), "ordinary: below 1 %");  // just at it
    EXPECT_EQ(verdict({of_pairs, 11}, wholes()), "look at it: above 1 %");
    EXPECT_EQ(verdict({of_steps, 1}, wholes()), "look at it");
    EXPECT_EQ(verdict({allowed, 10}, wholes()), "ordinary");
    EXPECT_EQ(verdict({of_nothing, 1}, wholes()), "look at it");
    EXPECT_EQ(verdict({of_pairs, 1}, Wholes{}), "");  // nothing is known, and nothing is said
}

TEST(Count, IsWeighedWithHowFarOffEachIs)
{
    // 2 % of the pairs, each off by a quarter, move a mean by 0.5 %
    EXPECT_DOUBLE_EQ(weighed_share({of_pairs, 20, 5.0}, wholes()).value(), 0.005);
    EXPECT_EQ(verdict({of_pairs, 20, 5.0}, wholes()), "ordinary: moves a mean by up to 0.5 %");
    EXPECT_EQ(verdict({of_pairs, 20, 30.0}, wholes()), "look at it: moves a mean by up to 3 %");
}

TEST(Count, IsWrittenInGroupsOfThree)
{
    EXPECT_EQ(with_separators(0), "0");
    EXPECT_EQ(with_separators(999), "999");
    EXPECT_EQ(with_separators(1000), "1,000");
    EXPECT_EQ(with_separators(247052), "247,052");
    EXPECT_EQ(with_separators(1234567890), "1,234,567,890");
}

}  // namespace
