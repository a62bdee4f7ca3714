// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/record_schedule.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using interphase::RecordSchedule;

/// Times at which it was due, in even steps after the start.
std::vector<double> due_times(RecordSchedule schedule, double start, double step, int steps)
{
    std::vector<double> times;
    for (int n = 0; n <= steps; ++n) {
        const double now = start + n * step;
        if (schedule.due(now, step)) times.push_back(now);
        schedule.pass(now, step);
    }
    return times;
}

TEST(RecordSchedule, IsDueAtTheStepNearestToEachMultiple)
{
    const auto times = due_times({0, 0.1}, 0, 0.03, 20);
    const std::vector<double> nearest{0, 0.09, 0.21, 0.30, 0.39, 0.51, 0.60};
    ASSERT_EQ(times.size(), nearest.size());
    for (std::size_t n = 0; n < times.size(); ++n)
        EXPECT_NEAR(times[n], nearest[n], 1e-12);
}

TEST(RecordSchedule, IsDueOnceAStepWhereStepsAreLonger) { EXPECT_EQ(due_times({0, 0.1}, 0, 0.25, 4).size(), 5u); }

TEST(RecordSchedule, CountsFromItsStart) { EXPECT_EQ(due_times({7.3, 0.1}, 7.3, 0.05, 10).size(), 6u); }

TEST(RecordSchedule, DoesNotDriftWithRoundOff) { EXPECT_EQ(due_times({0, 0.1}, 0, 0.01, 100000).size(), 10001u); }

}  // namespace
