// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/insertions.hpp"

#include <mpi.h>

#include <cstring>

#include "base/sphere.hpp"
#include "fix_insert.h"
#include "fix_particledistribution_discrete.h"
#include "fix_template_sphere.h"
#include "lammps.h"
#include "modify.h"

namespace interphase {

namespace detail {

// What a fix insert/* gives to its particles by `set_property` is private; see fix_registration.hpp for how it is read.
template <char* LAMMPS_NS::FixInsert::*Name, double LAMMPS_NS::FixInsert::*Value>
struct SetPropertyAccess {
    friend const char* name_of_property(LAMMPS_NS::FixInsert& fix) { return fix.*Name; }
    friend double value_of_property(LAMMPS_NS::FixInsert& fix) { return fix.*Value; }
};

const char* name_of_property(LAMMPS_NS::FixInsert& fix);
double value_of_property(LAMMPS_NS::FixInsert& fix);
template struct SetPropertyAccess<&LAMMPS_NS::FixInsert::property_name, &LAMMPS_NS::FixInsert::fix_property_value>;

}  // namespace detail

namespace {

std::optional<double> weight_given_by(LAMMPS_NS::FixInsert& fix)
{
    const char* name = detail::name_of_property(fix);
    if (!name || std::strcmp(name, "weight") != 0) return std::nullopt;
    return detail::value_of_property(fix);
}

/// The densities of a template, which it keeps to itself and its kind.
struct Densities : LAMMPS_NS::FixTemplateSphere {
    static double lowest(LAMMPS_NS::FixTemplateSphere& of)
    {
        return LMP_PROBABILITY_NS::pdf_min(of.*(&Densities::pdf_density));
    }
};

}  // namespace

double SpheresToCome::lightest() const { return lowest_density * sphere_volume(smallest_radius); }

std::vector<SpheresToCome> spheres_to_come(LAMMPS_NS::LAMMPS& lmp)
{
    std::vector<SpheresToCome> all;
    for (int i = 0; i < lmp.modify->nfix; ++i) {
        auto* insertion = dynamic_cast<LAMMPS_NS::FixInsert*>(lmp.modify->fix[i]);
        if (!insertion || insertion->next_reneighbor <= 0) continue;  // none, or one that has made all of its own
        LAMMPS_NS::FixParticledistributionDiscrete* distribution = insertion->get_distribution();
        if (!distribution) continue;
        for (int n = 0; n < distribution->n_particletemplates(); ++n) {
            LAMMPS_NS::FixTemplateSphere& kind = *distribution->particletemplates()[n];
            all.push_back(
                {kind.mintype(), kind.min_rad(), kind.max_rad(), Densities::lowest(kind), weight_given_by(*insertion)});
        }
    }
    return all;
}

}  // namespace interphase
