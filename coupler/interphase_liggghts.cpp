// SPDX-License-Identifier: GPL-3.0-or-later
#include <mpi.h>

#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "base/stop_together.hpp"
#include "base/user_error.hpp"
#include "engines/liggghts/script/native_run.hpp"

namespace {

constexpr const char* usage =
    R"(Usage: interphase-liggghts [-plugin NAME_OR_PATH]... [OPTION OF LIGGGHTS]...

LIGGGHTS as it is packaged, with fix styles from plug-ins of interphase. No gas, no OpenFOAM.

  -plugin NAME_OR_PATH   load a plug-in before the script is read; may be given again.
                         With a slash in it: the shared library's path. A bare name such as hard_sphere:
                         lib<name>.so in the folders of $INTERPHASE_PLUGIN_PATH (separated by ':'), in plugins/
                         beside this program, or in ../lib/interphase/plugins
  -h                     this text

Everything else goes on to LIGGGHTS (-in, -var, -log, -screen, -echo ...; -help lists its styles):

  mpirun -n 2 interphase-liggghts -plugin hard_sphere -in in.script -var x 1
)";

struct CommandLine {
    std::vector<std::string> plugins, others;
    bool asks_for_help = false;
};

CommandLine read_command_line(int argc, char** argv)
{
    CommandLine given;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "-h" || word == "--help") {
            given.asks_for_help = true;
        } else if (word == "-plugin" || word == "--plugin") {
            if (i + 1 == argc)
                throw interphase::UserError("nothing follows the last -plugin", "command line",
                                            "give the plug-in's name or path");
            given.plugins.emplace_back(argv[++i]);
        } else {
            given.others.push_back(word);
        }
    }
    return given;
}

std::optional<interphase::Failure> run(int argc, char** argv)
{
    try {
        const CommandLine given = read_command_line(argc, argv);
        int rank = 0;
        MPI_Comm_rank(MPI_COMM_WORLD, &rank);
        if (!given.asks_for_help)
            interphase::run_natively(given.others, given.plugins);
        else if (rank == 0)
            std::fputs(usage, stdout);
        return std::nullopt;
    } catch (const std::exception& error) {
        return interphase::failure_of(error);
    }
}

}  // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    const std::optional<interphase::Failure> failure = run(argc, argv);
    if (failure) interphase::stop_together("interphase-liggghts", *failure);
    std::fflush(nullptr);
    MPI_Finalize();
    return 0;
}
