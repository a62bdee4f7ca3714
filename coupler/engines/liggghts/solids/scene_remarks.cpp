// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/scene_remarks.hpp"

#include <algorithm>

#include "atom.h"
#include "base/text.hpp"
#include "engines/liggghts/solids/elastic_spheres.hpp"
#include "engines/liggghts/solids/integrators.hpp"
#include "engines/liggghts/solids/overlaps.hpp"
#include "engines/liggghts/solids/solids_counts.hpp"
#include "fix.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"

namespace interphase {

SceneRemarks::SceneRemarks(const Communicator& comm, LAMMPS_NS::LAMMPS& lmp, const Settings& settings,
                           const std::vector<LoadedPlugin>& plugins)
    : comm_(comm),
      lmp_(lmp),
      settings_(settings),
      plugins_(plugins),
      may_touch_too_fast_(rayleigh_time(lmp).has_value())
{}

bool SceneRemarks::has_fix(const char* start_of_style) const
{
    const LAMMPS_NS::Modify& modify = *lmp_.modify;
    return std::any_of(modify.fix, modify.fix + modify.nfix, [start_of_style](const LAMMPS_NS::Fix* fix) {
        return std::string(fix->style).rfind(start_of_style, 0) == 0;
    });
}

std::vector<Problem> SceneRemarks::now()
{
    std::vector<Problem> all;
    if (!looked_at_) all = of_scene();
    if (looked_at_ && has_fix("insert/")) comm_.fail_together(moved_twice(lmp_, settings_.script));
    if (!looked_at_ || has_fix("insert/"))
        if (const auto problem = of_unmoved()) all.push_back(*problem);
    if (looked_at_ && may_touch_too_fast_)
        if (const auto problem = of_fast_contacts()) all.push_back(*problem);
    looked_at_ = true;
    return all;
}

std::vector<Problem> SceneRemarks::of_scene()
{
    std::vector<Problem> all = of_overlaps();
    const PluginFixes of_plugins(lmp_, plugins_, settings_.script);
    for (int i = 0; i < lmp_.modify->nfix; ++i) {
        const LAMMPS_NS::Fix& fix = *lmp_.modify->fix[i];
        constexpr int moving = LAMMPS_NS::FixConst::INITIAL_INTEGRATE | LAMMPS_NS::FixConst::FINAL_INTEGRATE;
        if (of_plugins.has(fix) && !fix.time_integrate && (lmp_.modify->fmask[i] & moving))
            all.push_back(Problem{std::string("fix ") + fix.id + " (" + fix.style +
                                      ") acts where integrators do, and does not say that it moves particles: if it "
                                      "does, another integrator would move them twice unseen",
                                  settings_.script,
                                  "set `time_integrate = 1;` in the constructor of a fix that moves "
                                  "particles"});
    }
    if (settings_.gas != GasModel::none && has_fix("move/mesh"))
        all.push_back(
            Problem{"a mesh of the particles moves (fix move/mesh), and the gas does not feel it: it flows "
                    "through the mesh as if that were not there, pushed only by the particles",
                    settings_.script,
                    "none is needed where the mesh is thin or slow beside the gas, or is a wall of the gas mesh, too, "
                    "that turns in its place (rotatingWallVelocity)"});
    return all;
}

std::vector<Problem> SceneRemarks::of_overlaps()
{
    constexpr double much = 0.05;  // of a radius; contact models are made for less
    std::vector<Problem> all;
    for (const Overlaps& found : overlaps(comm_, lmp_, much, settings_.method.single_collisions)) {
        overlaps_ += found.number;
        const bool pairs = found.particle[1] > 0;
        const std::string who = pairs ? " pairs of particles overlap" : " particles stand in the wall of " + found.with;
        all.push_back(Problem{
            std::to_string(found.number) + who + " by more than " + text(100 * much) +
                " % of a radius before the first step, the deepest by " + text(100 * found.deepest) + " %",
            settings_.script + ": particle " + std::to_string(found.particle[0]) + " at " + text(found.centre) +
                (pairs ? ", with particle " + std::to_string(found.particle[1]) : ""),
            pairs ? "make the particles smaller or less of them, or let them settle first: the overlaps burst apart"
                  : "check the numbers of the wall (zcylinder R X Y, ycylinder R Z X, xcylinder R Y Z) and where the "
                    "particles are"});
    }
    return all;
}

std::optional<Problem> SceneRemarks::of_unmoved()
{
    const long before = unmoved_;
    unmoved_ = comm_.sum(unmoved(lmp_));
    if (unmoved_ == 0 || before > 0) return std::nullopt;
    return Problem{"no fix of the script moves " + std::to_string(unmoved_) + " of the " +
                       std::to_string(static_cast<long>(lmp_.atom->natoms)) +
                       " particles: they stay where they are, whatever acts on them",
                   settings_.script,
                   "none where they are held on purpose; otherwise add an integrator (fix nve/sphere, or the "
                   "plug-in's) for a group that they are in"};
}

std::optional<Problem> SceneRemarks::of_fast_contacts()
{
    const double step = lmp_.update->dt, speed = largest_speed(lmp_);
    const auto contact = hertz_time(lmp_, 2 * speed);
    constexpr double least_steps = 10;  // per contact, as for springs
    if (!contact || step <= *contact / least_steps) return std::nullopt;
    if (++fast_steps_ > 1) return std::nullopt;
    return Problem{
        "two particles that meet head-on at the largest speed, " + text(speed) + " m/s each, touch for " +
            text(*contact) + " s by Hertz's law, " + text(*contact / step) + " solid steps of " + text(step) +
            " s: such collisions gain or lose energy",
        "system/couplingDict.particles, solidStep",
        "give at most a tenth, " + text(*contact / least_steps) + " s, or a lower youngsModulus in the script"};
}

std::vector<Count> SceneRemarks::counts() const
{
    std::vector<Count> all;
    const auto add = [&all](const CountKind& kind, long number) {
        if (number > 0) all.push_back({kind, number});
    };
    add(overlaps_at_start, overlaps_);
    add(particles_unmoved, unmoved_);
    add(fast_contacts, fast_steps_);
    return all;
}

}  // namespace interphase
