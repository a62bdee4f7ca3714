// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "base/problem.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// What is wrong with the spring and dashpot that `script` gives to the pair model hooke/stiffness, if anything:
/// negative damping (restitution above 1), a spring that pulls. LIGGGHTS checks restitution only where it is given as
/// such and a pair style of its own uses it.
std::optional<Problem> unphysical_contact(LAMMPS_NS::LAMMPS& lmp, const std::string& script);

}  // namespace interphase
