// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/coupled_run.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/stop_together.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
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

}  // namespace

CoupledRun::CoupledRun(GasCase& gas_case, const ParticleEngineMaker& engines, const RunOptions& options)
    : case_(gas_case),
      settings_(
          read_settings(case_.coupling_dict(), case_.scene_parameters(), std::filesystem::current_path(), engines)),
      report_(comm_.is_master(), case_.time(), case_.end_time()),
      wall_limit_(options.wall_limit),
      checkpoint_schedule_(settings_, case_.time())
{
    if (settings_.gas != GasModel::none) gas_ = case_.make_gas(settings_);
    solids_ = engines.make(comm_, settings_);
    at_start_ = counted(comm_, solids_->particles());
    if (at_start_.tracked == 0) at_start_.lowest_weight = at_start_.highest_weight = settings_.weight;
    refuse_empty_scene();
    check_weights();
    clock_ = choose_clock();
    gas_step_ = clock_.next(case_.gas_step(), 1e300).duration;
    check_scene();

    facts_ = facts();
    if (options.resumes) find_checkpoint();
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
    if (!kept_) make_way_for_checkpoints(options.overwrites);
    records_.emplace(RunRecords::Scene{comm_, settings_, case_, *solids_, gas_.get(), coupling_.get(),
                                       without_gas_ ? &*without_gas_ : nullptr, at_start_, processor_},
                     kept_ ? std::optional(kept_->time) : std::nullopt);
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

/// Of all that is counted in every gas step.
std::vector<Count> CoupledRun::counts() const
{
    std::vector<Count> all = coupling_ ? coupling_->counts() : std::vector<Count>();
    const std::vector<Count> of_plugins = solids_->counters();
    all.insert(all.end(), of_plugins.begin(), of_plugins.end());
    return all;
}

void CoupledRun::tell_counts()
{
    if (!count_news_.due(booked().gas_steps)) return;
    for (const std::string& words : count_news_.of(counts(), wholes()))
        report_.note("t = " + text(case_.time()) + " s: " + words);
}

void CoupledRun::describe_run()
{
    const std::optional<double> contact = solids_->contact_duration();
    report_.head({{"interphase", solids_->version() + ", " + case_.engine()},
                  {"case", case_.name()},
                  {"method", settings_.method.name},
                  {"particles", numbers_of(at_start_, solids_->radii_to_come())},
                  {"plug-ins", solids_->plugins()},
                  {"gas", std::string(gas_description(settings_)) + (gas_ ? ", drag " + settings_.drag_law : "")},
                  {"mapping", coupling_ ? coupling_->mapping_description() : "none"},
                  {"steps", "gas " + text(gas_step_) + " s" + (case_.adjusts_gas_step() ? " at first" : "") +
                                ", solids " + text(clock_.solid_step()) + " s" +
                                (contact ? " = t_c/" + text(*contact / clock_.solid_step()) : "")},
                  {"ranks", std::to_string(comm_.size())},
                  {"checkpoints", describe_checkpoints()}});
}

int CoupledRun::run()
{
    requests_.emplace();
    const double start = case_.time();
    try {
        const bool goes_on = kept_.has_value();
        if (goes_on) go_on();
        bool nothing_new = goes_on && records_->hold_this_moment();
        records_->describe(clock_.solid_step(), gas_step_);
        if (!goes_on) record(true);
        while (case_.running()) {
            const double before = report_.wall_seconds();
            follow_end_time();
            step();
            nothing_new = false;
            wall_limit_.stepped(report_.wall_seconds() - before);
            checkpoint_if_due();
        }
        if (signal_ == 0 && !out_of_time_) follow_end_time();
        if (!ended_ && !nothing_new) record(false);  // the end came nearer than the step before it was taken for
        finish();
        if (out_of_time_) return static_cast<int>(ExitCode::wall_limit);
        return signal_ == 0 ? static_cast<int>(ExitCode::finished) : exit_code_of_signal(signal_);
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
    records_->flush();
    const std::string way = way_to_go_on();
    if (!way.empty()) report_.warn(way);
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
    stopwatch_.switch_to(Phase::solids);
    for (const std::string& done : solids_->begin_gas_step(start))
        report_.note("t = " + text(start) + " s: " + done);
    stopwatch_.switch_to(Phase::gas);
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
    tell_counts();
    records_->add_ledger_row();
    record(false);
}

/// A signal, the wall clock, or the end time: the same on all ranks.
void CoupledRun::look_for_the_end()
{
    const bool at_end_time = case_.time() > case_.end_time() - 0.5 * gas_step_;
    Scalars wishes{static_cast<double>(requests_->end()), wall_limit_.reached(report_.wall_seconds()) ? 1.0 : 0.0};
    comm_.max(wishes);
    if (!at_end_time) {
        signal_ = static_cast<int>(wishes[0]);
        out_of_time_ = signal_ == 0 && wishes[1] > 0;
    }
    ended_ = at_end_time || signal_ != 0 || out_of_time_;
}

void CoupledRun::record(bool at_start)
{
    stopwatch_.switch_to(Phase::output);
    if (!at_start) look_for_the_end();  // a run makes a step, at least: it may be one that goes on again and again
    const bool line_due = comm_.any(report_.progress_due());
    records_->record({gas_step_, at_start, ended_, line_due});
    if (line_due || ended_) report_.progress(case_.time(), records_->last_seen());
    if (signal_ != 0 || out_of_time_) case_.stop();
}

std::string CoupledRun::stopped_by() const
{
    if (out_of_time_) return "its limit of wall-clock time";
    return signal_ == 0 ? "" : SignalRequests::name_of(signal_);
}

Wholes CoupledRun::booked() const { return coupling_ ? coupling_->wholes() : without_gas_->wholes(); }

Wholes CoupledRun::wholes() const
{
    Wholes all = booked();
    all.particles = static_cast<double>(at_start_.tracked) + records_->came_and_went().came();
    return all;
}

void CoupledRun::finish()
{
    stopwatch_.switch_to(Phase::output);
    Report::Summary summary{case_.time(),
                            stopped_by(),
                            spent_before_.with(comm_, stopwatch_, report_.wall_seconds()),
                            {},
                            records_->came_and_went(),
                            {},
                            wholes(),
                            stopped_by().empty() ? "" : way_to_go_on()};
    if (coupling_) {
        if (settings_.two_way) summary.balances = coupling_->ledger().accounts();
        summary.counts = coupling_->counts();
    }
    const std::vector<Count> counters = solids_->counters();
    for (const std::vector<Count>& of_particles : {solids_->counts(), counters})
        summary.counts.insert(summary.counts.end(), of_particles.begin(), of_particles.end());
    std::vector<Count> warnings;
    for (const EngineWarnings* of : warners())
        warnings.push_back(of->count(comm_));
    summary.counts.insert(summary.counts.end(), warnings.begin(), warnings.end());
    records_->describe_end({stopped_by(), summary.spent, warnings, counters});
    report_.summary(summary);
}

}  // namespace interphase
