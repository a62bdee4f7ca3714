// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/resumed_functions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <vector>

#include "base/free_name.hpp"
#include "base/text.hpp"
#include "engines/openfoam/private_member.hpp"
#include "functionObjectList.H"
#include "timeControlFunctionObject.H"

namespace interphase {

struct ExecutionIndex {
    using Member = Foam::label Foam::timeControl::*;
    friend Member place_of(ExecutionIndex);
};
template struct PrivateMember<ExecutionIndex, &Foam::timeControl::executionIndex_>;

namespace {

namespace fs = std::filesystem;

/// What OpenFOAM gives nobody to set.
struct OpenTime : Foam::Time {
    static Foam::label& start_index(Foam::Time& time) { return time.*(&OpenTime::startTimeIndex_); }
    static Foam::scalar& start(Foam::Time& time) { return time.*(&OpenTime::startTime_); }
    /// As many as there would have been with the interval that is given now; other clocks begin with the program.
    static void count_writes(Foam::Time& time)
    {
        const writeControls control = time.*(&OpenTime::writeControl_);
        const bool by_time = control == wcRunTime || control == wcAdjustableRunTime;
        const double since = time.value() - start(time) + 0.5 * time.deltaTValue();
        time.*(&OpenTime::writeTimeIndex_) = by_time ? Foam::label(since / (time.*(&OpenTime::writeInterval_))) : 0;
    }
    /// How many times fields have been due.
    static Foam::label writes(const Foam::Time& time)
    {
        const bool by_steps = time.*(&OpenTime::writeControl_) == wcTimeStep;
        const auto interval = std::max<Foam::label>(1, static_cast<Foam::label>(time.*(&OpenTime::writeInterval_)));
        return by_steps ? time.timeIndex() / interval : time.*(&OpenTime::writeTimeIndex_);
    }
};

/// What was due by now was done; clocks of the processor and on the wall begin with the program.
void pass(const Foam::timeControl& control, const Foam::Time& time)
{
    Foam::label& done = const_cast<Foam::timeControl&>(control).*place_of(ExecutionIndex{});
    const bool by_time = control.control() == Foam::timeControl::ocRunTime ||
                         control.control() == Foam::timeControl::ocAdjustableRunTime;
    if (by_time)
        done = Foam::label((time.value() - time.startTime().value() + 0.5 * time.deltaTValue()) / control.interval());
    if (control.control() == Foam::timeControl::ocWriteTime) done = OpenTime::writes(time);
}

/// The time that a folder is named by.
std::optional<double> time_of(const fs::path& folder)
{
    const std::string name = folder.filename().string();
    char* end = nullptr;
    const double time = std::strtod(name.c_str(), &end);
    if (name.empty() || *end != '\0' || !std::isfinite(time)) return std::nullopt;
    return time;
}

/// Types that look at the present step only; others may remember.
const std::set<std::string> without_sums{"CourantNo",
                                         "Lambda2",
                                         "PecletNo",
                                         "Q",
                                         "cellMinMax",
                                         "components",
                                         "continuityError",
                                         "derivedFields",
                                         "div",
                                         "enstrophy",
                                         "fieldExtents",
                                         "fieldMinMax",
                                         "flux",
                                         "fluxSummary",
                                         "forceCoeffs",
                                         "forces",
                                         "grad",
                                         "histogram",
                                         "mag",
                                         "magSqr",
                                         "nearWallFields",
                                         "patchProbes",
                                         "pressure",
                                         "probes",
                                         "residuals",
                                         "sets",
                                         "solverInfo",
                                         "streamFunction",
                                         "surfaceFieldValue",
                                         "surfaces",
                                         "timeInfo",
                                         "turbulenceFields",
                                         "volFieldValue",
                                         "vorticity",
                                         "vtkWrite",
                                         "wallShearStress",
                                         "writeCellCentres",
                                         "writeCellVolumes",
                                         "writeDictionary",
                                         "writeObjects",
                                         "yPlus"};

}  // namespace

void start_here(Foam::Time& time)
{
    OpenTime::start_index(time) = time.timeIndex();
    OpenTime::count_writes(time);
}

bool make_functions_here(Foam::Time& time)
{
    auto& all = const_cast<Foam::functionObjectList&>(time.functionObjects());
    all.stateDict().clear();  // counts of sums whose fields are not there
    const Foam::scalar start = OpenTime::start(time);
    OpenTime::start(time) = time.value();  // names their folders
    const auto back = [&] { OpenTime::start(time) = start; };
    bool more = false;
    try {
        more = time.run();
    } catch (...) {
        back();
        throw;
    }
    back();
    for (Foam::label i = 0; i < all.size(); ++i)
        if (const auto* timed = dynamic_cast<const Foam::functionObjects::timeControl*>(&all[i])) {
            pass(timed->executeControl(), time);
            pass(timed->writeControl(), time);
        }
    return more;
}

std::string put_later_output_aside(const Foam::Time& time)
{
    const fs::path folder = "postProcessing";
    if (!fs::is_directory(folder)) return "";
    const double now = time.value(), close = 0.5 * time.deltaTValue();
    std::vector<fs::path> later, of_now;
    for (auto entry = fs::recursive_directory_iterator(folder); entry != fs::recursive_directory_iterator(); ++entry) {
        const auto of = entry->is_directory() ? time_of(entry->path()) : std::nullopt;
        if (!of) continue;
        entry.disable_recursion_pending();
        if (*of < now - close) continue;
        (*of > now + close ? later : of_now).push_back(entry->path());
    }
    if (later.empty() && of_now.empty()) return "";
    const std::string aside = free_name(folder.string(), "beyond-" + text(now));
    const auto place = [&](const fs::path& path) {
        const fs::path to = aside / path.lexically_relative(folder);
        fs::create_directories(to.parent_path());
        return to;
    };
    for (const fs::path& path : later)
        fs::rename(path, place(path));
    for (const fs::path& path : of_now)
        fs::copy(path, place(path), fs::copy_options::recursive);
    return aside;
}

std::string functions_with_sums(const Foam::Time& time)
{
    std::string names;
    const Foam::dictionary* functions = time.controlDict().findDict("functions");
    if (!functions) return names;
    for (const Foam::entry& function : *functions) {
        if (!function.isDict() || !function.dict().getOrDefault<Foam::Switch>("enabled", true)) continue;
        const std::string type = function.dict().getOrDefault<Foam::word>("type", "");
        if (without_sums.count(type) > 0) continue;
        names += (names.empty() ? "" : ", ") + std::string(function.keyword()) + " (" + type + ")";
    }
    return names;
}

}  // namespace interphase
