// SPDX-License-Identifier: GPL-3.0-or-later
#include <mpi.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <thread>

#include "run/coupled_run.hpp"

namespace {

/// Ranks usually fail together; then one of them speaks. A rank that fails alone has to stop the others.
bool all_ranks_arrive()
{
    MPI_Request request;
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    constexpr int patience = 300;  // times 10 ms
    for (int i = 0; i < patience; ++i) {
        int arrived = 0;
        MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
        if (arrived) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

int stop_with(const std::string& problem)
{
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const auto speak = [&] { std::fprintf(stderr, "\ninterphase: error: %s\n", problem.c_str()); };
    if (rank == 0) speak();
    if (!all_ranks_arrive()) {
        if (rank != 0) speak();
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
    return 1;
}

std::optional<std::string> run(int argc, char** argv)
{
    try {
        interphase::CoupledRun(argc, argv).run();
        return std::nullopt;
    } catch (const std::exception& error) {
        return error.what();
    }
}

}  // namespace

int main(int argc, char** argv)
{
    // a value that is not finite is reported by the coupler with its place; a trap would only end the process
    setenv("FOAM_SIGFPE", "false", 0);
    // results can be looked at while the run goes on: the file is complete after every flush
    setenv("HDF5_USE_FILE_LOCKING", "FALSE", 0);
    MPI_Init(&argc, &argv);
    const std::optional<std::string> problem = run(argc, argv);
    const int code = problem ? stop_with(*problem) : 0;
    std::fflush(nullptr);
    MPI_Finalize();
    std::_Exit(code);  // OpenFOAM's own exit would finalise MPI a second time
}
