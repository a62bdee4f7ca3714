// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/stop_together.hpp"

#include <mpi.h>

#include <chrono>
#include <cstdio>
#include <thread>

namespace interphase {

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

}  // namespace

int stop_together(const std::string& program, const std::string& problem)
{
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const auto speak = [&] { std::fprintf(stderr, "\n%s: error: %s\n", program.c_str(), problem.c_str()); };
    if (rank == 0) speak();
    if (!all_ranks_arrive()) {
        if (rank != 0) speak();
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
    return 1;
}

}  // namespace interphase
