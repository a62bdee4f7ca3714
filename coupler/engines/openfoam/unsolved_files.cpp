// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/unsolved_files.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "IFstream.H"
#include "OSspecific.H"
#include "base/user_error.hpp"
#include "dictionary.H"

namespace interphase {

namespace {

struct Unsolved {
    const char* file;    ///< its name up to the first dot; * at the start stands for anything
    const char* what;    ///< it asks for
    const char* remedy;  ///< beside removing it
    /// Entries of which one, where it is there and has this value, makes the file ask for nothing.
    std::vector<std::pair<const char*, std::vector<std::string>>> idle{};
    bool in_blocks = false;  ///< each of its blocks is one such model, and active unless it says otherwise
};

const std::vector<std::string> off{"off", "no", "false", "none", "n", "f"};

/// The first that fits counts.
const std::vector<Unsolved>& unsolved()
{
    static const std::vector<Unsolved> all{
        {"fvOptions",
         "sources and constraints (fvOptions), which the gas solver does not apply",
         "set `active no;` in each",
         {},
         true},
        {"turbulenceProperties",
         "a turbulence model, and the gas solver is laminar",
         "set `simulationType laminar;`",
         {{"simulationType", {"laminar"}}}},
        {"momentumTransport",
         "a turbulence model, and the gas solver is laminar",
         "set `simulationType laminar;`",
         {{"simulationType", {"laminar"}}}},
        {"RASProperties",
         "a turbulence model, and the gas solver is laminar",
         "set `RASModel laminar;`",
         {{"RASModel", {"laminar"}}, {"turbulence", off}}},
        {"LESProperties",
         "a turbulence model, and the gas solver is laminar",
         "set `LESModel laminar;`",
         {{"LESModel", {"laminar"}}, {"turbulence", off}}},
        {"dynamicMeshDict",
         "a mesh that moves or refines itself, and the gas's mesh stays as it is",
         "set `dynamicFvMesh staticFvMesh;`; what moves in the script's meshes the particles feel, the gas does not",
         {{"dynamicFvMesh", {"staticFvMesh"}}}},
        {"MRFProperties",
         "rotating frames of reference, which the gas solver does not have",
         "set `active no;` in each zone",
         {},
         true},
        {"porosityProperties",
         "porous zones, which the gas solver does not have",
         "set `active no;` in each zone (particles that are held resist the gas, too)",
         {},
         true},
        {"thermophysicalProperties",
         "a gas with temperature, and this one has the constant rho and mu of transportProperties", ""},
        {"thermo", "a gas with temperature, and this one has the constant rho and mu of transportProperties", ""},
        {"radiationProperties",
         "radiation, and the gas has no temperature",
         "set `radiation off;`",
         {{"radiation", off}, {"radiationModel", {"none"}}}},
        {"combustionProperties",
         "combustion, and the gas does not react",
         "set `active no;`",
         {{"active", off}, {"combustionModel", {"none", "noCombustion"}}}},
        {"chemistryProperties", "chemistry, and the gas does not react", "set `chemistry off;`", {{"chemistry", off}}},
        {"reactions", "chemistry, and the gas does not react", ""},
        {"phaseProperties", "several phases of fluid, and there is one gas", ""},
        {"regionProperties", "several regions, and there is one", ""},
        {"*CloudProperties",
         "a cloud of OpenFOAM's own parcels, and the particles are LIGGGHTS's",
         "set `active false;` in solution",
         {{"active", off}}},
        {"*Cloud1Properties",
         "a cloud of OpenFOAM's own parcels, and the particles are LIGGGHTS's",
         "set `active false;` in solution",
         {{"active", off}}},
        {"transportProperties", "", ""},  // read
        {"*Properties",
         "a model that the gas solver does not have",
         "set `active no;`, give the file another name",
         {{"active", off}}},
    };
    return all;
}

bool fits(const std::string& pattern, const std::string& name)
{
    if (pattern[0] != '*') return name == pattern;
    const std::string end = pattern.substr(1);
    const auto same = [](char a, char b) { return std::tolower(a) == std::tolower(b); };
    return name.size() >= end.size() && std::equal(end.rbegin(), end.rend(), name.rbegin(), same);
}

/// What editors and users keep beside the files that count.
bool is_copy(const std::string& name)
{
    const auto ends = [&name](const std::string& end) {
        return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
    };
    return ends("~") || ends(".orig") || ends(".org") || ends(".bak") || ends(".old") || ends(".save");
}

bool says(const Foam::dictionary& dict, const char* key, const std::vector<std::string>& values)
{
    const Foam::entry* entry = dict.findEntry(key, Foam::keyType::LITERAL);
    if (!entry || entry->isDict() || entry->stream().empty()) return false;
    const Foam::token& first = entry->stream().first();
    return first.isWord() && std::find(values.begin(), values.end(), first.wordToken()) != values.end();
}

bool is_idle(const Unsolved& what, const Foam::dictionary& dict)
{
    for (const auto& [key, values] : what.idle) {
        if (says(dict, key, values)) return true;
        const Foam::dictionary* solution = dict.findDict("solution");  // of clouds
        if (solution && says(*solution, key, values)) return true;
    }
    if (!what.in_blocks) return false;
    for (const Foam::entry& block : dict)
        if (block.isDict() && block.keyword() != "FoamFile" && !says(block.dict(), "active", off)) return false;
    return true;
}

void refuse(const Foam::fileName& path, const std::string& where, const Unsolved& what)
{
    Foam::IFstream stream(path);
    const Foam::dictionary dict(stream);
    if (is_idle(what, dict)) return;
    std::string line;
    for (const auto& [key, values] : what.idle) {
        const Foam::entry* entry = dict.findEntry(key, Foam::keyType::LITERAL);
        if (entry && line.empty()) line = ", line " + std::to_string(entry->startLineNumber());
    }
    const std::string remedy = what.remedy;
    throw UserError(std::string("the case asks for ") + what.what, where + line,
                    remedy.empty() ? "remove the file" : remedy + ", or remove the file");
}

}  // namespace

void refuse_what_is_not_solved(const Foam::fileName& folder)
{
    for (const char* part : {"constant", "system"}) {
        Foam::fileNameList names = Foam::readDir(folder / part, Foam::fileName::FILE, false);
        Foam::sort(names);
        for (const Foam::fileName& name : names) {
            if (is_copy(name)) continue;
            const std::string stem = name.substr(0, name.find('.'));
            for (const Unsolved& what : unsolved()) {
                if (!fits(what.file, stem)) continue;
                if (*what.what) refuse(folder / part / name, std::string(part) + "/" + name, what);
                break;
            }
        }
    }
}

}  // namespace interphase
