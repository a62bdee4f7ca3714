// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/checkpoint_schedule.hpp"

#include <algorithm>
#include <filesystem>

#include "base/text.hpp"

namespace interphase {

namespace {

/// A large bed on a slow disk gets fewer by the clock: none takes more than a hundredth of the time.
constexpr double least_ratio = 100;

}  // namespace

CheckpointSchedule::CheckpointSchedule(const Settings& settings, double start)
    : interval_(settings.checkpoint_interval), wall_interval_(settings.checkpoint_wall_interval)
{
    if (interval_ > 0) by_time_.emplace(start + interval_, interval_);
}

std::string CheckpointSchedule::description() const
{
    std::string words;
    if (by_time_) words += "every " + text(interval_) + " s of simulated time";
    if (wall_interval_ > 0)
        words += std::string(words.empty() ? "" : ", ") + "every " + text(wall_interval_) + " s of wall time";
    return words.empty() ? "none but asked for" : words + ", and at the end";
}

CheckpointSchedule::Due CheckpointSchedule::due(const Communicator& comm, const Moment& moment)
{
    const bool by_time = by_time_ && by_time_->due(moment.time, moment.gas_step);
    if (by_time_) by_time_->pass(moment.time, moment.gas_step);
    std::error_code none;
    const bool by_file =
        comm.is_master() && std::filesystem::is_regular_file(trigger, none) && std::filesystem::remove(trigger, none);
    const bool by_clock =
        comm.is_master() && wall_interval_ > 0 && moment.wall > last_ + std::max(wall_interval_, least_ratio * cost_);
    Scalars wishes{by_file || moment.asked ? 1.0 : 0.0, by_clock ? 1.0 : 0.0};
    comm.max(wishes);
    if (by_time) return Due::by_time;
    if (wishes[0] > 0) return Due::asked;
    return wishes[1] > 0 || (moment.ends && regular()) ? Due::by_clock : Due::no;
}

void CheckpointSchedule::written(double wall, double seconds)
{
    last_ = wall;
    cost_ = seconds;
}

void CheckpointSchedule::keep(Archive& archive)
{
    if (by_time_) archive.keep("next", *by_time_);
}

}  // namespace interphase
