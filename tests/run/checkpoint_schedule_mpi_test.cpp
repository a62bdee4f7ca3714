// SPDX-License-Identifier: GPL-3.0-or-later
//
// When a checkpoint is due, and when a run has to end for its limit of wall-clock time.
#include "run/checkpoint_schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <optional>

#include "run/wall_limit.hpp"
#include "support/scratch_folder.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::world;
using Due = CheckpointSchedule::Due;

class CheckpointScheduleTest : public testing::Test {
protected:
    Due at(double wall, bool asked = false, bool ends = false)
    {
        return schedule->due(world(), {time += step, step, wall, asked, ends});
    }
    void make() { schedule.emplace(settings, 0); }

    test::ScratchFolder folder{world()};
    Settings settings;
    std::optional<CheckpointSchedule> schedule;
    const double step = 0.01;
    double time = 0;
};

TEST_F(CheckpointScheduleTest, LeavesAHundredTimesWhatTheLastOneTook)
{
    for (const double cost : {0.001, 5.0, 300.0}) {
        settings.checkpoint_wall_interval = 10;
        make();
        EXPECT_EQ(at(9.9), Due::no);
        EXPECT_EQ(at(10.1), Due::by_clock);
        const double end = 10.1 + cost, next = end + std::max(10.0, 100 * cost);
        schedule->written(end, cost);
        EXPECT_EQ(at(next - 0.1), Due::no) << cost;
        EXPECT_EQ(at(next + 0.1), Due::by_clock) << cost;
    }
}

TEST_F(CheckpointScheduleTest, IsAskedByOneRankOrAFile)
{
    settings.checkpoint_wall_interval = 0;
    make();
    EXPECT_EQ(at(1e6), Due::no);
    EXPECT_EQ(at(1e6, world().rank() == world().size() - 1), Due::asked);
    if (world().is_master()) std::ofstream(CheckpointSchedule::trigger) << "";
    world().barrier();
    EXPECT_EQ(at(1e6), Due::asked);
    EXPECT_EQ(at(1e6), Due::no);               // the file is gone
    EXPECT_EQ(at(1e6, false, true), Due::no);  // nor one at the end, where none are wanted
}

TEST_F(CheckpointScheduleTest, ComesAtEachMultipleOfTheSimulatedInterval)
{
    settings.checkpoint_interval = 0.03;
    make();
    for (int n = 1; n <= 12; ++n)
        EXPECT_EQ(at(0), n % 3 == 0 ? Due::by_time : Due::no) << n;
    EXPECT_EQ(at(0, false, true), Due::by_clock);  // at the end
}

TEST(WallLimit, KeepsRoomForTwoMoreStepsAndCheckpoints)
{
    WallLimit none(0), limit(1000);
    EXPECT_FALSE(none.reached(1e9));
    limit.stepped(30);
    limit.stepped(20);
    limit.kept(50);
    // 2 x 30, 2 x 50, a hundredth of the limit and half a second
    EXPECT_FALSE(limit.reached(829));
    EXPECT_TRUE(limit.reached(830));
}

}  // namespace
