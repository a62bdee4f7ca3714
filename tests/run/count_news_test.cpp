// SPDX-License-Identifier: GPL-3.0-or-later
//
// A count that comes to be looked at is told when it does, once, by what happened since the look before.
#include "run/count_news.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace {

using namespace interphase;

constexpr CountKind of_particles{"off", "particles off", Whole::particle_steps, "", Worry::share, "", ""};
constexpr CountKind bursts{"bursts", "bursts", Whole::cell_steps, "", Worry::any, "", ""};
constexpr CountKind deepest{"deepest", "deepest overlap", Whole::nothing, "", Worry::above, "", "", 0.05, "d"};
constexpr CountKind allowed{"allowed", "allowed", Whole::cell_steps, "", Worry::never, "", ""};

/// All that is told, in one line each.
std::string told(CountNews& news, const std::vector<Count>& counts, const Wholes& wholes)
{
    const std::vector<std::string> lines = news.of(counts, wholes);
    return std::accumulate(lines.begin(), lines.end(), std::string(),
                           [](const std::string& all, const std::string& line) { return all + line + "\n"; });
}

/// As it is told.
std::string look_at(const std::string& what)
{
    return "look at " + what + ", in the last 100 gas steps (interphase -help counts)\n";
}

/// After `steps` gas steps with 10 particles and 5 cells.
Wholes after(double steps) { return {10 * steps, 5 * steps, steps, 10}; }

TEST(CountNews, TellsOnceWhenAShareGetsTooLarge)
{
    CountNews news;
    EXPECT_EQ(told(news, {{of_particles, 10}}, after(100)), "");  // 1 %, the limit
    EXPECT_EQ(told(news, {{of_particles, 60}}, after(200)), look_at("\"particles off\": 50, 5 %"));
    EXPECT_EQ(told(news, {{of_particles, 1060}}, after(300)), "");
}

TEST(CountNews, SeesTroubleThatComesLate)
{
    CountNews news;
    EXPECT_EQ(told(news, {{of_particles, 0}}, after(1e6)), "");
    // two millionths of all steps so far
    EXPECT_EQ(told(news, {{of_particles, 20}}, after(1e6 + 100)), look_at("\"particles off\": 20, 2 %"));
}

TEST(CountNews, WeighsWithHowFarOffEachIs)
{
    CountNews news;
    EXPECT_EQ(told(news, {{of_particles, 900, 9.9}}, after(100)), "");
    EXPECT_EQ(told(news, {{of_particles, 1800, 20.9}}, after(200)), look_at("\"particles off\": 900, 90 %"));
}

TEST(CountNews, KnowsWhatWorriesByNumberExtremeOrNever)
{
    CountNews news;
    const Count shallow = Count::measured(deepest, 0.05), deep = Count::measured(deepest, 0.0625);
    EXPECT_EQ(told(news, {{bursts, 0}, shallow, {allowed, 500}}, after(100)), "");
    EXPECT_EQ(told(news, {{bursts, 1}, deep, {allowed, 1000}}, after(200)),
              look_at("\"bursts\": 1, 0.2 %") + look_at("\"deepest overlap\": 0.0625 d"));
}

TEST(CountNews, IsDueEveryHundredGasSteps)
{
    CountNews news;
    news.begin_with({}, after(30));
    EXPECT_FALSE(news.due(30));
    EXPECT_FALSE(news.due(129));
    EXPECT_TRUE(news.due(130));
    news.of({}, after(130));
    EXPECT_FALSE(news.due(131));
    EXPECT_TRUE(news.due(230));
}

TEST(CountNews, DoesNotRepeatAnExtremeOfBefore)
{
    CountNews news;
    const Count deep = Count::measured(deepest, 0.0625), deeper = Count::measured(deepest, 0.125);
    news.begin_with({deep}, after(100));
    EXPECT_EQ(told(news, {deep}, after(200)), "");
    EXPECT_EQ(told(news, {deeper}, after(300)), "");
}

TEST(CountNews, IsNotOfWhatWasBeforeThisPartOfTheRun)
{
    CountNews news;
    news.begin_with({{of_particles, 500}, {bursts, 3}}, after(100));
    EXPECT_EQ(told(news, {{of_particles, 500}, {bursts, 3}}, after(200)), "");
    EXPECT_EQ(told(news, {{of_particles, 700}, {bursts, 3}}, after(300)), look_at("\"particles off\": 200, 20 %"));
}

}  // namespace
