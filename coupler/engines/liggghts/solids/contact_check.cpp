// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/contact_check.hpp"

#include <mpi.h>

#include <limits>

#include "atom.h"
#include "base/text.hpp"
#include "engines/liggghts/solids/pair_property.hpp"
#include "lammps.h"

namespace interphase {

namespace {

struct Demand {
    const char* property;
    bool zero_is_fine;
    const char* meaning;
    double most = std::numeric_limits<double>::max();
};

constexpr Demand demands[] = {
    {"kn", false, "a normal stiffness must be above 0"},
    {"kt", true, "a tangential stiffness must not be below 0"},
    {"gamman_abs", true, "collisions would gain energy, as with a restitution above 1"},
    {"gamman", true, "collisions would gain energy, as with a restitution above 1"},
    {"gammat_abs", true, "collisions would gain energy, as with a tangential restitution above 1"},
    {"gammat", true, "collisions would gain energy, as with a tangential restitution above 1"},
    {"coefficientFriction", true, "a friction coefficient must not be below 0"},
    {"coefficientRestitution", true, "a coefficient of restitution is a number from 0 to 1", 1},
};

}  // namespace

std::optional<Problem> unphysical_contact(LAMMPS_NS::LAMMPS& lmp, const std::string& script)
{
    for (const Demand& demand : demands) {
        const auto* values = pair_property(lmp, demand.property);
        if (!values) continue;
        for (int i = 0; i < lmp.atom->ntypes; ++i)
            for (int j = 0; j < lmp.atom->ntypes; ++j) {
                const double value = values[i][j];
                if ((value > 0 || (value == 0 && demand.zero_is_fine)) && value <= demand.most) continue;
                return Problem{"the property " + std::string(demand.property) + " is " + text(value) +
                                   " between types " + std::to_string(i + 1) + " and " + std::to_string(j + 1) + ": " +
                                   demand.meaning,
                               script + ", fix property/global",
                               "correct the property, or the numbers that the script makes it from "
                               "(particles/variables in system/couplingDict)"};
            }
    }
    return std::nullopt;
}

}  // namespace interphase
