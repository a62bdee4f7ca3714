// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>

#include <algorithm>

#include "comm.h"

namespace interphase::contacts {

/// LIGGGHTS packs a sphere for another rank without a look at the room that there is. Asks it for what the sphere that
/// takes the most along needs, numbers(i) for sphere i of `spheres`, and returns that, of all ranks. Collective.
template <class Numbers>
int ask_for_room(LAMMPS_NS::Comm& comm, MPI_Comm world, int spheres, const Numbers& numbers)
{
    int most = 0;
    for (int i = 0; i < spheres; ++i)
        most = std::max(most, numbers(i));
    MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_INT, MPI_MAX, world);
    comm.maxexchange_fix = std::max(comm.maxexchange_fix, most);
    return most;
}

}  // namespace interphase::contacts
