// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "base/stopwatch.hpp"

namespace interphase {

/// What the processors have given a run so far [s], phase by phase, all ranks together: other programs on the machine
/// hardly change it, as they do the wall clock's.
class ProcessorTime {
public:
    ProcessorTime(const Communicator& comm, const Stopwatch& stopwatch) : comm_(&comm), stopwatch_(&stopwatch) {}

    /// One number for each of `phase_names`. Collective.
    Scalars seconds() const
    {
        Scalars all(phase_names.size());
        for (std::size_t phase = 0; phase < all.size(); ++phase)
            all[phase] = stopwatch_->processor_seconds(static_cast<Phase>(phase));
        comm_->sum(all);
        for (std::size_t phase = 0; phase < all.size(); ++phase)
            all[phase] += before_[phase];
        return all;
    }

    /// A run that goes on counts on. Collective.
    void keep(Archive& archive)
    {
        if (archive.loads() && !archive.has("seconds")) return;  // of a version that did not count it
        Scalars all = archive.loads() ? Scalars{} : seconds();
        archive.keep("seconds", all);
        if (archive.loads()) before_ = all;
    }

private:
    const Communicator* comm_;
    const Stopwatch* stopwatch_;
    Scalars before_ = Scalars(phase_names.size(), 0.0);
};

}  // namespace interphase
