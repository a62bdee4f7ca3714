// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/elastic_spheres.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "atom.h"
#include "base/sphere.hpp"
#include "fix_property_global.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"

namespace interphase {

namespace {

constexpr double none = std::numeric_limits<double>::max();

const double* type_property(LAMMPS_NS::LAMMPS& lmp, const char* name)
{
    LAMMPS_NS::Fix* fix =
        lmp.modify->find_fix_property(name, "property/global", "peratomtype", lmp.atom->ntypes, 0, "interphase", false);
    auto* property = dynamic_cast<LAMMPS_NS::FixPropertyGlobal*>(fix);
    return property ? property->get_values() : nullptr;
}

/// The least of `time(i, Young's modulus, Poisson's ratio)` over the particles of all ranks.
template <class Time>
std::optional<double> shortest(LAMMPS_NS::LAMMPS& lmp, const Time& time)
{
    if (!lmp.force->pair) return std::nullopt;
    const double* young = type_property(lmp, "youngsModulus");
    const double* poisson = type_property(lmp, "poissonsRatio");
    if (!young || !poisson) return std::nullopt;
    double least = none;
    for (int i = 0; i < lmp.atom->nlocal; ++i) {
        const int type = lmp.atom->type[i] - 1;
        least = std::min(least, time(i, young[type], poisson[type]));
    }
    MPI_Allreduce(MPI_IN_PLACE, &least, 1, MPI_DOUBLE, MPI_MIN, lmp.world);
    if (least == none) return std::nullopt;
    return least;
}

}  // namespace

std::optional<double> rayleigh_time(LAMMPS_NS::LAMMPS& lmp)
{
    const LAMMPS_NS::Atom& atom = *lmp.atom;
    return shortest(lmp, [&](int i, double young, double poisson) {
        const double radius = atom.radius[i], density = atom.rmass[i] / sphere_volume(radius);
        const double shear = young / (2 * (1 + poisson));
        return M_PI * radius * std::sqrt(density / shear) / (0.1631 * poisson + 0.8766);
    });
}

std::optional<double> hertz_time(LAMMPS_NS::LAMMPS& lmp, double speed)
{
    if (!(speed > 0)) return std::nullopt;
    const LAMMPS_NS::Atom& atom = *lmp.atom;
    return shortest(lmp, [&](int i, double young, double poisson) {
        const double mass = atom.rmass[i] / 2, radius = atom.radius[i] / 2;
        const double modulus = young / (2 * (1 - poisson * poisson));
        return 2.868 * std::pow(mass * mass / (radius * modulus * modulus * speed), 0.2);
    });
}

double largest_speed(LAMMPS_NS::LAMMPS& lmp)
{
    double squared = 0;
    for (int i = 0; i < lmp.atom->nlocal; ++i) {
        const double* v = lmp.atom->v[i];
        squared = std::max(squared, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    MPI_Allreduce(MPI_IN_PLACE, &squared, 1, MPI_DOUBLE, MPI_MAX, lmp.world);
    return std::sqrt(squared);
}

}  // namespace interphase
