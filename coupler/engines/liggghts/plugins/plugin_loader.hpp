// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/communicator.hpp"
#include "plugin/counter.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// A plug-in whose fix styles LIGGGHTS knows. Its library stays in the process until the end.
struct LoadedPlugin {
    std::string name, file;
    std::string sha256;  ///< of the file, when it was loaded
    std::vector<std::string> styles;
    std::vector<Counter> counters;
};

/// "hard_sphere (/path/libhard_sphere.so: tdhs, wall/tdhs)", or "none".
std::string described(const std::vector<LoadedPlugin>& plugins);

/// The one that brings this fix style, or null.
const LoadedPlugin* plugin_with(const std::string& style, const std::vector<LoadedPlugin>& plugins);

/// Loads plug-ins, named as find_plugin() wants them, and makes their fix styles known to this LIGGGHTS. Either all of
/// them on all ranks, or a UserError: what open_plugins() throws, or a style that LIGGGHTS has. `asked_by` says where
/// the user asked for them. Collective.
std::vector<LoadedPlugin> load_plugins(const Communicator& comm, LAMMPS_NS::LAMMPS& lmp,
                                       const std::vector<std::string>& wanted, const std::string& asked_by);

}  // namespace interphase
