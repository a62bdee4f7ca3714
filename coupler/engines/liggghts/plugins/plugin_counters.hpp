// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "base/count.hpp"
#include "engines/liggghts/plugins/plugin_fixes.hpp"
#include "engines/liggghts/plugins/plugin_loader.hpp"

namespace interphase {

/// The counter as the summary and the page of counts have it. Its texts are the plug-in's.
CountKind kind_of(const Counter& counter);

/// What the fixes of a run count (plugin/counter.hpp), also those that commands make and take away. Fixes that count
/// under the same key are taken together. A counter that was once there stays, in its place.
class PluginCounters {
public:
    /// Reads the counters of `fixes`, which stand in `script`, from now on. A UserError where a fix's answer does not
    /// fit its plug-in's counters.
    void follow(const PluginFixes& fixes, const std::vector<LoadedPlugin>& plugins, const std::string& script);
    /// To be called before fixes may go: what they have counted stays. follow() has to come next.
    void let_go();

    /// Of all ranks, now. The kinds live as long as this object. Collective.
    std::vector<Count> now(const Communicator& comm) const;

    /// What no fix keeps: counts of those that are gone.
    void keep(Archive& archive);

private:
    struct Of {
        const CountKind* kind;
        OverRanks over_ranks;
        std::vector<const double*> values;  ///< of the fixes on this rank
        double of_gone = 0;                 ///< of fixes that are no more, on this rank
        double here() const;                ///< of those that are, on this rank
    };
    std::list<CountKind> kinds_;  ///< stay where they are
    std::vector<Of> counters_;
};

}  // namespace interphase
