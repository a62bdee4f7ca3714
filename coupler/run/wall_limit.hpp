// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace interphase {

/// The time that a run has by the wall clock, such as a batch system's: it ends early enough for one more step and its
/// output.
class WallLimit {
public:
    /// `limit` [s] from the start; 0: none.
    explicit WallLimit(double limit) : limit_(limit) {}

    /// A gas step with all that belongs to it took so long [s]; a checkpoint did.
    void stepped(double seconds) { longest_step_ = std::max(longest_step_, seconds); }
    void kept(double seconds) { longest_checkpoint_ = std::max(longest_checkpoint_, seconds); }

    /// Whether the run has to end now, at `wall` [s]: with two steps and two checkpoints like the longest so far, and
    /// a hundredth of the limit, kept back for what was not seen yet.
    bool reached(double wall) const
    {
        constexpr double least = 0.5;  // to write the fields and to end [s]
        return limit_ > 0 && wall + 2 * longest_step_ + 2 * longest_checkpoint_ + 0.01 * limit_ + least > limit_;
    }

private:
    double limit_;
    double longest_step_ = 0, longest_checkpoint_ = 0;
};

}  // namespace interphase
