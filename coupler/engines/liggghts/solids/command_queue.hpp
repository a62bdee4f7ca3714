// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/archive.hpp"
#include "settings/settings.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// The commands that a case has for times of the run, and which of them have been done.
class CommandQueue {
public:
    explicit CommandQueue(const std::vector<TimedCommands>& commands) : commands_(commands) {}

    /// After the script: a UserError for commands that a run does not bear, or that name a fix which will not be there.
    void check(const LAMMPS_NS::LAMMPS& lmp) const;

    /// Those of a gas step that begins at `time` [s], of which a hundred millionth is round-off; they count as done.
    std::vector<TimedCommands> due(double time);

    /// Those that an earlier part of the run has done.
    std::vector<TimedCommands> done() const { return {commands_.begin(), commands_.begin() + done_}; }
    void keep(Archive& archive);

private:
    const std::vector<TimedCommands>& commands_;  ///< in the order of their times
    long done_ = 0;
};

/// Where a user finds them.
constexpr const char* place_of_commands = "system/couplingDict.particles.commands";

}  // namespace interphase
