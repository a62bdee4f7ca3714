// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/liggghts_solids.hpp"

#include <algorithm>
#include <climits>
#include <cstdio>
#include <limits>

#include "atom.h"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "domain.h"
#include "engines/liggghts/plugins/fix_registration.hpp"
#include "engines/liggghts/script/last_words.hpp"
#include "engines/liggghts/solids/contact_check.hpp"
#include "engines/liggghts/solids/contact_duration.hpp"
#include "engines/liggghts/solids/elastic_spheres.hpp"
#include "engines/liggghts/solids/fix_fluid.hpp"
#include "engines/liggghts/solids/fix_population.hpp"
#include "engines/liggghts/solids/independent_spheres.hpp"
#include "engines/liggghts/solids/integrators.hpp"
#include "engines/liggghts/solids/overlaps.hpp"
#include "engines/liggghts/solids/weight_property.hpp"
#include "fix_gravity.h"
#include "force.h"
#include "integrate.h"
#include "lammps.h"
#include "library.h"
#include "plugin/plugin.hpp"
#include "timer.h"
#include "universe.h"
#include "update.h"

namespace interphase {

namespace {

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

LiggghtsSolids::LiggghtsSolids(const Communicator& comm, const Settings& settings) : comm_(comm), settings_(settings)
{
    std::vector<std::string> words{"liggghts", "-screen", LastWords::log_name, "-log", "none", "-echo", "screen"};
    const auto pass = [&words](const std::string& name, const std::string& value) {
        words.insert(words.end(), {"-var", name, value});
    };
    char weight[32];
    std::snprintf(weight, sizeof weight, "%.17g", settings.weight);
    pass("weight", weight);
    for (const auto& [name, value] : settings.variables)
        pass(name, value);
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());

    const LastWords of_liggghts(comm_.is_master());
    void* handle = nullptr;
    lammps_open(static_cast<int>(argv.size()), argv.data(), comm_.handle(), &handle);
    lmp_ = static_cast<LAMMPS_NS::LAMMPS*>(handle);
    if (!lmp_->screen) lmp_->screen = LastWords::of_rank_without_log();
    screen_ = std::make_unique<ListeningScreen>(lmp_->screen, warnings_);
    plugins_ = load_plugins(comm_, *lmp_, settings.plugins, "system/couplingDict, plugins");
    lammps_file(lmp_, settings.script.c_str());

    refuse_unusable_scene();
    weights_ = weight_property(*lmp_, settings.script);
    to_come_ = spheres_to_come(*lmp_);
    if (settings.method != Method::mp_pic && (lmp_->force->pair || !resolves_contacts(settings.method)))
        contact_duration_ = shortest_contact(*lmp_, to_come_);
    rayleigh_time_ = interphase::rayleigh_time(*lmp_);
    step_limit_ = ask_for_step_limit();
    solid_stress_ = ask_for_solid_stress();
    moves_come_first_ = any_plugin_says(extract_moves_before_forces);
    takes_new_forces_ = any_plugin_says(extract_takes_new_forces);
}

LiggghtsSolids::~LiggghtsSolids()
{
    lammps_close(lmp_);
    screen_.reset();
}

void LiggghtsSolids::refuse_unusable_scene() const
{
    const std::string& script = settings_.script;
    if (!lmp_->domain->box_exist)
        throw UserError("the script defines no simulation box", script, "add create_box or read_data");
    if (!lmp_->atom->sphere_flag)
        throw UserError("the particles are not spheres with their own radius and mass", script,
                        "use `atom_style granular` (or sphere)");
    if (settings_.gas != GasModel::none && lmp_->domain->triclinic)
        throw UserError("the box is triclinic, and particles are followed through straight periodic sides only", script,
                        "use a box of region style block");
    if (std::string(lmp_->update->unit_style) != "si")
        throw UserError(std::string("the script computes in units `") + lmp_->update->unit_style + "`", script,
                        "add `units si`: the gas is in SI units");
    if (settings_.gas != GasModel::none)
        if (const auto problem = dependent_spheres(*lmp_, script)) throw UserError(*problem);
    refuse_particles_moved_twice();
    if (settings_.gas != GasModel::none && lmp_->modify->find_fix_style_strict("freeze", 0))
        throw UserError("fix freeze clears forces before the fluid force is added, so the particles would drift",
                        script, "hold particles by leaving them out of the integrator's group instead");
    if (const auto problem = unphysical_contact(*lmp_, script)) throw UserError(*problem);
    refuse_doubtful_collisions();
    refuse_bodiless_particles();
}

void LiggghtsSolids::refuse_particles_moved_twice() const { comm_.fail_together(moved_twice(*lmp_, settings_.script)); }

bool LiggghtsSolids::has_fix(const char* start_of_style) const
{
    const LAMMPS_NS::Modify& modify = *lmp_->modify;
    return std::any_of(modify.fix, modify.fix + modify.nfix, [start_of_style](const LAMMPS_NS::Fix* fix) {
        return std::string(fix->style).rfind(start_of_style, 0) == 0;
    });
}

std::vector<Problem> LiggghtsSolids::remarks()
{
    std::vector<Problem> all;
    if (!looked_at_) all = remarks_on_scene();
    if (looked_at_ && has_fix("insert/")) refuse_particles_moved_twice();
    if (!looked_at_ || has_fix("insert/"))
        if (const auto problem = remark_on_unmoved()) all.push_back(*problem);
    if (looked_at_ && rayleigh_time_)
        if (const auto problem = remark_on_fast_contacts()) all.push_back(*problem);
    looked_at_ = true;
    return all;
}

std::vector<Problem> LiggghtsSolids::remarks_on_scene()
{
    constexpr double much = 0.05;  // of a radius; contact models are made for less
    std::vector<Problem> all;
    for (const Overlaps& found : overlaps(comm_, *lmp_, much, settings_.method != Method::mp_pic)) {
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
    for (int i = 0; i < lmp_->modify->nfix; ++i) {
        const LAMMPS_NS::Fix& fix = *lmp_->modify->fix[i];
        constexpr int moving = LAMMPS_NS::FixConst::INITIAL_INTEGRATE | LAMMPS_NS::FixConst::FINAL_INTEGRATE;
        if (is_of_plugin(fix.style) && !fix.time_integrate && (lmp_->modify->fmask[i] & moving))
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
                    settings_.script, "none is needed where the mesh is thin or slow beside the gas"});
    return all;
}

std::optional<Problem> LiggghtsSolids::remark_on_unmoved()
{
    const long before = unmoved_;
    unmoved_ = comm_.sum(unmoved(*lmp_));
    if (unmoved_ == 0 || before > 0) return std::nullopt;
    return Problem{"no fix of the script moves " + std::to_string(unmoved_) + " of the " +
                       std::to_string(static_cast<long>(lmp_->atom->natoms)) +
                       " particles: they stay where they are, whatever acts on them",
                   settings_.script,
                   "none where they are held on purpose; otherwise add an integrator (fix nve/sphere, or the "
                   "plug-in's) for a group that they are in"};
}

std::optional<Problem> LiggghtsSolids::remark_on_fast_contacts()
{
    const double step = lmp_->update->dt, speed = largest_speed(*lmp_);
    const auto contact = hertz_time(*lmp_, 2 * speed);
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

std::vector<Count> LiggghtsSolids::counts() const
{
    std::vector<Count> all;
    const auto add = [&all](const char* key, const char* words, long number) {
        if (number > 0) all.push_back({key, words, number});
    };
    add("overlaps_at_start", "overlaps at the start", overlaps_);
    add("particles_unmoved", "particles that no fix moves", unmoved_);
    add("fast_contacts", "gas steps with too fast contacts", fast_steps_);
    return all;
}

EngineWarnings* LiggghtsSolids::warnings()
{
    screen_->flush();
    return &warnings_;
}

bool LiggghtsSolids::is_of_plugin(const std::string& style) const
{
    return std::any_of(plugins_.begin(), plugins_.end(), [&](const LoadedPlugin& plugin) {
        return std::find(plugin.styles.begin(), plugin.styles.end(), style) != plugin.styles.end();
    });
}

void LiggghtsSolids::refuse_doubtful_collisions() const
{
    if (resolves_contacts(settings_.method)) return;
    const std::string method = name_of(settings_.method);
    const LAMMPS_NS::Modify& modify = *lmp_->modify;
    if (std::none_of(modify.fix, modify.fix + modify.nfix,
                     [&](const LAMMPS_NS::Fix* fix) { return is_of_plugin(fix->style); })) {
        std::vector<std::string> styles;
        for (const LoadedPlugin& plugin : plugins_)
            styles.insert(styles.end(), plugin.styles.begin(), plugin.styles.end());
        throw UserError("no fix of a plug-in is in the script, so with method " + method + " nothing would collide",
                        settings_.script, "add a fix of one of these styles: " + listed(styles));
    }
    const std::string pair = lmp_->force->pair ? lmp_->force->pair_style : "";
    if (settings_.method != Method::plugin && pair.rfind("gran", 0) == 0)
        throw UserError("the script has pair style " + pair + ", and method " + method +
                            " has collisions of its own: each would count twice",
                        settings_.script, "leave the pair style away for this method, or take DEM or CGPM");
}

std::optional<double> LiggghtsSolids::ask_for_step_limit() const
{
    constexpr double none = std::numeric_limits<double>::max();
    double limit = none;
    std::optional<Problem> problem;
    for (int i = 0; i < lmp_->modify->nfix; ++i) {
        LAMMPS_NS::Fix* fix = lmp_->modify->fix[i];
        if (!is_of_plugin(fix->style)) continue;
        int dimension = 0;
        const auto* told = static_cast<const double*>(fix->extract(extract_solid_step_limit, dimension));
        if (!told) continue;
        if (!(*told > 0))
            problem = Problem{std::string("fix ") + fix->id + " (" + fix->style +
                                  ") says that it bears a solid step of at most " + text(*told) + " s",
                              settings_.script, std::string("correct the plug-in's ") + extract_solid_step_limit};
        limit = std::min(limit, *told);
    }
    comm_.fail_together(problem);
    limit = comm_.min(limit);
    if (limit == none) return std::nullopt;
    return limit;
}

SolidStress* LiggghtsSolids::ask_for_solid_stress() const
{
    SolidStress* found = nullptr;
    std::string by;
    for (int i = 0; i < lmp_->modify->nfix; ++i) {
        LAMMPS_NS::Fix* fix = lmp_->modify->fix[i];
        if (!is_of_plugin(fix->style)) continue;
        int dimension = 0;
        auto* model = static_cast<SolidStress*>(fix->extract(extract_solid_stress, dimension));
        if (!model) continue;
        if (found)
            throw UserError("two fixes want the solids' stress on the gas mesh: " + by + " and " + fix->id,
                            settings_.script, "keep one of them; it moves all particles");
        found = model;
        by = fix->id;
    }
    return found;
}

bool LiggghtsSolids::any_plugin_says(const char* what) const
{
    for (int i = 0; i < lmp_->modify->nfix; ++i) {
        LAMMPS_NS::Fix* fix = lmp_->modify->fix[i];
        if (!is_of_plugin(fix->style)) continue;
        int dimension = 0;
        const auto* told = static_cast<const int*>(fix->extract(what, dimension));
        if (told && *told) return true;
    }
    return false;
}

void LiggghtsSolids::refuse_bodiless_particles() const
{
    std::optional<Problem> problem;
    const LAMMPS_NS::Atom& atom = *lmp_->atom;
    for (int i = 0; i < atom.nlocal && !problem; ++i)
        if (!(atom.radius[i] > 0 && atom.rmass[i] > 0))
            problem = Problem{"particle " + std::to_string(atom.tag[i]) + " has a radius of " + text(atom.radius[i]) +
                                  " m and a mass of " + text(atom.rmass[i]) + " kg",
                              settings_.script, "give diameters and densities above 0, in m and kg/m3"};
    comm_.fail_together(problem);
}

double LiggghtsSolids::largest_diameter() const
{
    double radius = 0;
    for (int i = 0; i < lmp_->atom->nlocal; ++i)
        radius = std::max(radius, lmp_->atom->radius[i]);
    for (const SpheresToCome& spheres : to_come_)
        radius = std::max(radius, spheres.largest_radius);
    return 2 * comm_.max(radius);
}

double LiggghtsSolids::smallest_diameter() const
{
    double radius = std::numeric_limits<double>::max();
    for (int i = 0; i < lmp_->atom->nlocal; ++i)
        radius = std::min(radius, lmp_->atom->radius[i]);
    for (const SpheresToCome& spheres : to_come_)
        radius = std::min(radius, spheres.smallest_radius);
    return 2 * comm_.min(radius);
}

void LiggghtsSolids::start(double solid_step, long steps, bool with_gas)
{
    const LastWords of_liggghts(comm_.is_master());
    char command[64];
    std::snprintf(command, sizeof command, "timestep %.17g", solid_step);
    lammps_command(lmp_, command);

    population_ = add_fix<FixPopulation>(*lmp_, "interphase_population");
    if (with_gas) fluid_ = add_fix<FixFluid>(*lmp_, "interphase");  // the last one: it answers to all other forces

    // what `run` does before its loop, so that the loop can be continued at any length without setting up again
    LAMMPS_NS::Update& update = *lmp_->update;
    update.whichflag = 1;
    update.nsteps = static_cast<int>(std::min<long>(steps, INT_MAX));
    update.firststep = update.beginstep = update.ntimestep;
    update.laststep = update.endstep = update.ntimestep + steps;
    lmp_->init();
    population_->watch(fluid_);
    const long before = comm_.sum(static_cast<long>(lmp_->atom->nlocal));
    update.integrate->setup();
    lmp_->timer->init();
    const long lost = before - comm_.sum(static_cast<long>(lmp_->atom->nlocal));
    if (lost > 0)
        throw UserError(std::to_string(lost) + " of " + std::to_string(before) +
                            " particles are outside of the particles' domain at the start, where LIGGGHTS drops them",
                        settings_.script, "place them inside the box of create_box or read_data, or make it larger");

    if (auto* fix = dynamic_cast<LAMMPS_NS::FixGravity*>(lmp_->modify->find_fix_style("gravity", 0)))
        fix->get_gravity(gravity_.data());
}

ParticleView LiggghtsSolids::particles()
{
    const LAMMPS_NS::Atom& atom = *lmp_->atom;
    const Eigen::Index n = atom.nlocal;
    const auto vectors = [n](double** array) { return VectorsView(n > 0 ? array[0] : nullptr, 3, n); };
    return {vectors(atom.x),
            vectors(atom.v),
            vectors(atom.omega),
            vectors(atom.f),
            ScalarsView(atom.radius, n),
            ScalarsView(atom.rmass, n),
            weights_ ? ParticleWeights::of_each(weights_->vector_atom) : ParticleWeights::same(settings_.weight),
            atom.tag,
            fluid_ ? fluid_->forces() : nullptr,
            fluid_ ? fluid_->booked() : nullptr,
            fluid_ ? fluid_->coupling() : nullptr};
}

PeriodicBox LiggghtsSolids::periods() const
{
    const LAMMPS_NS::Domain& domain = *lmp_->domain;
    PeriodicBox periods;
    for (int axis = 0; axis < 3; ++axis) {
        periods.box.row(axis) << domain.boxlo[axis], domain.boxhi[axis];
        periods.periodic[static_cast<std::size_t>(axis)] = domain.periodicity[axis] != 0;
    }
    return periods;
}

void LiggghtsSolids::kick_again(std::size_t i, const Vector& velocity, const Vector& force)
{
    std::copy_n(velocity.data(), 3, lmp_->atom->v[i]);
    std::copy_n(force.data(), 3, lmp_->atom->f[i]);
}

void LiggghtsSolids::advance(int substeps)
{
    const LastWords of_liggghts(comm_.is_master());
    population_->begin();
    lmp_->update->integrate->run(substeps);
    population_->settle();
    refuse_faster_contacts();
}

void LiggghtsSolids::refuse_faster_contacts() const
{
    // of what came by other ways than the fixes insert/* that the step was chosen for
    if (!contact_duration_ || !comm_.any(!population_->arrivals().empty())) return;
    constexpr double slack = 1 - 1e-6;
    const std::optional<double> now = shortest_contact(*lmp_, {});
    if (!now || *now >= *contact_duration_ * slack) return;
    throw UserError("particles were inserted whose collisions last " + text(*now) + " s, less than the " +
                        text(*contact_duration_) + " s for which the solid step was chosen",
                    settings_.script,
                    "let fixes insert/* of the script make them, whose templates are known at the start, or give "
                    "`solidStep` for them and a first one of their kind in the script");
}

Scalars LiggghtsSolids::weights_to_come() const
{
    Scalars weights;
    for (const SpheresToCome& spheres : to_come_)
        if (spheres.weight) weights.push_back(*spheres.weight);
    return weights;
}

Scalars LiggghtsSolids::radii_to_come() const
{
    Scalars radii;
    for (const SpheresToCome& spheres : to_come_)
        radii.insert(radii.end(), {spheres.smallest_radius, spheres.largest_radius});
    return radii;
}

const std::vector<Departure>& LiggghtsSolids::departures() const { return population_->departures(); }

const std::vector<std::size_t>& LiggghtsSolids::arrivals() const { return population_->arrivals(); }

std::string LiggghtsSolids::version() const
{
    // "Version LIGGGHTS-PUBLIC 3.8.0, compiled ..."
    const std::string whole = lmp_->universe->version;
    const std::size_t start = whole.find("LIGGGHTS");
    return start == std::string::npos ? whole : whole.substr(start, whole.find(',') - start);
}

}  // namespace interphase
