// SPDX-License-Identifier: GPL-3.0-or-later
//
// A warning of an engine is told once, whichever ranks have it and however often, and every one of them is counted.
#include "base/engine_warnings.hpp"

#include <gtest/gtest.h>

#include "support/world.hpp"

namespace {

using namespace interphase;
using test::world;
using Words = std::vector<std::string>;

TEST(EngineWarnings, ThatDifferInNumbersAreToldOnceAndCounted)
{
    EngineWarnings warnings("LIGGGHTS", "log");
    for (int step = 0; step < 5; ++step)
        warnings.hear("time-step is " + std::to_string(230 + step) + ".5 % of rayleigh time, 1.5e-07 s, at -3");
    warnings.hear("time-step is 12 % of rayleigh time, 3 s, at 2");
    EXPECT_EQ(warnings.news(world()), Words{"time-step is 230.5 % of rayleigh time, 1.5e-07 s, at -3"});
    warnings.hear("time-step is 9 % of rayleigh time, 1E+9 s, at 7");
    EXPECT_EQ(warnings.news(world()), Words{});
    EXPECT_EQ(warnings.count(world()).number, 7 * world().size());
}

TEST(EngineWarnings, OfOneRankReachAll)
{
    EngineWarnings warnings("LIGGGHTS", "log");
    if (world().rank() == world().size() - 1) warnings.hear("  Particles \n were   lost ");
    EXPECT_EQ(warnings.news(world()), Words{"Particles were lost"});
    EXPECT_EQ(warnings.count(world()).number, 1);
    warnings.hear("Particles were lost");  // of the others now: known to all
    EXPECT_EQ(warnings.news(world()), Words{});
    EXPECT_EQ(warnings.count(world()).number, 1 + world().size());
}

TEST(EngineWarnings, OfOtherWordsAreOthers)
{
    EngineWarnings warnings("LIGGGHTS", "log");
    warnings.hear("mesh wall1: 3 elements overlap");
    warnings.hear("mesh wall21: 3 elements overlap");
    warnings.hear("mesh wall21: 14 elements overlap");
    warnings.hear("");
    EXPECT_EQ(warnings.own_news(), (Words{"mesh wall1: 3 elements overlap", "mesh wall21: 3 elements overlap"}));
    EXPECT_EQ(warnings.news(world()).size(), 2u);
    EXPECT_EQ(warnings.own_news(), Words{});
    EXPECT_EQ(warnings.count(world()).number, 3 * world().size());
}

}  // namespace
