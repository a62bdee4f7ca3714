// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/archive.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// Into `archive`, rank by rank: each particle as LIGGGHTS packs it for another rank, which is with all that fixes,
/// also those of plug-ins, and contacts know of it; its force and torque; the step number; of fixes what they write
/// into restart files (LIGGGHTS's Fix::write_restart) and when they act next. Between two steps. Collective.
void take_particle_state(LAMMPS_NS::LAMMPS& lmp, Archive& archive);

/// After the script and before LIGGGHTS's init(): the number of the step that was kept, so that what is due every so
/// many steps goes on.
void take_up_step(LAMMPS_NS::LAMMPS& lmp, Archive& archive);

/// The kept state in place of the particles that are there, after LIGGGHTS's setup(). The script's fixes are those of
/// the kept run; the ranks may not be. Neighbour lists are made anew, random numbers go on from the kept seeds: the
/// same whether the particles before were the kept ones or others, so that a run that puts back its own state goes on
/// as a later one that starts from it. A UserError where the script does not belong to the state. Collective.
void put_back_particle_state(LAMMPS_NS::LAMMPS& lmp, Archive& archive, const std::string& script);

}  // namespace interphase
