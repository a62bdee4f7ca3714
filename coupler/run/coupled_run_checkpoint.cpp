// SPDX-License-Identifier: GPL-3.0-or-later
// A run's state: when it is written, and how a run goes on from it.
#include <filesystem>
#include <regex>
#include <sstream>

#include "base/sha256.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "base/version.hpp"
#include "records/case_inputs.hpp"
#include "run/coupled_run.hpp"

namespace interphase {

namespace {

constexpr const char* trigger = "checkpoint";  // a file in the case's folder that asks for one

/// The end may be another when a run goes on.
std::string without_end(const InputFile& file)
{
    std::istringstream lines(*file.text);
    std::string rest;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string first;
        words >> first;
        if (first != "endTime") rest += line + '\n';
    }
    return rest;
}

/// "name (path: styles), ..." without the paths: a build may be moved.
std::string without_places(const std::string& plugins)
{
    return std::regex_replace(plugins, std::regex("\\([^():]*: "), "(");
}

const char* const control = "system/controlDict";

}  // namespace

Checkpoints::Facts CoupledRun::facts() const
{
    Checkpoints::Facts all;
    if (!comm_.is_master()) return all;
    all = {{"version", name_and_number(this_version())},
           {"engines", solids_->version() + ", " + case_.engine()},
           {"plug-ins", without_places(solids_->plugins())},
           {"solid step", text(clock_.solid_step()) + " s"}};
    for (const InputFile& file : case_inputs(".", settings_.script, settings_.variables)) {
        std::string words = file.sha256 + " of " + text(static_cast<double>(file.bytes)) + " bytes";
        if (file.path == control && file.text) {
            std::istringstream rest(without_end(file));
            words = sha256(rest);
        }
        all.emplace_back("file " + file.path, words);
    }
    return all;
}

void CoupledRun::refuse_other_run(const Checkpoints::Found& found) const
{
    std::optional<Problem> problem;
    if (found.ranks != comm_.size())
        problem = Problem{found.path + " is of a run of " + std::to_string(found.ranks) + " ranks, and this one has " +
                              std::to_string(comm_.size()),
                          "the command line", "go on with " + std::to_string(found.ranks) + " ranks"};
    if (!problem && comm_.is_master()) {
        const Checkpoints::Facts here = facts();
        std::string differences;
        const auto tell = [&](const std::string& words) { differences += "\n    " + words; };
        const auto value = [](const Checkpoints::Facts& of, const std::string& name) -> std::optional<std::string> {
            for (const auto& [key, words] : of)
                if (key == name) return words;
            return std::nullopt;
        };
        for (const auto& [name, then] : found.facts) {
            const auto now = value(here, name);
            const bool is_file = name.rfind("file ", 0) == 0;
            if (!now)
                tell(name + " is gone");
            else if (*now != then)
                tell(is_file ? name + " has changed" : name + ": " + *now + ", and was " + then);
        }
        for (const auto& [name, now] : here)
            if (!value(found.facts, name)) tell(name + " is new");
        if (!differences.empty())
            problem =
                Problem{"the case is not as it was when " + found.path + " was written:" + differences, "the case",
                        "put that back (endTime of system/controlDict may change), or start anew, without "
                        "-resume"};
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
                        "start without -resume; `checkpoint { interval 0.1; }` in system/couplingDict writes some");
    if (const auto problem = solids_->cannot_be_kept()) throw UserError(*problem);
    refuse_other_run(*kept_);
    kept_->state.within("case", [this] { case_.keep(kept_->state); });
    solids_->go_on_from(kept_->state);
}

/// What this run records goes to new files; those of the part before stay, in a folder of their own.
void CoupledRun::put_records_aside() const
{
    std::string folder = "records-until-" + text(kept_->time);
    std::string wrong;
    if (comm_.is_master()) try {
            namespace fs = std::filesystem;
            const std::string name = folder;
            for (int number = 2; fs::exists(folder); ++number)
                folder = name + "-" + std::to_string(number);
            fs::create_directory(folder);
            for (const char* file : {"results.h5", "particles.h5", "particles.xdmf", "snapshots"})
                if (fs::exists(file)) fs::rename(file, fs::path(folder) / file);
        } catch (const std::exception& error) {
            wrong = error.what();
        }
    comm_.fail_together(wrong.empty() ? std::nullopt
                                      : std::optional(Problem{"the records so far could not be put aside: " + wrong,
                                                              folder, "give the right to write in the case's folder"}));
    report_.warn("the run goes on from " + kept_->path + "; what it recorded before is in " + folder +
                 "/, and may reach beyond t = " + text(kept_->time) + " s");
}

void CoupledRun::put_checkpoints_aside() const
{
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
    archive.keep("rows", *rows_);
    if (own_snapshots_) archive.keep("snapshots", *own_snapshots_);
    if (simulated_checkpoints_) archive.keep("checkpoints", *simulated_checkpoints_);
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
    const auto tell = [this](const std::string& names, const std::string& what) {
        if (!names.empty())
            report_.warn("what " + names + " of " + what + " may have summed up begins anew at t = " +
                         text(case_.time()) + " s: a checkpoint does not hold it");
    };
    tell(solids_->sums_lost(), settings_.script);
    tell(case_.sums_lost(), "system/controlDict, functions,");
    kept_.reset();
}

void CoupledRun::begin_checkpoints()
{
    if (settings_.checkpoint_interval <= 0) return;
    simulated_checkpoints_.emplace(case_.time(), settings_.checkpoint_interval);
    simulated_checkpoints_->pass(case_.time(), gas_step_);
}

bool CoupledRun::checkpoint_due()
{
    const double now = case_.time();
    bool due = simulated_checkpoints_ && simulated_checkpoints_->due(now, gas_step_);
    if (simulated_checkpoints_) simulated_checkpoints_->pass(now, gas_step_);
    const bool by_clock = settings_.checkpoint_wall_interval > 0 &&
                          report_.wall_seconds() > last_checkpoint_ + settings_.checkpoint_wall_interval;
    std::error_code none;
    const bool asked =
        comm_.is_master() && std::filesystem::is_regular_file(trigger, none) && std::filesystem::remove(trigger, none);
    const bool wanted = simulated_checkpoints_ || settings_.checkpoint_wall_interval > 0 || stopped_by_ != 0;
    due = due || (ended_ && wanted);
    return comm_.any(asked || (comm_.is_master() && by_clock)) || due;
}

void CoupledRun::checkpoint()
{
    stopwatch_.switch_to(Phase::output);
    last_checkpoint_ = report_.wall_seconds();
    if (const auto problem = solids_->cannot_be_kept()) {
        report_.warn(problem->message());
        return;
    }
    Archive saved;
    keep(saved);
    const std::optional<Problem> problem = checkpoints_.write(case_.time(), saved, facts());
    if (problem) report_.warn(problem->message());
    // this run goes on from what it wrote, so that one that starts from there goes on likewise
    Archive loading = Archive::loading(saved.state());
    keep(loading);
}

}  // namespace interphase
