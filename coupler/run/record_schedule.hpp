// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/archive.hpp"

namespace interphase {

/// When something is due that is recorded at even intervals: at the step nearest to each multiple of the interval,
/// once, however long the steps are.
class RecordSchedule {
public:
    /// `interval` [s] above 0; the first is due at `start` [s].
    RecordSchedule(double start, double interval) : interval_(interval), next_(start) {}

    /// Whether it is due at `now`, of a step of `step` [s].
    bool due(double now, double step) const { return now > next_ - 0.5 * step; }

    /// What was due at `now` is done.
    void pass(double now, double step)
    {
        while (next_ < now + 0.5 * step)
            next_ += interval_;
    }

    /// One that the saved state does not have begins anew; one whose interval is another now goes on from what was
    /// done.
    void keep(Archive& archive)
    {
        if (archive.loads() && !archive.has("next")) return;
        double interval = interval_;
        archive.keep("interval", interval);
        archive.keep("next", next_);
        if (interval != interval_) next_ += interval_ - interval;
    }

private:
    double interval_, next_;
};

}  // namespace interphase
