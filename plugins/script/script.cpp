// SPDX-License-Identifier: GPL-3.0-or-later
#include "script/script.hpp"

#include <string>

#include "atom.h"
#include "base/text.hpp"
#include "error.h"
#include "fix_property_global.h"
#include "input.h"
#include "modify.h"
#include "variable.h"

namespace interphase::script {

namespace {

void complain(LAMMPS_NS::LAMMPS& lmp, const LAMMPS_NS::Fix& fix, const std::string& what)
{
    lmp.error->all(FLERR, ("Fix " + std::string(fix.style) + what).c_str());
}

}  // namespace

void refuse_other_integrators(LAMMPS_NS::LAMMPS& lmp, const LAMMPS_NS::Fix& fix)
{
    for (int k = 0; k < lmp.modify->nfix; ++k) {
        const LAMMPS_NS::Fix& other = *lmp.modify->fix[k];
        if (&other != &fix && other.time_integrate)
            complain(lmp, fix,
                     std::string(" moves the particles itself, but fix ") + other.id + " (" + other.style +
                         ") does, too. Remove one of them");
    }
}

void read_between_types(LAMMPS_NS::LAMMPS& lmp, const LAMMPS_NS::Fix& fix, const char* name, const Bounds& bounds,
                        const std::function<void(int, int, double)>& take)
{
    const int types = lmp.atom->ntypes;
    auto* property =
        lmp.modify->find_fix_property(name, "property/global", "peratomtypepair", types, types, fix.style, false);
    if (!property)
        complain(lmp, fix,
                 ": the script does not say the " + std::string(name) +
                     " of the materials; give `fix ID all property/global " + name + " peratomtypepair " +
                     std::to_string(types) + " ...`, " + std::to_string(types * types) + " numbers");
    const double* const* values = static_cast<LAMMPS_NS::FixPropertyGlobal*>(property)->get_array();
    for (int a = 0; a < types; ++a)
        for (int b = 0; b < types; ++b) {
            if (!(values[a][b] >= bounds.least && values[a][b] <= bounds.most))
                complain(lmp, fix,
                         ": fix property/global " + std::string(name) + " is " + std::to_string(values[a][b]) +
                             " between types " + std::to_string(a + 1) + " and " + std::to_string(b + 1) + "; give " +
                             text(bounds.least) + (bounds.most < unbounded ? " to " + text(bounds.most) : " or more"));
            take(a, b, values[a][b]);
        }
}

void sort_by_default(LAMMPS_NS::LAMMPS& lmp, double width)
{
    constexpr int liggghts_default = 1000;
    if (lmp.atom->sortfreq != liggghts_default) return;
    std::string words[] = {"sort", std::to_string(liggghts_default), std::to_string(width)};
    char* arguments[] = {words[0].data(), words[1].data(), words[2].data()};
    lmp.atom->modify_params(3, arguments);
}

void name_values(LAMMPS_NS::LAMMPS& lmp, const LAMMPS_NS::Fix& fix, const std::vector<std::string>& names)
{
    LAMMPS_NS::Variable& variables = *lmp.input->variable;
    for (std::size_t k = 0; k < names.size(); ++k) {
        std::string words[] = {std::string(fix.id) + "_" + names[k], "equal",
                               "f_" + std::string(fix.id) + "[" + std::to_string(k + 1) + "]"};
        if (variables.find(words[0].data()) >= 0) continue;
        char* arguments[] = {words[0].data(), words[1].data(), words[2].data()};
        variables.set(3, arguments);
    }
}

}  // namespace interphase::script
