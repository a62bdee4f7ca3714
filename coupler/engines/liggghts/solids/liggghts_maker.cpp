// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/liggghts_maker.hpp"

#include "engines/liggghts/plugins/own_methods.hpp"
#include "engines/liggghts/plugins/plugin_opener.hpp"

namespace interphase {

namespace {

Methods with_own(const std::vector<OpenPlugin>& plugins)
{
    Methods all = own_methods();
    for (const OpenPlugin& plugin : plugins)
        all.insert(all.end(), plugin.methods.begin(), plugin.methods.end());
    return all;
}

}  // namespace

Methods LiggghtsMaker::methods(const std::vector<std::string>& plugins) const
{
    return with_own(open_plugins(comm_, plugins, "system/couplingDict, plugins"));
}

Methods LiggghtsMaker::methods_at_hand() { return with_own(open_plugins_at_hand()); }

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

std::vector<CountKind> LiggghtsMaker::counts_of_plugins()
{
    std::vector<CountKind> all;
    for (const OpenPlugin& plugin : open_plugins_at_hand())
        for (const Counter& counter : plugin.counters)
            all.push_back(kind_of(counter));
    return all;
}

}  // namespace interphase
