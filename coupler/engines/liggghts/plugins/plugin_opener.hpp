// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/communicator.hpp"
#include "plugin/counter.hpp"
#include "settings/method.hpp"

namespace interphase {

struct PluginStyle;

/// A plug-in whose library is in the process, where it stays until the end.
struct OpenPlugin {
    std::string name, file;
    std::string sha256;  ///< of the file
    std::vector<const PluginStyle*> styles;
    Methods methods;
    std::vector<Counter> counters;
};

/// Opens plug-ins, named as find_plugin() wants them. Either all of them on all ranks, or a UserError: no such library,
/// one that cannot be loaded, one that is no plug-in or is built against something else, names that nobody could use or
/// that two of them bring. `asked_by` says where the user asked for them. Collective.
std::vector<OpenPlugin> open_plugins(const Communicator& comm, const std::vector<std::string>& wanted,
                                     const std::string& asked_by);

/// Those of plugins_at_hand() that can be opened. Not collective.
std::vector<OpenPlugin> open_plugins_at_hand();

}  // namespace interphase
