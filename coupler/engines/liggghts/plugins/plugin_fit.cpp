// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/plugins/plugin_fit.hpp"

#include <algorithm>

namespace interphase {

namespace {

std::string value_of(const BuildFact& fact) { return fact.text ? fact.text : std::to_string(fact.number); }

const BuildFact* fact_of(const PluginDescriptor& plugin, const std::string& what)
{
    const BuildFact* end = plugin.facts + plugin.fact_count;
    const BuildFact* found = std::find_if(plugin.facts, end, [&](const BuildFact& fact) { return fact.what == what; });
    return found == end ? nullptr : found;
}

}  // namespace

std::optional<Misfit> misfit_of(const PluginDescriptor& plugin)
{
    if (plugin.interface_version != plugin_interface_version)
        return Misfit{"is built for version " + std::to_string(plugin.interface_version) +
                          " of the plug-in interface; this program has version " +
                          std::to_string(plugin_interface_version),
                      "build the plug-in anew with the interphase that is to load it"};

    std::string differences;
    for (const BuildFact& ours : build_facts()) {
        const BuildFact* theirs = fact_of(plugin, ours.what);
        const std::string found = theirs ? value_of(*theirs) : "not told";
        if (found == value_of(ours)) continue;
        differences += (differences.empty() ? "" : "; ") + std::string(ours.what) + ": " + found +
                       ", this program: " + value_of(ours);
    }
    if (differences.empty()) return std::nullopt;
    return Misfit{"is built against something else than this program (" + differences + ")",
                  "build the plug-in anew with the headers, compiler and MPI of the interphase that is to load it "
                  "(find_package(interphase) chooses the LIGGGHTS), or build interphase with those of the plug-in"};
}

}  // namespace interphase
