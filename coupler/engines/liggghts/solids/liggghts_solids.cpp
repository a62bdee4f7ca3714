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
#include "engines/liggghts/script/last_words.hpp"
#include "engines/liggghts/solids/contact_duration.hpp"
#include "engines/liggghts/solids/dump_files.hpp"
#include "engines/liggghts/solids/elastic_spheres.hpp"
#include "engines/liggghts/solids/fix_fluid.hpp"
#include "engines/liggghts/solids/fix_population.hpp"
#include "engines/liggghts/solids/fix_states.hpp"
#include "engines/liggghts/solids/particle_state.hpp"
#include "engines/liggghts/solids/scene_checks.hpp"
#include "engines/liggghts/solids/solids_counts.hpp"
#include "engines/liggghts/solids/start_time.hpp"
#include "engines/liggghts/solids/weight_property.hpp"
#include "fix_gravity.h"
#include "force.h"
#include "integrate.h"
#include "lammps.h"
#include "library.h"
#include "modify.h"
#include "output.h"
#include "plugin/plugin.hpp"
#include "timer.h"
#include "universe.h"
#include "update.h"

namespace interphase {

namespace {

void set_last_step(LAMMPS_NS::Update& update, LAMMPS_NS::bigint last)
{
    update.laststep = update.endstep = last;
    update.nsteps = static_cast<int>(std::min<LAMMPS_NS::bigint>(last - update.firststep, INT_MAX));
}

}  // namespace

LiggghtsSolids::LiggghtsSolids(const Communicator& comm, const Settings& settings, LaterStart later)
    : comm_(comm), settings_(settings), later_(later), earlier_(later.is_one()), commands_(settings.commands)
{
    const EarlierFiles::Watch watching(earlier_);
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

    refuse_unusable_scene(comm_, *lmp_, settings_, plugins_);
    commands_.check(*lmp_);
    weights_ = weight_property(*lmp_, settings.script);
    to_come_ = spheres_to_come(*lmp_);
    if (settings.method.single_collisions && (lmp_->force->pair || settings.method.collisions_of_plugin))
        contact_duration_ = shortest_contact(*lmp_, to_come_);
    rayleigh_time_ = interphase::rayleigh_time(*lmp_);
    largest_known_radius_ = 0.5 * largest_diameter();
    remarks_ = std::make_unique<SceneRemarks>(comm_, *lmp_, settings_, plugins_);
    const PluginFixes of_plugins(*lmp_, plugins_, settings_.script);
    counters_.follow(of_plugins, plugins_, settings_.script);
    step_limit_ = of_plugins.step_limit(comm_);
    solid_stress_ = of_plugins.solid_stress();
    moves_come_first_ = of_plugins.say(extract_moves_before_forces);
    takes_new_forces_ = of_plugins.say(extract_takes_new_forces);
}

LiggghtsSolids::~LiggghtsSolids()
{
    if (!LastWords::heard_error()) lammps_close(lmp_);
    screen_.reset();
}

std::vector<Count> LiggghtsSolids::counts() const
{
    std::vector<Count> all = remarks_->counts();
    if (const long late = population_ ? population_->seen_late() : 0; late > 0)
        all.push_back({seen_late_by_outlets, late});
    return all;
}

std::vector<const CountKind*> LiggghtsSolids::count_kinds()
{
    return {&overlaps_at_start, &particles_unmoved, &fast_contacts, &seen_late_by_outlets};
}

EngineWarnings* LiggghtsSolids::warnings()
{
    screen_->flush();
    return &warnings_;
}

std::vector<PluginBuild> LiggghtsSolids::plugins_in_use() const
{
    std::vector<PluginBuild> all;
    // a plug-in without fixes may serve the fixes of another
    if (!PluginFixes(*lmp_, plugins_, settings_.script).any() && settings_.commands.empty()) return all;
    all.reserve(plugins_.size());
    for (const LoadedPlugin& plugin : plugins_)
        all.push_back({plugin.name, plugin.file, plugin.sha256});
    return all;
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

void LiggghtsSolids::go_on_from(Archive& kept, double time)
{
    kept_ = &kept;
    later_.time = time;
}

std::vector<Problem> LiggghtsSolids::remarks()
{
    std::vector<Problem> all = remarks_->now();
    all.insert(all.end(), told_.begin(), told_.end());
    told_.clear();
    return all;
}

void LiggghtsSolids::start(double solid_step, long steps, bool with_gas)
{
    const LastWords of_liggghts(comm_.is_master());
    const EarlierFiles::Watch watching(earlier_);
    char command[64];
    std::snprintf(command, sizeof command, "timestep %.17g", solid_step);
    lammps_command(lmp_, command);

    if (kept_) {
        kept_->within("solids", [this] { commands_.keep(*kept_); });
        repeat_commands();
    }
    add_own_fixes(with_gas);

    // what `run` does before its loop, so that the loop can be continued at any length without setting up again
    if (kept_)
        kept_->within("solids", [this] { take_up_step(*lmp_, *kept_); });
    else if (const auto told = start_particles_at(*lmp_, later_.time, solid_step, settings_))
        told_.push_back(*told);
    if (later_.is_one()) {
        const std::vector<Problem> told = go_on_dumping(*lmp_, later_.time, kept_ != nullptr);
        told_.insert(told_.end(), told.begin(), told.end());
    }
    LAMMPS_NS::Update& update = *lmp_->update;
    update.whichflag = 1;
    update.firststep = update.beginstep = update.ntimestep;
    set_last_step(update, update.ntimestep + steps);
    lmp_->init();
    population_->watch(fluid_);
    const long before = comm_.sum(static_cast<long>(lmp_->atom->nlocal));
    set_up();
    const long lost = before - comm_.sum(static_cast<long>(lmp_->atom->nlocal));
    if (lost > 0)
        throw UserError(std::to_string(lost) + " of " + std::to_string(before) +
                            " particles are outside of the particles' domain at the start, where LIGGGHTS drops them",
                        settings_.script, "place them inside the box of create_box or read_data, or make it larger");

    if (auto* fix = dynamic_cast<LAMMPS_NS::FixGravity*>(lmp_->modify->find_fix_style("gravity", 0)))
        fix->get_gravity(gravity_.data());
    if (const auto told = earlier_.keep(later_.time)) told_.push_back(*told);
}

/// A run that goes on has no output before its particles are the kept ones (keep()).
void LiggghtsSolids::set_up()
{
    if (kept_) {
        lmp_->atom->setup();
        lmp_->modify->setup_pre_exchange();
        lmp_->update->integrate->setup_minimal(1);
    } else
        lmp_->update->integrate->setup();
    lmp_->timer->init();
}

void LiggghtsSolids::end_after(long steps)
{
    const LastWords of_liggghts(comm_.is_master());
    LAMMPS_NS::Update& update = *lmp_->update;
    set_last_step(update, update.ntimestep + steps);
    // LIGGGHTS has put no output behind the last step, and comes back to none once that is passed; what was due by now
    // has been written. Where a variable tells the next one, it is asked at the step before.
    ++update.ntimestep;
    lmp_->output->reset_timestep(update.ntimestep);
    --update.ntimestep;
    lmp_->modify->addstep_compute_all(lmp_->output->next_thermo);
}

std::optional<Problem> LiggghtsSolids::cannot_be_kept() const { return unkept_state(*lmp_, settings_.script); }

std::string LiggghtsSolids::memories_lost() const { return memories_not_kept(*lmp_, plugins_); }

void LiggghtsSolids::keep(Archive& archive)
{
    const LastWords of_liggghts(comm_.is_master());
    if (archive.loads()) {
        put_back_particle_state(*lmp_, archive, settings_.script);
        if (kept_) lmp_->output->setup(0);  // which Integrate::setup() would have called
        kept_ = nullptr;
    } else
        take_particle_state(*lmp_, archive);
    population_->begin_anew();
    commands_.keep(archive);
    archive.keep("counters", counters_);
    archive.keep("remarks", *remarks_);
    archive.keep("warnings", warnings_);
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
            atom.type,
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
