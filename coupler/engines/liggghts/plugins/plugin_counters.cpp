// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/plugins/plugin_counters.hpp"

#include <algorithm>

#include "base/user_error.hpp"
#include "fix.h"
#include "plugin/plugin.hpp"

namespace interphase {

CountKind kind_of(const Counter& counter)
{
    CountKind kind{counter.key,    counter.text,   Whole::nothing,      counter.meaning, Worry::above,
                   counter.reason, counter.remedy, counter.worry_above, counter.unit};
    if (counter.worry_above == never_worry) kind.worry = Worry::never;
    if (counter.worry_above == 0) kind.worry = Worry::any;
    return kind;
}

double PluginCounters::Of::here() const
{
    double all = 0;
    for (const double* each : values)
        all = over_ranks == OverRanks::sum ? all + *each : std::max(all, *each);
    return all;
}

void PluginCounters::follow(const PluginFixes& fixes, const std::vector<LoadedPlugin>& plugins,
                            const std::string& script)
{
    for (LAMMPS_NS::Fix* fix : fixes.all()) {
        int dimension = 0;
        const auto* told = static_cast<const CounterValues*>(fix->extract(extract_counters, dimension));
        if (!told) continue;
        const LoadedPlugin& plugin = *plugin_with(fix->style, plugins);
        if (told->count != plugin.counters.size() || !told->values)
            throw UserError(std::string("fix ") + fix->id + " (" + fix->style + ") counts " +
                                std::to_string(told->count) + " things, and its plug-in " + plugin.name + " names " +
                                std::to_string(plugin.counters.size()),
                            script, "correct the plug-in's INTERPHASE_COUNTERS, or what its extract() gives");
        for (std::size_t k = 0; k < plugin.counters.size(); ++k) {
            const Counter& counter = plugin.counters[k];
            auto known = std::find_if(counters_.begin(), counters_.end(),
                                      [&](const Of& of) { return std::string(of.kind->key) == counter.key; });
            if (known == counters_.end()) {
                kinds_.push_back(kind_of(counter));
                known = counters_.insert(counters_.end(), {&kinds_.back(), counter.over_ranks, {}});
            }
            known->values.push_back(told->values + k);
        }
    }
    // what those that have stayed tell themselves
    for (Of& of : counters_)
        if (of.over_ranks == OverRanks::sum) of.of_gone = std::max(0.0, of.of_gone - of.here());
}

void PluginCounters::let_go()
{
    for (Of& of : counters_) {
        of.of_gone = of.over_ranks == OverRanks::sum ? of.of_gone + of.here() : std::max(of.of_gone, of.here());
        of.values.clear();
    }
}

std::vector<Count> PluginCounters::now(const Communicator& comm) const
{
    std::vector<Count> all;
    for (const Of& of : counters_) {
        const double value = of.over_ranks == OverRanks::sum ? comm.sum(of.of_gone + of.here())
                                                             : comm.max(std::max(of.of_gone, of.here()));
        all.push_back(Count::measured(*of.kind, value));
    }
    return all;
}

void PluginCounters::keep(Archive& archive)
{
    for (Of& of : counters_) {
        const std::string key = of.kind->key;
        if (archive.loads() && !archive.has(key)) continue;
        if (of.over_ranks == OverRanks::sum)
            archive.keep_share(key, of.of_gone);
        else
            archive.keep_largest(key, of.of_gone);
    }
}

}  // namespace interphase
