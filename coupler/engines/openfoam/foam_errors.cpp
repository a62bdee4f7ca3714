// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/foam_errors.hpp"

#include <filesystem>
#include <regex>

#include "base/user_error.hpp"
#include "base/way_to_prepare.hpp"
#include "error.H"

namespace interphase {

namespace {

const std::regex missing_object("request for (\\S+) (\\S+) from objectRegistry \\S+ failed");

/// OpenFOAM's messages have blank lines at their ends, and lists over many lines.
std::string trimmed(const std::string& message)
{
    const std::size_t first = message.find_first_not_of(" \n\t"), last = message.find_last_not_of(" \n\t");
    return first == std::string::npos ? "" : message.substr(first, last - first + 1);
}

std::string first_line(const std::string& words) { return words.substr(0, words.find('\n')); }

Problem reworded(const std::string& message, const std::string& where)
{
    if (message.find("in directory \"polyMesh\"") != std::string::npos)
        return {"the case has no mesh: " + first_line(trimmed(message)),
                "constant/polyMesh, on several ranks that of each of the processor folders, of " +
                    std::filesystem::current_path().string(),
                way_to_prepare()};
    std::smatch found;
    if (!std::regex_search(message, found, missing_object)) return {trimmed(message), where, remedy_for(message)};
    return {"a boundary condition or function object asks for the " + found.str(1) + " `" + found.str(2) +
                "`, which this gas does not have: it is one phase of constant density, laminar, without temperature",
            where,
            "name a field that is there (p, p_rgh, rho, voidage, gh; U; the fluxes phi of U and voidagePhi of voidage "
            "U), or take another type"};
}

std::string first_known(const std::string& place, const std::string& otherwise)
{
    return place.empty() ? otherwise : place;
}

}  // namespace

std::string remedy_for(const std::string& message)
{
    if (message.find("administrator rights") == std::string::npos &&
        message.find("Unknown variable 'WM_") == std::string::npos)
        return "see the message; OpenFOAM's own output is in log.openfoam";
    return "code in a case is compiled by OpenFOAM's wmake, which Debian does not package, and never for root: take a "
           "type without code (uniformFixedValue with a table, exprFixedValue with an expression), or a library by "
           "`libs` in system/controlDict";
}

bool same_complaint(const std::string& one, const std::string& other)
{
    const auto without_list = [](const std::string& message) {
        return message.substr(0, message.find("available objects"));
    };
    return without_list(one) == without_list(other);
}

bool asks_for_what_is_not_there(const std::string& message)
{
    return std::regex_search(message, missing_object) || message.find("Could not find ") != std::string::npos ||
           message.find("Unable to find ") != std::string::npos || message.find("No valid model") != std::string::npos;
}

namespace {

UserError of_openfoam(Problem problem)
{
    problem.kind = ExitCode::openfoam;
    return UserError(problem);
}

}  // namespace

void with_foam_errors(const std::function<void()>& body, const std::function<std::string(const std::string&)>& place)
{
    try {
        body();
    } catch (const Foam::IOerror& error) {
        throw of_openfoam(reworded(
            error.message(), std::string(error.ioFileName()) + ", line " + std::to_string(error.ioStartLineNumber())));
    } catch (const Foam::error& error) {
        const std::string message = error.message();
        throw of_openfoam(
            reworded(message, first_known(place(message), "OpenFOAM, " + std::string(error.functionName()))));
    }
}

}  // namespace interphase
