// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "base/count.hpp"

namespace interphase {

/// Tells of each count once, when it first comes to be looked at: at the end of a long run it is too late to do
/// something about it. What is seen is the part since the call before, so that trouble late in a run is not hidden by
/// all the steps without.
class CountNews {
public:
    /// Gas steps from one look to the next. One step in which everything is off is 1 % of them, which does not count
    /// yet.
    static constexpr long steps_between_looks = 100;

    /// Whether it is time for a look, after so many gas steps since the start of the run.
    bool due(double gas_steps) const { return gas_steps - wholes_before_.gas_steps >= steps_between_looks; }

    /// What was counted before this part of the run, which is not told again.
    void begin_with(const std::vector<Count>& counts, const Wholes& wholes);

    /// From `counts` and `wholes` since the start of the run, a sentence for each count that is new.
    std::vector<std::string> of(const std::vector<Count>& counts, const Wholes& wholes);

private:
    std::vector<Count> before_;
    Wholes wholes_before_;
    std::set<std::string> told_;  ///< keys
};

}  // namespace interphase
