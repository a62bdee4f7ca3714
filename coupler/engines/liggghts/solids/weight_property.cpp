// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/weight_property.hpp"

#include <mpi.h>

#include "base/user_error.hpp"
#include "fix_property_atom.h"
#include "fix_property_global.h"
#include "lammps.h"
#include "modify.h"

namespace interphase {

namespace {

constexpr const char* name = "weight";
constexpr const char* remedy =
    "write `fix ID all property/atom weight scalar yes no no W` (W: the default, of those that get no other)";

/// Whether the fix, of property/atom or property/global, gives a property of that name; any kind fits "".
template <class PropertyFix>
bool gives(LAMMPS_NS::Fix& fix, const char* kind)
{
    auto* property = dynamic_cast<PropertyFix*>(&fix);
    return property && property->check_fix(name, kind, 0, 0, "interphase", false);
}

}  // namespace

const LAMMPS_NS::Fix* weight_property(LAMMPS_NS::LAMMPS& lmp, const std::string& script)
{
    const LAMMPS_NS::Fix* found = nullptr;
    for (int i = 0; i < lmp.modify->nfix; ++i) {
        LAMMPS_NS::Fix& fix = *lmp.modify->fix[i];
        const bool is_number_of_each = gives<LAMMPS_NS::FixPropertyAtom>(fix, "scalar");
        if (!is_number_of_each && !gives<LAMMPS_NS::FixPropertyAtom>(fix, "") &&
            !gives<LAMMPS_NS::FixPropertyGlobal>(fix, ""))
            continue;
        const std::string where = script + ", fix " + fix.id + " " + fix.style;
        if (!is_number_of_each)
            throw UserError("the property `weight` is not one number of each particle", where, remedy);
        if (!fix.create_attribute)
            throw UserError("the property `weight` has no default: particles without another would get any number",
                            where, remedy);
        if (!fix.restart_peratom)
            throw UserError(
                "the property `weight` would not go into restart files: particles read from one would "
                "silently stand for another number of real ones",
                where, remedy);
        found = &fix;  // LIGGGHTS knows a name once
    }
    return found;
}

}  // namespace interphase
