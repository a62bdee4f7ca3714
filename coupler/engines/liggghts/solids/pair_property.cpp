// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/pair_property.hpp"

#include <mpi.h>

#include "atom.h"
#include "fix_property_global.h"
#include "lammps.h"
#include "modify.h"

namespace interphase {

const double* const* pair_property(LAMMPS_NS::LAMMPS& lmp, const char* name)
{
    const int types = lmp.atom->ntypes;
    LAMMPS_NS::Fix* fix =
        lmp.modify->find_fix_property(name, "property/global", "peratomtypepair", types, types, "interphase", false);
    auto* property = dynamic_cast<LAMMPS_NS::FixPropertyGlobal*>(fix);
    return property ? property->get_array() : nullptr;
}

}  // namespace interphase
