// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// A material property per pair of particle types [types x types], as the script's fix property/global ...
/// peratomtypepair gives it. Null where it gives none.
const double* const* pair_property(LAMMPS_NS::LAMMPS& lmp, const char* name);

}  // namespace interphase
