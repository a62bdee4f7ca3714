// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/problem.hpp"
#include "engines/liggghts/plugins/plugin_loader.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// What of a script makes state that LIGGGHTS gives nobody to save (meshes that move, a box that changes): such a scene
/// cannot go on from a checkpoint.
std::optional<Problem> unkept_state(LAMMPS_NS::LAMMPS& lmp, const std::string& script);

/// Fixes of the script that remember something which is lost with the program, and go on without: "ID (style: what)",
/// separated by commas; empty where there are none.
std::string memories_not_kept(LAMMPS_NS::LAMMPS& lmp, const std::vector<LoadedPlugin>& plugins);

}  // namespace interphase
