// SPDX-License-Identifier: GPL-3.0-or-later
// A run's state: when it is written, and how a run goes on from it.
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "base/version.hpp"
#include "records/case_inputs.hpp"
#include "run/case_facts.hpp"
#include "run/coupled_run.hpp"

namespace interphase {

namespace {

std::string in_lines(const std::vector<std::string>& all)
{
    std::string words;
    for (const std::string& each : all)
        words += "\n    " + each;
    return words;
}

}  // namespace

Checkpoints::Facts CoupledRun::facts() const
{
    Checkpoints::Facts all;
    if (!comm_.is_master()) return all;
    all = {{"version", name_and_number(this_version())},
           {"engines", solids_->version() + ", " + case_.engine()},
           {"solid step", text(clock_.solid_step()) + " s"}};
    for (const PluginBuild& plugin : solids_->plugins_in_use()) {
        all.emplace_back("plug-in " + plugin.name, plugin.sha256);
        all.emplace_back("place of plug-in " + plugin.name, plugin.file);
    }
    for (auto& fact : facts_of(case_inputs(".", settings_.script, settings_.variables)))
        all.push_back(std::move(fact));
    return all;
}

void CoupledRun::refuse_other_run(const Checkpoints::Found& found) const
{
    std::optional<Problem> problem;
    if (comm_.is_master()) {
        const FactDifferences differ = differences(found.facts, facts_);
        if (!differ.refused.empty())
            problem = Problem{
                "the case is not as it was when " + found.path + " was written:" + in_lines(differ.refused), "the case",
                "put that back (when the run ends and what it writes may change), or start anew, without "
                "-resume"};
        else if (!differ.told.empty())
            report_.warn("since " + found.path +
                         " was written the case has changed, and is taken as it is now:" + in_lines(differ.told));
    }
    comm_.fail_together(problem);
}

void CoupledRun::find_checkpoint()
{
    std::vector<std::string> passed_over;
    kept_ = checkpoints_.newest(passed_over);
    for (const std::string& words : passed_over)
        report_.warn(words + "\n  remedy: the one before it is taken");
    if (!kept_)
        throw UserError("there is no checkpoint to go on from", "checkpoints/",
                        "start without -resume; a run writes some every so often and when it ends, unless "
                        "system/couplingDict, checkpoint, says otherwise");
    if (const auto problem = solids_->cannot_be_kept()) throw UserError(*problem);
    refuse_other_run(*kept_);
    kept_->state.within("case", [this] { case_.keep(kept_->state); });
    solids_->go_on_from(kept_->state, kept_->time);
}

void CoupledRun::make_way_for_checkpoints(bool overwrites) const
{
    if (settings_.checkpoint_interval > 0)
        if (const auto problem = solids_->cannot_be_kept()) report_.warn(problem->message());
    if (overwrites) return checkpoints_.remove_earlier();
    const std::string folder = checkpoints_.put_earlier_aside();
    if (!folder.empty())
        report_.warn("the run starts anew; checkpoints of an earlier one are in " + folder +
                     " now\n  remedy: none is needed; the option -resume would have gone on from there");
}

void CoupledRun::keep(Archive& archive)
{
    archive.within("case", [&] { case_.keep(archive); });
    if (gas_) case_.with_own_errors([&] { archive.within("gas", [&] { gas_->keep(archive); }); });
    archive.within("solids", [&] { solids_->keep(archive); });
    if (coupling_)
        archive.keep("coupling", *coupling_);
    else
        archive.keep("population", *without_gas_);
    records_->keep(archive);
    archive.within("checkpoints", [&] { checkpoint_schedule_.keep(archive); });
    archive.keep("gas_step", gas_step_);
    archive.keep("population_at_start", at_start_);
}

void CoupledRun::go_on()
{
    try {
        keep(kept_->state);
    } catch (const UserError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw UserError(kept_->path + " does not fit the case: " + error.what(), "the case",
                        "start anew, without -resume");
    }
    for (const Problem& problem : case_.go_on())
        report_.warn(problem.message());
    const auto tell = [this](const std::string& names, const std::string& what) {
        if (!names.empty())
            report_.warn("what " + names + " of " + what + " remember begins anew at t = " + text(case_.time()) +
                         " s: a checkpoint does not hold it");
    };
    tell(solids_->memories_lost(), settings_.script);
    tell(case_.sums_lost(), "system/controlDict, functions,");
    kept_->state.keep("spent", spent_before_);
    kept_->state.keep("processor", processor_);
    report_.warn("the run goes on from " + kept_->path + "; what an earlier part of it recorded after t = " +
                 text(kept_->time) + " s makes way for what comes now");
    report_.go_on_from(kept_->time);
    count_news_.begin_with(counts(), wholes());
    kept_.reset();
}

std::string CoupledRun::describe_checkpoints() const
{
    if (!checkpoint_schedule_.regular()) return checkpoint_schedule_.description();
    if (const auto problem = solids_->cannot_be_kept()) return "none: " + problem->what;
    return checkpoint_schedule_.description();
}

void CoupledRun::checkpoint_if_due()
{
    const CheckpointSchedule::Due due = checkpoint_schedule_.due(
        comm_, {case_.time(), gas_step_, report_.wall_seconds(), requests_->take_checkpoint(), ended_});
    if (due == CheckpointSchedule::Due::no) return;
    stopwatch_.switch_to(Phase::output);
    const double start = report_.wall_seconds();
    write_checkpoint(due);
    const double end = report_.wall_seconds();
    checkpoint_schedule_.written(end, end - start);
    wall_limit_.kept(end - start);
}

void CoupledRun::write_checkpoint(CheckpointSchedule::Due why)
{
    if (const auto problem = solids_->cannot_be_kept()) {
        if (why == CheckpointSchedule::Due::asked) report_.warn(problem->message());
        return;
    }
    records_->flush();  // rows up to here are there when a run goes on from here
    Archive saved;
    keep(saved);
    SpentTime spent = spent_before_.with(comm_, stopwatch_, report_.wall_seconds());
    saved.keep("spent", spent);
    saved.keep("processor", processor_);
    const std::optional<Problem> problem = checkpoints_.write(case_.time(), saved, facts_);
    if (problem) report_.warn(problem->message());
    if (why != CheckpointSchedule::Due::by_time) return;
    Archive loading = Archive::loading(saved.state());
    keep(loading);
}

std::string CoupledRun::way_to_go_on() const
{
    const std::string newest = checkpoints_.newest_name();
    if (newest.empty()) return "";
    return "The run can go on from " + newest + ": the same command with -resume, or tools/run with --resume.";
}

}  // namespace interphase
