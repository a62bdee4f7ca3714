// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// Seeds anew, by the number of the step, what LIGGGHTS saves nowhere: the random numbers of regions and meshes, by
/// which fixes insert/* draw places. Those of fixes they save themselves.
void seed_places(LAMMPS_NS::LAMMPS& lmp);

}  // namespace interphase
