// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/function_objects.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <vector>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "engines/openfoam/foam_errors.hpp"
#include "engines/openfoam/resumed_functions.hpp"
#include "functionObjectList.H"

namespace interphase {

namespace {

using Foam::dictionary;
using Foam::entry;

constexpr const char* log_name = "log.openfoam";

bool making_them = false;
struct MakingThem {
    MakingThem() { making_them = true; }
    ~MakingThem() { making_them = false; }
};

/// The first lines of the message in OpenFOAM's log that stands before `last`, or at its end; without the places in
/// OpenFOAM's sources and the lists of what it knows.
std::string words_of_openfoam(const std::string& last)
{
    constexpr std::size_t most = 6;
    std::cout.flush();
    std::ifstream log(log_name);
    std::vector<std::string> lines;
    bool wanted = false;
    for (std::string line; std::getline(log, line);) {
        if (!last.empty() && line.find(last) != std::string::npos) break;
        if (line.find("--> FOAM ") != std::string::npos) {
            lines.clear();
            wanted = true;
            continue;
        }
        if (line.find_first_not_of(" \t") == std::string::npos) continue;
        if (line.find("From function") != std::string::npos || line.rfind("Valid ", 0) == 0) wanted = false;
        if (wanted && lines.size() < most) lines.push_back("\n  | " + line);
    }
    std::string all;
    for (const std::string& line : lines)
        all += line;
    return all;
}

/// OpenFOAM ends the process where an entry of a function object is missing, with its words in its log only.
void show_at_exit()
{
    if (!making_them || !Foam::Pstream::master()) return;
    const std::string words = words_of_openfoam("");
    const Problem problem{"OpenFOAM stopped at a function object of the case:" + words, "system/controlDict, functions",
                          remedy_for(words)};
    std::fprintf(stderr, "\ninterphase: error: %s\n", problem.message().c_str());
    std::fflush(nullptr);
    _exit(static_cast<int>(ExitCode::openfoam));
}

const dictionary& functions_of(const Foam::Time& time)
{
    const entry* found = time.controlDict().findEntry("functions", Foam::keyType::LITERAL);
    return found && found->isDict() ? found->dict() : dictionary::null;
}

std::string place_of(const entry& function)
{
    return "system/controlDict, functions/" + std::string(function.keyword()) + " of type " +
           function.dict().getOrDefault<Foam::word>("type", "none");
}

/// What cannot be right here, or is not there under this name.
struct Unfit {
    const char* why;
    const char* instead;
    const char* flux = nullptr;  ///< the entry that says which flux is meant; it is wrong with phi only
};

const Unfit of_a_gas_alone{"solves for a gas that fills its cells, and here they are shared with particles",
                           "it is not there yet; remove it, or set `enabled no;`"};
const char* const not_conserved =
    "looks at phi, the flux of the gas velocity, which is not conserved where the voidage changes";

const std::map<std::string, Unfit> unfit{
    {"scalarTransport", of_a_gas_alone},
    {"energyTransport", of_a_gas_alone},
    {"icoUncoupledKinematicCloud", {"moves parcels of its own, and the particles are LIGGGHTS's", "remove it"}},
    {"momentum",
     {"sums rho U over cells as if the gas filled them",
      "take volFieldValue with `operation weightedVolIntegrate; weightField voidage; fields (U);`, times rho"}},
    {"setTimeStep", {"sets the time step, which the coupler chooses", "take deltaT, or adjustTimeStep with maxDeltaT"}},
    {"residuals", {"has another name in this OpenFOAM", "take solverInfo"}},
    {"streamFunction", {not_conserved, "add `field voidagePhi;`, the superficial flux", "field"}},
    {"continuityError", {not_conserved, "add `phi voidagePhi;`, the superficial flux", "phi"}},
    {"fluxSummary", {not_conserved, "add `phi voidagePhi;`, the superficial flux", "phi"}},
};

bool is_on(const entry& function)
{
    return function.isDict() && function.dict().getOrDefault<Foam::Switch>("enabled", true);
}

void refuse_unfit(const Foam::Time& time)
{
    for (const entry& function : functions_of(time)) {
        if (!is_on(function)) continue;
        const dictionary& dict = function.dict();
        const auto found = unfit.find(dict.getOrDefault<Foam::word>("type", ""));
        if (found == unfit.end()) continue;
        const auto& [type, what] = *found;
        if (what.flux && dict.getOrDefault<Foam::word>(what.flux, "phi") != "phi") continue;
        throw UserError("the function object `" + type + "` " + what.why, place_of(function), what.instead);
    }
}

void refuse_what_was_not_made(const Foam::Time& time)
{
    for (const entry& function : functions_of(time)) {
        if (!is_on(function)) continue;
        if (time.functionObjects().findObjectID(function.keyword()) >= 0) continue;
        throw UserError("OpenFOAM could not make the function object `" + function.keyword() +
                            "`:" + words_of_openfoam("while loading function object '" + function.keyword() + "'"),
                        place_of(function),
                        "see the message and " + std::string(log_name) +
                            "; its library goes to `libs` there; `enabled no;` leaves it out");
    }
}

}  // namespace

bool run_with_function_objects(Foam::Time& time, bool goes_on)
{
    if (time.timeIndex() != time.startTimeIndex()) return time.run();
    static const int registered = std::atexit(show_at_exit);
    static_cast<void>(registered);
    refuse_unfit(time);
    const MakingThem now;
    const bool more = goes_on ? make_functions_here(time) : time.run();
    if (more) refuse_what_was_not_made(time);
    return more;
}

std::string failing_function(const Foam::Time& time, const std::string& message)
{
    if (!asks_for_what_is_not_there(message)) return "";
    auto& all = const_cast<Foam::functionObjectList&>(time.functionObjects());
    for (Foam::label i = 0; i < all.size(); ++i) {
        try {
            all[i].execute();
            all[i].write();
        } catch (const Foam::error& error) {
            const entry* found = functions_of(time).findEntry(all[i].name(), Foam::keyType::LITERAL);
            if (found && same_complaint(error.message(), message)) return place_of(*found);
        }
    }
    return "";
}

}  // namespace interphase
