// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/plugins/plugin_loader.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "engines/liggghts/plugins/fix_registration.hpp"
#include "engines/liggghts/plugins/plugin_opener.hpp"
#include "lammps.h"
#include "plugin/plugin.hpp"

namespace interphase {

std::string described(const std::vector<LoadedPlugin>& plugins)
{
    std::string all;
    for (const LoadedPlugin& plugin : plugins)
        all += (all.empty() ? "" : ", ") + plugin.name + " (" + plugin.file + ": " + listed(plugin.styles) + ")";
    return all.empty() ? "none" : all;
}

const LoadedPlugin* plugin_with(const std::string& style, const std::vector<LoadedPlugin>& plugins)
{
    const auto found = std::find_if(plugins.begin(), plugins.end(), [&style](const LoadedPlugin& plugin) {
        return std::find(plugin.styles.begin(), plugin.styles.end(), style) != plugin.styles.end();
    });
    return found == plugins.end() ? nullptr : &*found;
}

std::vector<LoadedPlugin> load_plugins(const Communicator& comm, LAMMPS_NS::LAMMPS& lmp,
                                       const std::vector<std::string>& wanted, const std::string& asked_by)
{
    const std::vector<OpenPlugin> opened = open_plugins(comm, wanted, asked_by);
    std::vector<LoadedPlugin> loaded;
    for (const OpenPlugin& plugin : opened) {
        loaded.push_back({plugin.name, plugin.file, plugin.sha256, {}, plugin.counters});
        for (const PluginStyle* style : plugin.styles) {
            if (knows_fix_style(*lmp.modify, style->name))
                throw UserError(std::string("the fix style `") + style->name + "` of the plug-in " + plugin.name +
                                    " (" + plugin.file + ") is one of LIGGGHTS's own styles already",
                                asked_by, "give it another name");
            loaded.back().styles.emplace_back(style->name);
        }
    }
    for (const OpenPlugin& plugin : opened)
        for (const PluginStyle* style : plugin.styles)
            register_fix_style(*lmp.modify, style->name, style->create);
    return loaded;
}

}  // namespace interphase
