// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "base/problem.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// What in the script makes its particles something else than single spheres: clumps, rigid bodies, bonded spheres,
/// other shapes. Drag, voidage and the answer to a gas step would be those of free spheres that overlap.
std::optional<Problem> dependent_spheres(const LAMMPS_NS::LAMMPS& lmp, const std::string& script);

}  // namespace interphase
