// SPDX-License-Identifier: GPL-3.0-or-later
// The fix styles of LIGGGHTS 3.8.0 by what a checkpoint holds of them.
#include "engines/liggghts/solids/fix_states.hpp"

#include <algorithm>
#include <cstring>

#include "fix.h"
#include "lammps.h"
#include "modify.h"

namespace interphase {

namespace {

enum class Fate {
    nothing,  ///< to hold: what it does follows from the particles, the step and the script
    held,    ///< by what it packs with each particle, writes for restart files, or by random numbers that begin anew at
             ///< each checkpoint, in the run that wrote it as well (random_numbers.hpp)
    told,    ///< lost, and the particles go on without it
    refused  ///< lost, and the particles would not be those of the run
};

struct Style {
    const char* name;  ///< of the style, or with a * of all whose names begin so
    Fate fate;
    const char* what = "";
};

const char *const moves = "a mesh that moves, whose place LIGGGHTS takes up only while the script makes it",
                  *const sums = "sums", *const body = "bodies of several spheres",
                  *const other = "another program's data";

/// The first that fits counts.
const Style styles[] = {
    {"move/mesh*", Fate::refused, moves},
    {"mesh/surface/stress/6dof", Fate::refused, "a mesh that particles move"},
    {"mesh/surface/stress/servo", Fate::refused, "a mesh that particles move"},
    {"mesh/surface/stress/deform", Fate::refused, "a mesh that particles deform"},
    {"deform*", Fate::refused, "a box that changes"},
    {"box/relax", Fate::refused, "a box that changes"},
    {"dt/reset", Fate::refused, "a solid step that it changes"},
    {"couple/*", Fate::refused, other},
    {"rigid", Fate::refused, body},
    {"multisphere*", Fate::refused, body},
    {"concave", Fate::refused, body},
    {"ave/*", Fate::told, sums},
    {"mesh/surface/stress*", Fate::told, "forces on the mesh that it has summed up, and wear"},
    {"multicontact/halfspace", Fate::told, "forces of contacts in the last step"},
    {"nve/limit", Fate::told, "how often it has limited"},
    {"property/atom/regiontracer/time", Fate::held},
    {"property/atom/timetracer", Fate::held},
    {"property/atom/tracer*", Fate::told, "how many it has marked, and which it is to mark"},
    {"contacthistory*", Fate::held},
    {"contactproperty/*", Fate::held},
    {"insert/*", Fate::held},
    {"massflow/mesh*", Fate::held},
    {"move", Fate::held},
    {"particledistribution/*", Fate::held},
    {"particletemplate/*", Fate::held},
    {"property/atom", Fate::held},
    {"region/variable", Fate::held},
    {"spring/self", Fate::held},
    {"store/state", Fate::held},
    {"transportequation/scalar", Fate::held},
    {"STORE", Fate::held},
    {"mesh/surface*", Fate::nothing},
    {"neighlist/mesh*", Fate::nothing},
    {"nve*", Fate::nothing},
    {"wall/*", Fate::nothing},
    {"heat/gran*", Fate::nothing},
    {"check/timestep/*", Fate::nothing},
    {"property/*", Fate::nothing},
    {"custom_property/global", Fate::nothing},
    {"sph/*", Fate::nothing},
    {"adapt", Fate::nothing},
    {"addforce", Fate::nothing},
    {"aveforce", Fate::nothing},
    {"buoyancy", Fate::nothing},
    {"continuum/weighted", Fate::nothing},
    {"diam/max", Fate::nothing},
    {"drag", Fate::nothing},
    {"efield", Fate::nothing},
    {"enforce2d", Fate::nothing},
    {"external", Fate::nothing},
    {"freeze", Fate::nothing},
    {"gravity", Fate::nothing},
    {"lineforce", Fate::nothing},
    {"momentum", Fate::nothing},
    {"planeforce", Fate::nothing},
    {"print", Fate::nothing},
    {"setforce", Fate::nothing},
    {"spring", Fate::nothing},
    {"spring/rg", Fate::nothing},
    {"store/force", Fate::nothing},
    {"viscous", Fate::nothing},
};

bool fits(const Style& style, const char* name)
{
    const std::size_t length = std::strlen(style.name);
    return style.name[length - 1] == '*' ? std::strncmp(style.name, name, length - 1) == 0
                                         : std::strcmp(style.name, name) == 0;
}

/// Null for styles that are not LIGGGHTS's, and for those of another version.
const Style* known(const char* name)
{
    const auto* const found =
        std::find_if(std::begin(styles), std::end(styles), [name](const Style& style) { return fits(style, name); });
    return found == std::end(styles) ? nullptr : found;
}

/// Those of plug-ins write what they have to (plugins/README.md), and so do the coupler's own.
bool keeps_itself_else(const char* name, const std::vector<LoadedPlugin>& plugins)
{
    return std::strncmp(name, "interphase/", std::strlen("interphase/")) == 0 || plugin_with(name, plugins) != nullptr;
}

}  // namespace

std::optional<Problem> unkept_state(LAMMPS_NS::LAMMPS& lmp, const std::string& script)
{
    for (int n = 0; n < lmp.modify->nfix; ++n) {
        const LAMMPS_NS::Fix& fix = *lmp.modify->fix[n];
        const Style* style = known(fix.style);
        if (style && style->fate == Fate::refused)
            return Problem{
                std::string("a checkpoint cannot hold fix ") + fix.id + " (" + fix.style + "): " + style->what, script,
                "leave it away, or go without checkpoints"};
    }
    return std::nullopt;
}

std::string memories_not_kept(LAMMPS_NS::LAMMPS& lmp, const std::vector<LoadedPlugin>& plugins)
{
    std::string found;
    for (int n = 0; n < lmp.modify->nfix; ++n) {
        const LAMMPS_NS::Fix& fix = *lmp.modify->fix[n];
        const Style* style = known(fix.style);
        if (style ? style->fate != Fate::told : keeps_itself_else(fix.style, plugins)) continue;
        if (!found.empty()) found += ", ";
        found += std::string(fix.id) + " (" + fix.style + ": " + (style ? style->what : "what it may remember") + ")";
    }
    return found;
}

}  // namespace interphase
