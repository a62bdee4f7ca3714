// SPDX-License-Identifier: GPL-3.0-or-later
#include <mpi.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "base/exit_code.hpp"
#include "base/stop_together.hpp"
#include "base/version.hpp"
#include "engines/liggghts/plugins/plugin_opener.hpp"
#include "engines/liggghts/solids/liggghts_maker.hpp"
#include "engines/openfoam/foam_case.hpp"
#include "run/count_page.hpp"
#include "run/coupled_run.hpp"
#include "settings/key_page.hpp"
#include "settings/method_page.hpp"
#include "settings/read_settings.hpp"

namespace {

constexpr const char* usage = R"(usage: interphase [-case DIR] [-resume | -overwrite] [-wallLimit SECONDS]
       mpirun -n N interphase -parallel [-case DIR] ...

Runs a coupled case: LIGGGHTS for the particles, OpenFOAM for the gas.

  -case DIR            the case; the current folder where it is not given
  -parallel            on N ranks, of a case that decomposePar has cut into N parts
  -resume              go on from the newest whole checkpoint of the case
  -overwrite           replace the records of an earlier run in the case
  -wallLimit SECONDS   end, with a checkpoint, before the run has taken so long

  -help                OpenFOAM's options as well
  -help keys           the keys of system/couplingDict
  -help counts         what a run counts, and when to worry
  -help methods        the collision methods, LIGGGHTS's and those of plug-ins at hand
  -help methods PLUGIN ...   those of LIGGGHTS and of these plug-ins, by name or path; counts likewise
  -version             version, commit, compiler, engines

A case is a folder with system/controlDict, system/couplingDict, a mesh, fields in 0/, and a LIGGGHTS script. tools/run
prepares one, runs it and draws it; cases/ has examples.
Exit code: 0 at the end time; tools/CLUSTERS.md has the table.
)";

bool asks_for_usage(int argc, char** argv)
{
    return argc == 2 && (std::string(argv[1]) == "--help" || std::string(argv[1]) == "-h");
}

/// The page that is asked for; empty where none is.
std::string page_asked_for(int argc, char** argv)
{
    using namespace interphase;
    if (argc < 3 || std::string(argv[1]) != "-help") return "";
    const std::string about = argv[2];
    if (about == "keys" && argc == 3) return key_page(setting_keys(LiggghtsMaker()));
    if (about != "methods" && about != "counts") return "";
    const std::vector<OpenPlugin> plugins =
        argc == 3 ? open_plugins_at_hand() : open_plugins(Communicator(), {argv + 3, argv + argc}, "command line");
    return about == "methods" ? method_page(methods_of(plugins))
                              : count_page(LiggghtsSolids::count_kinds(), counts_of(plugins));
}

void show(const std::string& page)
{
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) std::fputs(page.c_str(), stdout);
}

/// The one place that knows both engines. Returns the exit code.
int couple(int argc, char** argv)
{
    using namespace interphase;
    FoamCase gas_case(argc, argv);
    const LiggghtsMaker liggghts(LaterStart{gas_case.time(), gas_case.options().resumes});
    CoupledRun run(gas_case, liggghts, gas_case.options());
    return run.run();
}

std::optional<interphase::Failure> run(int argc, char** argv, int& code)
{
    try {
        const std::string page = page_asked_for(argc, argv);
        if (page.empty())
            code = couple(argc, argv);
        else
            show(page);
        return std::nullopt;
    } catch (const std::exception& error) {
        return interphase::failure_of(error);
    }
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc == 2 && (std::string(argv[1]) == "-version" || std::string(argv[1]) == "--version")) {
        std::printf("%sengines: LIGGGHTS %s, OpenFOAM %s\n",
                    interphase::description(interphase::this_version()).c_str(), INTERPHASE_LIGGGHTS_VERSION,
                    interphase::FoamCase::version().c_str());
        return 0;
    }
    if (asks_for_usage(argc, argv)) {
        std::fputs(usage, stdout);
        return 0;
    }
    // a value that is not finite is reported by the coupler with its place; a trap would only end the process
    setenv("FOAM_SIGFPE", "false", 0);
    // results can be looked at while the run goes on: the file is complete after every flush
    setenv("HDF5_USE_FILE_LOCKING", "FALSE", 0);
    MPI_Init(&argc, &argv);
    int code = 0;
    const std::optional<interphase::Failure> failure = run(argc, argv, code);
    if (failure) interphase::stop_together("interphase", *failure);
    std::fflush(nullptr);
    MPI_Finalize();
    std::_Exit(code);  // OpenFOAM's own exit would finalise MPI a second time
}
