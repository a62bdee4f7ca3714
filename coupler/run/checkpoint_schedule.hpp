// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "run/record_schedule.hpp"
#include "settings/settings.hpp"

namespace interphase {

/// When a run writes checkpoints: by simulated time, by the wall clock, when a file or a signal asks, and at the end.
class CheckpointSchedule {
public:
    /// A file of the case's folder that asks for one, and is taken away then.
    static constexpr const char* trigger = "checkpoint";

    /// From `start` [s] of simulated time on.
    CheckpointSchedule(const Settings& settings, double start);

    /// Whether the run writes any without being asked.
    bool regular() const { return by_time_ || wall_interval_ > 0; }

    /// E.g. "every 600 s of wall time, and at the end".
    std::string description() const;

    struct Moment {
        double time, gas_step;  ///< [s]
        double wall;            ///< of this rank, since the start [s]
        bool asked;             ///< by a signal, of this rank
        bool ends;              ///< the run, now
    };
    enum class Due {
        no,
        asked,
        by_clock,  ///< or at the end; the run goes on as if none had been written, here as where it was asked for
        by_time,   ///< the run goes on from what it wrote: one that starts from there goes on to the last bit likewise
    };
    /// Collective.
    Due due(const Communicator& comm, const Moment& moment);

    /// One was written within `seconds`, at `wall` [s].
    void written(double wall, double seconds);

    void keep(Archive& archive);

private:
    std::optional<RecordSchedule> by_time_;
    double interval_ = 0, wall_interval_ = 0;  ///< as given [s]
    double last_ = 0;                          ///< by the wall clock [s]
    double cost_ = 0;                          ///< of the last one [s]
};

}  // namespace interphase
