// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/communicator.hpp"
#include "engines/liggghts/plugins/plugin_fixes.hpp"
#include "settings/settings.hpp"

namespace interphase {

/// Throws a UserError where what a script has made cannot be coupled, or would give numbers that are wrong without a
/// word. Collective.
void refuse_unusable_scene(const Communicator& comm, LAMMPS_NS::LAMMPS& lmp, const Settings& settings,
                           const std::vector<LoadedPlugin>& plugins);

}  // namespace interphase
