// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/contact_duration.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "atom.h"
#include "engines/liggghts/pair_property.hpp"
#include "force.h"
#include "lammps.h"

namespace interphase {

namespace {

std::vector<double> lightest_of_each_type(LAMMPS_NS::LAMMPS& lmp)
{
    const LAMMPS_NS::Atom& atom = *lmp.atom;
    std::vector<double> lightest(static_cast<std::size_t>(atom.ntypes), std::numeric_limits<double>::max());
    for (int i = 0; i < atom.nlocal; ++i) {
        double& mass = lightest[static_cast<std::size_t>(atom.type[i] - 1)];
        mass = std::min(mass, atom.rmass[i]);
    }
    MPI_Allreduce(MPI_IN_PLACE, lightest.data(), atom.ntypes, MPI_DOUBLE, MPI_MIN, lmp.world);
    return lightest;
}

}  // namespace

std::optional<double> shortest_contact(LAMMPS_NS::LAMMPS& lmp)
{
    const auto* stiffness = pair_property(lmp, "kn");
    const auto* absolute = pair_property(lmp, "gamman_abs");
    const auto* per_mass = pair_property(lmp, "gamman");
    if (!lmp.force->pair || !stiffness || (!absolute && !per_mass)) return std::nullopt;

    const std::vector<double> mass = lightest_of_each_type(lmp);
    double shortest = std::numeric_limits<double>::max();
    for (int i = 0; i < lmp.atom->ntypes; ++i)
        for (int j = 0; j < lmp.atom->ntypes; ++j) {
            const double mi = mass[static_cast<std::size_t>(i)], mj = mass[static_cast<std::size_t>(j)];
            if (std::max(mi, mj) == std::numeric_limits<double>::max()) continue;
            const double m = mi * mj / (mi + mj);
            const double half_rate = absolute ? absolute[i][j] / (2 * m) : per_mass[i][j] / 2;
            const double squared = stiffness[i][j] / m - half_rate * half_rate;
            if (squared > 0) shortest = std::min(shortest, M_PI / std::sqrt(squared));
        }
    if (shortest == std::numeric_limits<double>::max()) return std::nullopt;
    return shortest;
}

}  // namespace interphase
