// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace interphase {

/// Where plug-ins are looked for by name, in this order: the folders of $INTERPHASE_PLUGIN_PATH (separated by ':'),
/// plugins/ beside the running program (a build folder), ../lib/interphase/plugins (an installation).
std::vector<std::string> plugin_folders();

/// The names under which libraries are there, sorted; whether they are plug-ins is not known yet.
std::vector<std::string> plugins_at_hand();

/// The file of a plug-in. With a slash in it, `wanted` is that file, from the current folder on; else lib<wanted>.so is
/// looked for in the plugin_folders(). Throws a UserError where there is none; `asked_by` is its "where".
std::string find_plugin(const std::string& wanted, const std::string& asked_by);

}  // namespace interphase
