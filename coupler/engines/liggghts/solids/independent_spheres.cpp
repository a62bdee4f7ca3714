// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/independent_spheres.hpp"

#include <mpi.h>

#include <string>

#include "atom.h"
#include "fix.h"
#include "lammps.h"
#include "modify.h"

namespace interphase {

namespace {

bool starts_with(const std::string& word, const char* start) { return word.rfind(start, 0) == 0; }

/// What a fix makes of spheres; null where it leaves them single.
const char* made_by(const LAMMPS_NS::Fix& fix)
{
    const std::string style = fix.style;
    if (fix.rigid_flag || starts_with(style, "rigid") || starts_with(style, "poems"))
        return "ties spheres together to rigid bodies";
    if (starts_with(style, "multisphere") || starts_with(style, "particletemplate/multi"))
        return "makes clumps of overlapping spheres";
    if (starts_with(style, "particletemplate/") && style != "particletemplate/sphere")
        return "makes particles that are not spheres";
    if (starts_with(style, "bond")) return "bonds spheres to each other";
    return nullptr;
}

}  // namespace

std::optional<Problem> dependent_spheres(const LAMMPS_NS::LAMMPS& lmp, const std::string& script)
{
    const std::string consequence =
        ": their solid volume would be counted sphere by sphere, overlaps twice, and each sphere would have the drag "
        "of a free one";
    const std::string remedy = "use single spheres, or `gas { model none; }` for the particles by themselves";
    for (int i = 0; i < lmp.modify->nfix; ++i) {
        const LAMMPS_NS::Fix& fix = *lmp.modify->fix[i];
        if (const char* made = made_by(fix))
            return Problem{std::string("fix ") + fix.id + " (" + fix.style + ") " + made + consequence, script, remedy};
    }
    const std::string atoms = lmp.atom->atom_style ? lmp.atom->atom_style : "";
    for (const char* shape : {"superquadric", "convexhull", "ellipsoid", "line", "tri", "body"})
        if (atoms.find(shape) != std::string::npos)
            return Problem{"atom_style " + atoms + " makes particles that are not spheres" + consequence, script,
                           remedy};
    if (lmp.atom->nbonds > 0)
        return Problem{std::to_string(lmp.atom->nbonds) + " bonds tie spheres to each other" + consequence, script,
                       remedy};
    return std::nullopt;
}

}  // namespace interphase
