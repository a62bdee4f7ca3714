// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>
#include <string>
#include <vector>

#include "base/communicator.hpp"
#include "base/count.hpp"
#include "engines/liggghts/plugins/plugin_fixes.hpp"
#include "engines/liggghts/plugins/plugin_loader.hpp"

namespace interphase {

/// The counter as the summary and the page of counts have it. Its texts are the plug-in's.
CountKind kind_of(const Counter& counter);

/// What the fixes of a script count (plugin/counter.hpp). Fixes that count under the same key are taken together.
class PluginCounters {
public:
    /// A UserError where a fix's answer does not fit its plug-in's counters.
    PluginCounters(const PluginFixes& fixes, const std::vector<LoadedPlugin>& plugins, const std::string& script);

    /// Of all ranks, now. Collective.
    std::vector<Count> now(const Communicator& comm) const;

private:
    struct Of {
        const CountKind* kind;
        OverRanks over_ranks;
        std::vector<const double*> values;
    };
    std::list<CountKind> kinds_;  ///< stay where they are
    std::vector<Of> counters_;
};

}  // namespace interphase
