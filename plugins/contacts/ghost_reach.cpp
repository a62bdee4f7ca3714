// SPDX-License-Identifier: GPL-3.0-or-later
#include "contacts/ghost_reach.hpp"

#include <mpi.h>

#include <algorithm>

#include "atom.h"
#include "comm.h"
#include "fix.h"
#include "modify.h"
#include "neighbor.h"

namespace interphase::contacts {

double GhostReach::largest_now() const
{
    double largest = 0;
    for (int i = 0; i < lmp_.atom->nlocal; ++i)
        largest = std::max(largest, lmp_.atom->radius[i]);
    MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, lmp_.world);
    return largest;
}

void GhostReach::begin()
{
    largest_radius_ = std::max(largest_radius_, largest_now());
    for (int k = 0; k < lmp_.modify->nfix; ++k)
        for (int type = 1; type <= lmp_.atom->ntypes; ++type)
            largest_radius_ = std::max(largest_radius_, lmp_.modify->fix[k]->max_rad(type));
}

/// Ghosts have just been fetched, and no list of neighbours is built yet. LIGGGHTS asks for distance() in setup() only.
void GhostReach::renew()
{
    const double largest = largest_now();
    if (largest <= largest_radius_) return;
    largest_radius_ = largest;
    lmp_.comm->setup();
    if (lmp_.neighbor->style) lmp_.neighbor->setup_bins();
    lmp_.comm->exchange();
    lmp_.comm->borders();
}

bool sizes_change(const LAMMPS_NS::LAMMPS& lmp)
{
    const LAMMPS_NS::Modify& modify = *lmp.modify;
    return std::any_of(modify.fix, modify.fix + modify.nfix,
                       [](const LAMMPS_NS::Fix* fix) { return fix->rad_mass_vary_flag != 0; });
}

}  // namespace interphase::contacts
