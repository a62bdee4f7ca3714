// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/contact_duration.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "atom.h"
#include "engines/liggghts/solids/pair_property.hpp"
#include "force.h"
#include "lammps.h"
#include "pair_gran.h"

namespace interphase {

namespace {

std::vector<double> lightest_of_each_type(LAMMPS_NS::LAMMPS& lmp, const std::vector<SpheresToCome>& to_come)
{
    const LAMMPS_NS::Atom& atom = *lmp.atom;
    std::vector<double> lightest(static_cast<std::size_t>(atom.ntypes), std::numeric_limits<double>::max());
    for (int i = 0; i < atom.nlocal; ++i) {
        double& mass = lightest[static_cast<std::size_t>(atom.type[i] - 1)];
        mass = std::min(mass, atom.rmass[i]);
    }
    for (const SpheresToCome& spheres : to_come) {
        double& mass = lightest.at(static_cast<std::size_t>(spheres.type - 1));
        mass = std::min(mass, spheres.lightest());
    }
    MPI_Allreduce(MPI_IN_PLACE, lightest.data(), atom.ntypes, MPI_DOUBLE, MPI_MIN, lmp.world);
    return lightest;
}

/// How long two bodies of effective mass m [kg] touch [s]; 0 where they never part.
class Contact {
public:
    explicit Contact(LAMMPS_NS::LAMMPS& lmp)
        : stiffness_(pair_property(lmp, "kn")),
          restitution_(lmp.force->pair ? nullptr : pair_property(lmp, "coefficientRestitution")),
          absolute_(pair_property(lmp, "gamman_abs")),
          per_mass_(pair_property(lmp, "gamman"))
    {
        // of others kn is no spring [N/m], and contacts last shorter the faster they are
        auto* pair = dynamic_cast<LAMMPS_NS::PairGran*>(lmp.force->pair);
        if (pair && !pair->contact_match("normal", "hooke/stiffness")) stiffness_ = nullptr;
    }

    bool is_known() const { return stiffness_ && (restitution_ || absolute_ || per_mass_); }

    double duration(int i, int j, double m) const
    {
        const double k = stiffness_[i][j];
        if (restitution_) {
            // e = 0 would last for ever; taken as undamped it asks for the shortest step that any e does
            const double log_e = restitution_[i][j] > 0 ? std::log(restitution_[i][j]) : 0;
            return std::sqrt(m / k * (M_PI * M_PI + log_e * log_e));
        }
        const double half_rate = absolute_ ? absolute_[i][j] / (2 * m) : per_mass_[i][j] / 2;
        const double squared = k / m - half_rate * half_rate;
        return squared > 0 ? M_PI / std::sqrt(squared) : 0;
    }

private:
    const double* const* stiffness_;
    const double* const* restitution_;
    const double* const* absolute_;
    const double* const* per_mass_;
};

}  // namespace

std::optional<double> shortest_contact(LAMMPS_NS::LAMMPS& lmp, const std::vector<SpheresToCome>& to_come)
{
    const Contact contact(lmp);
    if (!contact.is_known()) return std::nullopt;

    const std::vector<double> mass = lightest_of_each_type(lmp, to_come);
    constexpr double none = std::numeric_limits<double>::max();
    double shortest = none;
    for (int i = 0; i < lmp.atom->ntypes; ++i)
        for (int j = 0; j < lmp.atom->ntypes; ++j) {
            const double mi = mass[static_cast<std::size_t>(i)], mj = mass[static_cast<std::size_t>(j)];
            if (std::max(mi, mj) == none) continue;
            const double duration = contact.duration(i, j, mi * mj / (mi + mj));
            if (duration > 0) shortest = std::min(shortest, duration);
        }
    if (shortest == none) return std::nullopt;
    return shortest;
}

}  // namespace interphase
