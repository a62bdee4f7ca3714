// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace interphase {

/// The script's `fix ID all property/atom weight scalar yes ...`, whose vector_atom holds the real particles that each
/// tracked one stands for; null where the script has none. Throws a UserError where a property of that name is no
/// number of each particle, has no default, or would be lost with a restart file.
const LAMMPS_NS::Fix* weight_property(LAMMPS_NS::LAMMPS& lmp, const std::string& script);

}  // namespace interphase
