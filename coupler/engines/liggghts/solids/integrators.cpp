// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/integrators.hpp"

#include <mpi.h>

#include <vector>

#include "atom.h"
#include "base/text.hpp"
#include "fix.h"
#include "group.h"
#include "lammps.h"
#include "modify.h"

namespace interphase {

namespace {

std::vector<const LAMMPS_NS::Fix*> integrators(const LAMMPS_NS::LAMMPS& lmp)
{
    std::vector<const LAMMPS_NS::Fix*> found;
    for (int i = 0; i < lmp.modify->nfix; ++i)
        if (lmp.modify->fix[i]->time_integrate) found.push_back(lmp.modify->fix[i]);
    return found;
}

std::string named(const LAMMPS_NS::LAMMPS& lmp, const LAMMPS_NS::Fix& fix)
{
    return "fix " + std::string(fix.id) + " (" + fix.style + ", of group " + lmp.group->names[fix.igroup] + ")";
}

}  // namespace

std::optional<Problem> moved_twice(LAMMPS_NS::LAMMPS& lmp, const std::string& script)
{
    const LAMMPS_NS::Atom& atom = *lmp.atom;
    const auto moving = integrators(lmp);
    for (std::size_t a = 0; a < moving.size(); ++a)
        for (std::size_t b = a + 1; b < moving.size(); ++b) {
            const int both = moving[a]->groupbit | moving[b]->groupbit;
            long count = 0;
            int example = 0;
            for (int i = 0; i < atom.nlocal; ++i)
                if ((atom.mask[i] & both) == both && count++ == 0) example = atom.tag[i];
            if (count == 0 && moving[a]->groupbit != moving[b]->groupbit) continue;
            std::string what = named(lmp, *moving[a]) + " and " + named(lmp, *moving[b]) +
                               " both move the same particles: each would go twice its way in a step";
            if (count > 0) what += " (particle " + std::to_string(example) + " is one of them)";
            return Problem{what, script, "remove one of the two fixes, or give them groups without common particles"};
        }
    return std::nullopt;
}

long unmoved(LAMMPS_NS::LAMMPS& lmp)
{
    int bits = 0;
    for (const LAMMPS_NS::Fix* fix : integrators(lmp))
        bits |= fix->groupbit;
    long count = 0;
    for (int i = 0; i < lmp.atom->nlocal; ++i)
        if (!(lmp.atom->mask[i] & bits)) ++count;
    return count;
}

}  // namespace interphase
