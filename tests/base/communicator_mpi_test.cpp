// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reductions over ranks, and that a problem on any rank stops all of them with one message.
#include "base/communicator.hpp"

#include <gtest/gtest.h>

#include "base/user_error.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::world;

/// What this rank threw; nothing where it did not.
std::optional<Problem> told(const std::optional<Problem>& problem)
{
    try {
        world().fail_together(problem);
    } catch (const UserError& error) {
        return error.problem();
    }
    return std::nullopt;
}

TEST(Communicator, ReducesOverAllRanks)
{
    const int n = world().size();
    const double mine = world().rank() + 1;
    EXPECT_EQ(world().sum(mine), 0.5 * n * (n + 1));
    EXPECT_EQ(world().sum(static_cast<long>(mine)), n * (n + 1) / 2);
    EXPECT_EQ(world().max(mine), n);
    EXPECT_EQ(world().min(mine), 1);
    EXPECT_EQ(world().sum(Vector(mine, 1, 0)), Vector(0.5 * n * (n + 1), n, 0));
    EXPECT_EQ(world().max(Vector(mine, -mine, 7)), Vector(n, -1, 7));
    EXPECT_EQ(world().min(Vector(mine, -mine, 7)), Vector(1, -n, 7));

    Scalars several{mine, 2 * mine};
    world().sum(several);
    EXPECT_EQ(several, (Scalars{0.5 * n * (n + 1), 1.0 * n * (n + 1)}));
    Scalars largest{mine, -mine};
    world().max(largest);
    EXPECT_EQ(largest, (Scalars{1.0 * n, -1.0}));
}

TEST(Communicator, GathersInRankOrder)
{
    Scalars expected;
    for (int rank = 0; rank < world().size(); ++rank)
        expected.insert(expected.end(), {1.0 * rank, -1.0 * rank});
    const double mine = world().rank();
    EXPECT_EQ(world().all_gather({mine, -mine}), expected);
}

TEST(Communicator, AnyIsTrueWhereOneIs)
{
    EXPECT_FALSE(world().any(false));
    EXPECT_TRUE(world().any(world().rank() == world().size() - 1));
}

TEST(FailTogether, StaysQuietWithoutAProblem) { EXPECT_FALSE(told(std::nullopt)); }

TEST(FailTogether, AllRanksThrowTheOnlyFailingRanksProblem)
{
    const Problem of_last{"a problem on the last rank", "there", "none", "now"};
    const int last = world().size() - 1;
    const auto problem = told(world().rank() == last ? std::optional(of_last) : std::nullopt);
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->what, of_last.what);
    EXPECT_EQ(problem->where, of_last.where);
    EXPECT_EQ(problem->remedy, of_last.remedy);
    EXPECT_EQ(problem->when, of_last.when);
}

TEST(FailTogether, OfSeveralAllRanksThrowTheLowestRanksProblem)
{
    // of different lengths, so that a receiver must take the sender's
    const auto of_rank = [](int rank) {
        const std::string long_by_rank(static_cast<std::size_t>(10 * rank), 'x');
        return Problem{"problem " + long_by_rank + "!", "rank " + std::to_string(rank), long_by_rank};
    };
    const int lowest = world().size() / 2;
    const auto problem = told(world().rank() >= lowest ? std::optional(of_rank(world().rank())) : std::nullopt);
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->message(), of_rank(lowest).message());
}

}  // namespace
