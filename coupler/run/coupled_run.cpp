// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/coupled_run.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/disk_room.hpp"
#include "base/disk_watch.hpp"
#include "base/stop_together.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "records/provenance.hpp"
#include "run/gas_step_choice.hpp"
#include "settings/read_settings.hpp"

namespace interphase {

namespace {

const char* gas_description(const Settings& settings)
{
    switch (settings.gas) {
        case GasModel::pimple:
            return settings.two_way ? "pimple, two-way" : "pimple, one-way";
        case GasModel::frozen:
            return "frozen, one-way";
        case GasModel::none:
            return "none";
    }
    return "";
}

/// Columns of what came and went: of each way the number, the volume and the momentum.
void add_passages(std::vector<Results::Entry>& row, const PopulationTotals& totals)
{
    visit_passages(totals, [&row](const std::string& key, const std::string&, const Passage& passage) {
        if (key.rfind("gas_", 0) != 0) row.push_back({key, "1", passage.particles});
        row.push_back({key + "_volume", "m3", passage.volume});
        for (std::size_t axis = 0; axis < 3; ++axis)
            row.push_back({key + "_momentum_" + "xyz"[axis], "kg m/s", passage.momentum[axis]});
    });
}

ParticleRows rows_of(const ParticleView& particles)
{
    const std::size_t n = particles.size();
    const auto flat = [n](const VectorsView& vectors) { return Scalars(vectors.data(), vectors.data() + 3 * n); };
    ParticleRows rows{std::vector<int>(particles.id, particles.id + n),
                      flat(particles.position),
                      flat(particles.velocity),
                      flat(particles.angular_velocity),
                      flat(particles.force),
                      Scalars(n),
                      std::nullopt};
    for (std::size_t i = 0; i < n; ++i)
        rows.diameter[i] = 2 * particles.radius[static_cast<Eigen::Index>(i)];
    if (!particles.weight.differ()) return rows;
    rows.weight.emplace(n);
    for (std::size_t i = 0; i < n; ++i)
        (*rows.weight)[i] = particles.weight[i];
    return rows;
}

}  // namespace

CoupledRun::CoupledRun(GasCase& gas_case, const MakeParticleEngine& make_particles, Beginning beginning)
    : case_(gas_case),
      settings_(read_settings(case_.coupling_dict(), case_.scene_parameters(), std::filesystem::current_path())),
      report_(comm_.is_master(), case_.time(), case_.end_time())
{
    if (settings_.gas != GasModel::none) gas_ = case_.make_gas(settings_);
    solids_ = make_particles(comm_, settings_);
    at_start_ = counted(comm_, solids_->particles());
    if (at_start_.tracked == 0) at_start_.lowest_weight = at_start_.highest_weight = settings_.weight;
    refuse_empty_scene();
    check_weights();
    clock_ = choose_clock();
    gas_step_ = clock_.next(case_.gas_step(), 1e300).duration;
    check_scene();

    if (beginning == Beginning::last_checkpoint) find_checkpoint();
    end_time_ = case_.end_time();
    solids_->start(clock_.solid_step(), steps_until(end_time_), gas_ != nullptr);
    if (gas_) {
        if ((gas_->gravity() - solids_->gravity()).norm() > 1e-6 * std::max(1.0, gas_->gravity().norm()))
            throw UserError("gas and particles feel different gravity: constant/g says " + text(gas_->gravity()) +
                                " m/s2, fix gravity " + text(solids_->gravity()) + " m/s2",
                            "constant/g and " + settings_.script, "give both the same value");
        coupling_ = std::make_unique<CouplingStep>(comm_, settings_, *gas_, *solids_, stopwatch_);
        coupling_->start_at(case_.time());
    } else
        without_gas_.emplace(comm_, settings_);
    if (kept_)
        put_records_aside();
    else
        put_checkpoints_aside();
    results_ = std::make_unique<Results>(comm_);
    snapshots_ = std::make_unique<ParticleSnapshots>(comm_);
    describe_run();
    tell_warnings();
}

std::vector<EngineWarnings*> CoupledRun::warners() const
{
    std::vector<EngineWarnings*> all;
    for (EngineWarnings* engine : {solids_->warnings(), case_.warnings()})
        if (engine) all.push_back(engine);
    return all;
}

void CoupledRun::tell_warnings()
{
    for (const Problem& remark : solids_->remarks())
        report_.warn(remark.message());
    for (EngineWarnings* of : warners())
        for (const std::string& words : of->news(comm_))
            report_.warn(of->engine() + " warns: " + words + "\n  where:  " + of->log() +
                         "\n  when:   up to t = " + text(case_.time()) + " s; more of the kind are counted");
}

void CoupledRun::tell_own_warnings() const
{
    for (const EngineWarnings* of : warners())
        for (const std::string& words : of->own_news())
            report_.warn(of->engine() + " warns: " + words + "\n  where:  " + of->log());
}

void CoupledRun::describe_run()
{
    const std::optional<double> contact = solids_->contact_duration();
    report_.head({{"interphase", solids_->version() + ", " + case_.engine()},
                  {"case", case_.name()},
                  {"method", name_of(settings_.method)},
                  {"particles", numbers_of(at_start_, solids_->radii_to_come())},
                  {"plug-ins", solids_->plugins()},
                  {"gas", std::string(gas_description(settings_)) + (gas_ ? ", drag " + settings_.drag_law : "")},
                  {"mapping", coupling_ ? coupling_->mapping_description() : "none"},
                  {"steps", "gas " + text(gas_step_) + " s" + (case_.adjusts_gas_step() ? " at first" : "") +
                                ", solids " + text(clock_.solid_step()) + " s" +
                                (contact ? " = t_c/" + text(*contact / clock_.solid_step()) : "")},
                  {"ranks", std::to_string(comm_.size())}});

    Results& meta = *results_;
    meta.describe("/meta", "case", case_.name());
    meta.describe("/meta", "method", name_of(settings_.method));
    meta.describe("/meta", "plugins", solids_->plugins());
    meta.describe("/meta", "ranks", comm_.size());
    meta.describe("/meta", "particles_at_start", static_cast<double>(at_start_.tracked));
    describe_population();
    meta.describe("/meta", "solid_step", clock_.solid_step());
    meta.describe("/meta", "gas_step", gas_step_);
    meta.describe("/meta", "drag_law", settings_.drag_law);
    const Version version = this_version();
    meta.describe("/meta", "versions", name_and_number(version) + ", " + solids_->version() + ", " + case_.engine());
    if (comm_.is_master()) record_provenance(meta, version, case_inputs(".", settings_.script, settings_.variables));
    if (gas_) meta.describe_box("/meta", "domain", gas_->bounds());
}

void CoupledRun::describe_population()
{
    const ParticleView particles = solids_->particles();
    Population now = counted(comm_, particles);
    if (now.tracked == 0) now = {0, 0, at_start_.lowest_weight, at_start_.highest_weight, 0, 0};
    Results& meta = *results_;
    const bool same = now.lowest_weight == now.highest_weight;
    meta.describe("/meta", "weight", now.tracked > 0 || same ? now.mean_weight() : at_start_.mean_weight());
    meta.describe("/meta", "lowest_weight", now.lowest_weight);
    meta.describe("/meta", "highest_weight", now.highest_weight);
    meta.describe("/meta", "particles", static_cast<double>(now.tracked));
    meta.describe("/meta", "real_particles", now.real);
    if (gas_ && gas_->gravity().norm() > 0)
        meta.describe("/meta", "bed_weight_per_area", weight_per_area(*gas_, comm_.sum(particles.mass.sum())));
}

PopulationTotals CoupledRun::came_and_went() const
{
    return coupling_ ? coupling_->population() : without_gas_->of_all_ranks();
}

int CoupledRun::run()
{
    requests_.emplace();
    rows_.emplace(case_.time(), settings_.record_interval);
    if (settings_.snapshot_interval > 0) own_snapshots_.emplace(case_.time(), settings_.snapshot_interval);
    const double start = case_.time();
    try {
        begin_checkpoints();
        if (kept_)
            go_on();
        else
            record(true);
        while (case_.running()) {
            follow_end_time();
            step();
            if (checkpoint_due()) checkpoint();
        }
        if (stopped_by_ == 0) follow_end_time();
        if (!ended_) record(false);  // the end came nearer than the step before it was taken for
        finish();
        return stopped_by_;
    } catch (const UserError& error) {
        Problem problem = error.problem();
        if (problem.kind == ExitCode::refused && case_.time() != start) problem.kind = ExitCode::diverged;
        keep_what_is_known(UserError(problem));
        throw UserError(problem);
    } catch (const std::exception& error) {
        keep_what_is_known(error);
        throw;
    }
}

void CoupledRun::keep_what_is_known(const std::exception& error)
{
    stop_if_alone("interphase", failure_of(error));  // what follows is collective
    tell_own_warnings();
    results_->describe("/meta", "simulated_time", case_.time());
    results_->flush();
}

long CoupledRun::steps_until(double end) const
{
    constexpr double no_end = 1e15;
    return std::lround(std::min(no_end, (end - case_.time() + gas_step_) / clock_.solid_step()));
}

/// It can be changed in system/controlDict while it runs, by `stopAt` as well.
void CoupledRun::follow_end_time()
{
    if (case_.end_time() == end_time_) return;
    end_time_ = case_.end_time();
    report_.end_at(end_time_);
    solids_->end_after(std::max(0L, steps_until(end_time_)));
}

double CoupledRun::wanted_gas_step() const
{
    if (!case_.adjusts_gas_step() || !gas_) return case_.gas_step();
    return adjusted_gas_step({gas_step_, clock_.solid_step(), gas_->courant_number(), case_.largest_courant_number(),
                              std::min(case_.largest_gas_step(), coupling_->longest_step())});
}

void CoupledRun::step()
{
    stopwatch_.switch_to(Phase::gas);
    const GasStep planned = clock_.next(wanted_gas_step(), case_.end_time() - case_.time());
    gas_step_ = planned.duration;
    const double start = case_.time();
    case_.advance_time(planned.duration);
    if (coupling_) {
        try {
            case_.with_own_errors([&] { coupling_->advance(planned.duration, planned.substeps); });
        } catch (const UserError& error) {
            Problem problem = error.problem();
            problem.step = "in the gas step from t = " + text(start) + " s to " + text(case_.time()) + " s";
            stop_if_alone("interphase", failure_of(UserError(problem)));  // what follows is collective
            // the gas engine chokes on numbers that are not finite before the step gets to its own check
            if (const std::optional<Problem> trouble = gas_->trouble()) {
                const std::string step = problem.step;
                problem = *trouble;
                problem.step = step;
            }
            throw UserError(problem);
        }
    } else {
        without_gas_->remember(solids_->particles());
        stopwatch_.switch_to(Phase::solids);
        solids_->advance(planned.substeps);
        stopwatch_.switch_to(Phase::exchange);
        without_gas_->book(*solids_);
    }

    stopwatch_.switch_to(Phase::output);
    if (coupling_ && !coupling_->news().empty()) report_.warn(coupling_->news());
    tell_warnings();
    if (coupling_ && settings_.two_way) {
        std::vector<Results::Entry> row{{"time", "s", case_.time()}};
        for (const Account* account : coupling_->ledger().accounts())
            row.push_back({account->key() + "_residual", "1", account->residual()});
        for (const Count& count : coupling_->counts())
            row.push_back({count.key, "1", static_cast<double>(count.number)});
        const Eigen::VectorXd& carried_off = coupling_->ledger().momentum.carried_off();
        for (int axis = 0; axis < 3; ++axis)
            row.push_back({std::string("carried_off_momentum_") + "xyz"[axis], "kg m/s", carried_off[axis]});
        add_passages(row, came_and_went());
        results_->add_row("/ledger", row);
    }
    record(false);
}

void CoupledRun::record(bool at_start)
{
    stopwatch_.switch_to(Phase::output);
    const double now = case_.time();
    const bool row_due = rows_->due(now, gas_step_);
    Scalars wishes{report_.progress_due() ? 1.0 : 0.0, static_cast<double>(requests_->signal())};
    comm_.max(wishes);
    const bool line_due = wishes[0] > 0;
    const bool at_end_time = now > case_.end_time() - 0.5 * gas_step_;
    if (!at_end_time) stopped_by_ = static_cast<int>(wishes[1]);
    const bool at_end = at_end_time || stopped_by_ != 0;
    ended_ = at_end;
    if (row_due || line_due || at_end) {
        last_seen_ =
            observe(comm_, *solids_, gas_.get(), coupling_ ? coupling_->voidage() : Scalars{}, settings_.pressure_taps);
        const PopulationTotals totals = came_and_went();
        last_seen_.came = totals.came();
        last_seen_.went = totals.went();
        if (row_due && !at_start) results_->add_row("/series", last_seen_.row(now));
        if (line_due || at_end) report_.progress(now, last_seen_);
    }
    rows_->pass(now, gas_step_);

    const bool write_due = case_.write_due() || at_end;
    const bool snapshot_due = own_snapshots_ ? own_snapshots_->due(now, gas_step_) : write_due;
    if (own_snapshots_) own_snapshots_->pass(now, gas_step_);
    const bool writes = snapshot_due || at_start || at_end || write_due;
    if (writes || line_due) refuse_full_disk();
    if (writes || results_->flush_due()) {  // rows do not wait for what takes long
        results_->describe("/meta", "simulated_time", now);
        results_->flush();
    }
    if (!writes) return;
    const DiskWatch watch(comm_.rank(), "interphase", full_disk().message());
    if ((snapshot_due || at_start || at_end) && last_snapshot_ != now) {
        snapshots_->write(now, rows_of(solids_->particles()));
        last_snapshot_ = now;
    }
    if (write_due && !at_start) {
        if (gas_) case_.write();
        describe_population();
        results_->flush();
    }
    refuse_full_disk();
    if (stopped_by_ != 0) case_.stop();
}

Problem CoupledRun::full_disk() const
{
    Problem problem;
    problem.what = "the disk is full: what was written last may be cut off";
    problem.where = std::filesystem::current_path().string() + ", at t = " + text(case_.time()) + " s";
    problem.remedy =
        "make room, or write less: writeInterval and purgeWrite in system/controlDict, records in "
        "system/couplingDict, dumps in " +
        settings_.script;
    problem.kind = ExitCode::disk;
    return problem;
}

void CoupledRun::refuse_full_disk() const
{
    comm_.fail_together(comm_.is_master() && disk_is_full(0) ? std::optional(full_disk()) : std::nullopt);
}

void CoupledRun::finish()
{
    stopwatch_.switch_to(Phase::output);
    const std::string stopped_by = stopped_by_ == 0 ? "" : StopRequest::name_of(stopped_by_);
    Report::Summary summary{case_.time(), stopped_by, {}, {}, came_and_went(), {}};
    if (stopped_by_ != 0) results_->describe("/meta", "stopped_by", stopped_by);
    for (std::size_t phase = 0; phase < phase_names.size(); ++phase) {
        summary.seconds[phase] = comm_.max(stopwatch_.seconds(static_cast<Phase>(phase)));
        results_->describe("/timing", std::string(phase_names[phase]), summary.seconds[phase]);
    }
    if (coupling_) {
        if (settings_.two_way) summary.balances = coupling_->ledger().accounts();
        summary.counts = coupling_->counts();
        const auto sent = static_cast<double>(coupling_->bytes_sent());
        results_->describe("/exchange", "bytes_sent_by_busiest_rank", comm_.max(sent));
        results_->describe("/exchange", "bytes_sent", comm_.sum(sent));
    }
    for (const Count& count : solids_->counts())
        summary.counts.push_back(count);
    for (const EngineWarnings* of : warners()) {
        const std::string key = "warnings_of_" + of->engine();
        const long count = of->count(comm_);
        summary.counts.push_back({key, "warnings of " + of->engine(), count});
        results_->describe("/meta", key, static_cast<double>(count));
    }
    results_->describe("/meta", "simulated_time", case_.time());
    describe_population();
    results_->describe("/meta", "wall_time", report_.wall_seconds());
    results_->flush();
    report_.summary(summary);
}

}  // namespace interphase
