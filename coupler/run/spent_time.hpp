// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "base/communicator.hpp"
#include "base/stopwatch.hpp"

namespace interphase {

/// What a run has taken so far by the wall clock [s]: phase by phase, the slowest rank's, and in all, the first rank's.
struct SpentTime {
    std::array<double, phase_names.size()> seconds{};
    double wall = 0;

    /// With what `stopwatch` says of the part of the run that goes on. Collective.
    SpentTime with(const Communicator& comm, const Stopwatch& stopwatch, double wall_of_part) const
    {
        SpentTime all = *this;
        for (std::size_t phase = 0; phase < phase_names.size(); ++phase)
            all.seconds[phase] += comm.max(stopwatch.seconds(static_cast<Phase>(phase)));
        all.wall += comm.sum(comm.is_master() ? wall_of_part : 0.0);  // the same on all
        return all;
    }
};

}  // namespace interphase
