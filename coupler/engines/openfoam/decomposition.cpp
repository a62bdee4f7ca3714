// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/decomposition.hpp"

#include <mpi.h>

#include <algorithm>
#include <regex>
#include <string>

#include "base/user_error.hpp"

namespace interphase {

namespace {

namespace fs = std::filesystem;

int single_parts(const fs::path& folder)
{
    int parts = 0;
    while (fs::is_directory(folder / ("processor" + std::to_string(parts))))
        ++parts;
    return parts;
}

/// Of the folder processorsN whose N is the run's number of ranks, else of any; 0 where there is none.
int collated_parts(const fs::path& folder, int ranks)
{
    static const std::regex name("processors(\\d+)(_\\d+-\\d+)?");
    int parts = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string called = entry.path().filename().string();
        std::smatch found;
        if (!std::regex_match(called, found, name) || !entry.is_directory()) continue;
        if (const int n = std::stoi(found.str(1)); parts != ranks) parts = n;
    }
    return parts;
}

}  // namespace

void refuse_wrong_decomposition(const fs::path& folder)
{
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    if (ranks == 1) return;
    const int single = single_parts(folder), collated = collated_parts(folder, ranks);
    const std::string keep = single + collated > 0 ? "`reconstructPar` takes out what the parts hold of written times; "
                                                     "then "
                                                   : "";
    const std::string decompose = keep + "run `decomposePar -force` with numberOfSubdomains " + std::to_string(ranks) +
                                  " in system/decomposeParDict (tools/run --ranks does all of it)";
    if (single == 0 && collated == 0)
        throw UserError("the run has " + std::to_string(ranks) +
                            " ranks, and the case is not decomposed: there is neither processor0 nor processors" +
                            std::to_string(ranks),
                        folder.string(), decompose + ", or start 1 rank");
    if (const int parts = single > 0 ? single : collated; single != ranks && collated != ranks)
        throw UserError("the case is decomposed into " + std::to_string(parts) + " parts, and the run has " +
                            std::to_string(ranks) + " ranks",
                        folder.string(), decompose + ", or start " + std::to_string(parts) + " ranks");
    if (!fs::is_regular_file(folder / "system/decomposeParDict"))
        throw UserError("system/decomposeParDict is missing, which OpenFOAM wants in a run on several ranks",
                        folder.string(), "add it, with numberOfSubdomains " + std::to_string(ranks) + " and a method");
}

}  // namespace interphase
