// SPDX-License-Identifier: GPL-3.0-or-later
// Commands of LIGGGHTS at a time of the run.
#include <algorithm>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "engines/liggghts/plugins/fix_registration.hpp"
#include "engines/liggghts/plugins/plugin_fixes.hpp"
#include "engines/liggghts/solids/contact_duration.hpp"
#include "engines/liggghts/solids/fix_fluid.hpp"
#include "engines/liggghts/solids/fix_population.hpp"
#include "engines/liggghts/solids/liggghts_solids.hpp"
#include "engines/liggghts/solids/scene_checks.hpp"
#include "engines/liggghts/solids/weight_property.hpp"
#include "fix_gravity.h"
#include "integrate.h"
#include "lammps.h"
#include "library.h"
#include "modify.h"
#include "output.h"
#include "plugin/plugin.hpp"
#include "update.h"

namespace interphase {

namespace {

constexpr const char *population_id = "interphase_population", *fluid_id = "interphase";

/// Adds a fix of the coupler's own for all particles.
template <class Own>
Own* add_fix(LAMMPS_NS::LAMMPS& lmp, const std::string& id)
{
    const FixCreator create = [](LAMMPS_NS::LAMMPS* of, int narg, char** arg) -> LAMMPS_NS::Fix* {
        return new Own(of, narg, arg);
    };
    register_fix_style(*lmp.modify, Own::style_name, create);
    lammps_command(&lmp, ("fix " + id + " all " + Own::style_name).c_str());
    return dynamic_cast<Own*>(lmp.modify->find_fix_id(id.c_str()));
}

}  // namespace

void LiggghtsSolids::add_own_fixes(bool with_gas)
{
    population_ = add_fix<FixPopulation>(*lmp_, population_id);
    if (with_gas) fluid_ = add_fix<FixFluid>(*lmp_, fluid_id);  // the last one: it answers to all other forces
}

void LiggghtsSolids::carry_out(const std::vector<TimedCommands>& commands)
{
    for (const TimedCommands& each : commands) {
        counters_.let_go();
        for (const std::string& line : each.lines)
            lammps_command(lmp_, const_cast<char*>(line.c_str()));
        counters_.follow(PluginFixes(*lmp_, plugins_, place_of_commands), plugins_, place_of_commands);
    }
}

void LiggghtsSolids::repeat_commands()
{
    if (commands_.done().empty()) return;
    // In the run that did them they came after LIGGGHTS's first init(), which makes fixes, too.
    lmp_->update->whichflag = 1;
    lmp_->init();
    lmp_->update->whichflag = 0;
    carry_out(commands_.done());
}

std::vector<std::string> LiggghtsSolids::begin_gas_step(double time)
{
    const std::vector<TimedCommands> due = commands_.due(time);
    if (due.empty()) return {};
    const LastWords of_liggghts(comm_.is_master());

    // Fixes act in the order in which they were made, and ours come last: they are made anew behind those of commands.
    const long seen_late = population_->seen_late();
    const bool with_gas = fluid_ != nullptr;
    if (with_gas) fluid_->hold(lmp_->update->dt);
    const FixFluid::State fluid = with_gas ? fluid_->state() : FixFluid::State{};
    if (with_gas) lmp_->modify->delete_fix(fluid_id);
    lmp_->modify->delete_fix(population_id);
    lmp_->update->whichflag = 0;  // as between two runs of a script
    carry_out(due);
    add_own_fixes(with_gas);
    if (with_gas) fluid_->take(fluid);
    population_->count_seen_late(seen_late);
    // LIGGGHTS would take all particles for new to a fix that is
    for (LAMMPS_NS::Fix* fix : {static_cast<LAMMPS_NS::Fix*>(population_), static_cast<LAMMPS_NS::Fix*>(fluid_)})
        if (fix) fix->just_created = 0;
    refuse_other_scene();

    lmp_->update->whichflag = 1;
    lmp_->init();
    population_->watch(fluid_);
    lmp_->update->integrate->setup_minimal(1);
    lmp_->output->setup(0);
    population_->begin_anew();

    std::vector<std::string> done;
    for (const TimedCommands& each : due)
        for (const std::string& line : each.lines)
            done.push_back(each.name + ": " + line);
    return done;
}

void LiggghtsSolids::refuse_other_scene()
{
    const std::string where = place_of_commands;
    refuse_unusable_scene(comm_, *lmp_, settings_, plugins_);
    const PluginFixes of_plugins(*lmp_, plugins_, settings_.script);
    if (weight_property(*lmp_, settings_.script) != weights_ || of_plugins.solid_stress() != solid_stress_ ||
        of_plugins.say(extract_moves_before_forces) != moves_come_first_ ||
        of_plugins.say(extract_takes_new_forces) != takes_new_forces_)
        throw UserError("the commands change what moves the particles, or what weights they have", where,
                        "keep the fixes that do, and the method, for the whole run");
    if (const auto limit = of_plugins.step_limit(comm_); limit && lmp_->update->dt > *limit * (1 + 1e-9))
        throw UserError("a fix of the commands bears a solid step of at most " + text(*limit) + " s, and the run has " +
                            text(lmp_->update->dt) + " s",
                        where, "give `solidStep` in `particles`, at most that");
    Vector gravity = Vector::Zero();
    if (auto* fix = dynamic_cast<LAMMPS_NS::FixGravity*>(lmp_->modify->find_fix_style("gravity", 0)))
        fix->get_gravity(gravity.data());
    if (!gravity.isApprox(gravity_) && (gravity - gravity_).norm() > 0)
        throw UserError("the commands change gravity from " + text(gravity_) + " to " + text(gravity) +
                            " m/s2, and the gas has that of constant/g",
                        where, "leave fix gravity as the script has it");

    const std::vector<SpheresToCome> now = spheres_to_come(*lmp_);
    for (const SpheresToCome& spheres : now)
        if (spheres.largest_radius > largest_known_radius_ * (1 + 1e-9))
            throw UserError("the commands insert spheres with a radius of " + text(spheres.largest_radius) + " m; " +
                                text(largest_known_radius_) + " m is the largest that was known at the start",
                            where,
                            "let the script have a fix insert/* with a template as large, so that the run is laid out "
                            "for it");
    if (contact_duration_) {
        const std::optional<double> contact = shortest_contact(*lmp_, now);
        if (contact && *contact < *contact_duration_ * (1 - 1e-6))
            throw UserError("with the commands the shortest collision lasts " + text(*contact) + " s, less than the " +
                                text(*contact_duration_) + " s for which the solid step was chosen",
                            where, "give `solidStep` in `particles` for it");
    }
    to_come_ = now;
}

}  // namespace interphase
