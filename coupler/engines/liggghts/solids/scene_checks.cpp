// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/scene_checks.hpp"

#include "atom.h"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "domain.h"
#include "engines/liggghts/solids/contact_check.hpp"
#include "engines/liggghts/solids/independent_spheres.hpp"
#include "engines/liggghts/solids/integrators.hpp"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"

namespace interphase {

namespace {

void refuse_doubtful_collisions(const LAMMPS_NS::LAMMPS& lmp, const Settings& settings,
                                const std::vector<LoadedPlugin>& plugins)
{
    if (!settings.method.collisions_of_plugin) return;
    const std::string& method = settings.method.name;
    if (!PluginFixes(lmp, plugins, settings.script).any()) {
        std::vector<std::string> styles;
        for (const LoadedPlugin& plugin : plugins)
            styles.insert(styles.end(), plugin.styles.begin(), plugin.styles.end());
        throw UserError("no fix of a plug-in is in the script, so with method " + method + " nothing would collide",
                        settings.script, "add a fix of one of these styles: " + listed(styles));
    }
    const std::string pair = lmp.force->pair ? lmp.force->pair_style : "";
    if (!settings.method.bears_pair_style && pair.rfind("gran", 0) == 0)
        throw UserError("the script has pair style " + pair + ", and method " + method +
                            " has collisions of its own: each would count twice",
                        settings.script, "leave the pair style away for this method, or take DEM or CGPM");
}

void refuse_bodiless_particles(const Communicator& comm, const LAMMPS_NS::LAMMPS& lmp, const Settings& settings)
{
    std::optional<Problem> problem;
    const LAMMPS_NS::Atom& atom = *lmp.atom;
    for (int i = 0; i < atom.nlocal && !problem; ++i)
        if (!(atom.radius[i] > 0 && atom.rmass[i] > 0))
            problem = Problem{"particle " + std::to_string(atom.tag[i]) + " has a radius of " + text(atom.radius[i]) +
                                  " m and a mass of " + text(atom.rmass[i]) + " kg",
                              settings.script, "give diameters and densities above 0, in m and kg/m3"};
    comm.fail_together(problem);
}

}  // namespace

void refuse_unusable_scene(const Communicator& comm, LAMMPS_NS::LAMMPS& lmp, const Settings& settings,
                           const std::vector<LoadedPlugin>& plugins)
{
    const std::string& script = settings.script;
    if (!lmp.domain->box_exist)
        throw UserError("the script defines no simulation box", script, "add create_box or read_data");
    if (!lmp.atom->sphere_flag)
        throw UserError("the particles are not spheres with their own radius and mass", script,
                        "use `atom_style granular` (or sphere)");
    if (settings.gas != GasModel::none && lmp.domain->triclinic)
        throw UserError("the box is triclinic, and particles are followed through straight periodic sides only", script,
                        "use a box of region style block");
    if (std::string(lmp.update->unit_style) != "si")
        throw UserError(std::string("the script computes in units `") + lmp.update->unit_style + "`", script,
                        "add `units si`: the gas is in SI units");
    if (settings.gas != GasModel::none)
        if (const auto problem = dependent_spheres(lmp, script)) throw UserError(*problem);
    comm.fail_together(moved_twice(lmp, script));
    if (settings.gas != GasModel::none && lmp.modify->find_fix_style_strict("freeze", 0))
        throw UserError("fix freeze clears forces before the fluid force is added, so the particles would drift",
                        script, "hold particles by leaving them out of the integrator's group instead");
    if (const auto problem = unphysical_contact(lmp, script)) throw UserError(*problem);
    refuse_doubtful_collisions(lmp, settings, plugins);
    refuse_bodiless_particles(comm, lmp, settings);
}

}  // namespace interphase
