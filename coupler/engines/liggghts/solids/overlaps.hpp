// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/communicator.hpp"

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace interphase {

/// Overlaps of spheres with each other or with a wall.
struct Overlaps {
    std::string with;      ///< "each other", or the wall
    long number = 0;       ///< of pairs, of all ranks
    double deepest = 0;    ///< over the (smaller) radius
    int particle[2] = {};  ///< of the deepest; the second is 0 for a wall
    Vector centre;         ///< of the first of them [m]
};

/// Those deeper than `least` of a radius; kinds without any are left out. `among_particles`: also of pairs. After
/// LIGGGHTS has set up its lists. Collective.
std::vector<Overlaps> overlaps(const Communicator& comm, LAMMPS_NS::LAMMPS& lmp, double least, bool among_particles);

}  // namespace interphase
