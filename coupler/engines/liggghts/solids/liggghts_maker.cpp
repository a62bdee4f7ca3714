// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/liggghts_maker.hpp"

#include "engines/liggghts/plugins/own_methods.hpp"

namespace interphase {

Methods methods_of(const std::vector<OpenPlugin>& plugins)
{
    Methods all = own_methods();
    for (const OpenPlugin& plugin : plugins)
        all.insert(all.end(), plugin.methods.begin(), plugin.methods.end());
    return all;
}

std::vector<CountKind> counts_of(const std::vector<OpenPlugin>& plugins)
{
    std::vector<CountKind> all;
    for (const OpenPlugin& plugin : plugins)
        for (const Counter& counter : plugin.counters)
            all.push_back(kind_of(counter));
    return all;
}

Methods LiggghtsMaker::methods(const std::vector<std::string>& plugins) const
{
    return methods_of(open_plugins(comm_, plugins, "system/couplingDict, plugins"));
}

std::string LiggghtsMaker::plugin_with(const std::string& method) const
{
    for (const OpenPlugin& plugin : open_plugins_at_hand())
        for (const Method& brought : plugin.methods)
            if (brought.name == method) return plugin.name;
    return "";
}

std::unique_ptr<ParticleEngine> LiggghtsMaker::make(const Communicator& comm, const Settings& settings) const
{
    return std::make_unique<LiggghtsSolids>(comm, settings, later_);
}

}  // namespace interphase
