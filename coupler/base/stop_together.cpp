// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/stop_together.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <new>
#include <thread>

#include "base/disk_room.hpp"
#include "base/user_error.hpp"

/// What Open MPI's MPI_Abort does after it has told so in seven lines; not there in other MPIs.
extern "C" int ompi_mpi_abort(MPI_Comm comm, int code) __attribute__((weak));

namespace interphase {

namespace {

constexpr std::chrono::milliseconds patience(3000), pause_between_looks(10);

bool all_ranks_arrive()
{
    MPI_Request request;
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    for (auto waited = patience * 0; waited < patience; waited += pause_between_looks) {
        int arrived = 0;
        MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
        if (arrived) return true;
        std::this_thread::sleep_for(pause_between_looks);
    }
    return false;
}

int this_rank()
{
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank;
}

/// A full disk shows in many ways, few of which name it.
Failure with_cause(Failure failure)
{
    if (failure.code == ExitCode::disk || !disk_is_full(this_rank())) return failure;
    failure.code = ExitCode::disk;
    failure.message = "the disk is full, which may be the cause: " + failure.message + "\n  disk:   make room at " +
                      std::filesystem::current_path().string();
    return failure;
}

void tell(const std::string& program, const std::string& message)
{
    std::fflush(nullptr);
    std::fprintf(stderr, "\n%s: error: %s\n", program.c_str(), message.c_str());
    std::fflush(stderr);
}

}  // namespace

Failure failure_of(const std::exception& error)
{
    if (const auto* told = dynamic_cast<const UserError*>(&error)) return {told->problem().kind, told->what()};
    if (dynamic_cast<const std::bad_alloc*>(&error))
        return {ExitCode::internal,
                "no memory is left on this machine\n  remedy: more machines, or fewer ranks on each"};
    return {ExitCode::internal, error.what()};
}

void stop_if_alone(const std::string& program, const Failure& failure)
{
    if (all_ranks_arrive()) return;
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const Failure told = with_cause(failure);
    // several may have failed, without all: the lowest of them ends the others while these wait
    std::this_thread::sleep_for(pause_between_looks * 5 * std::min(this_rank(), 40));
    tell(program, told.message + "\n  rank:   " + std::to_string(this_rank()) + ", which of 0 to " +
                      std::to_string(ranks - 1) + " failed first; the others were ended");
    end_all_ranks(MPI_COMM_WORLD, static_cast<int>(told.code));
}

void stop_together(const std::string& program, const Failure& failure)
{
    stop_if_alone(program, failure);
    std::fflush(nullptr);
    const Failure told = with_cause(failure);
    if (this_rank() == 0) {
        tell(program, told.message);
        end_all_ranks(MPI_COMM_WORLD, static_cast<int>(told.code));
    }
    sleep(static_cast<unsigned>(patience.count() / 1000));  // rank 0 ends this one, after it has spoken
    end_all_ranks(MPI_COMM_WORLD, static_cast<int>(told.code));
}

void end_all_ranks(MPI_Comm comm, int code)
{
    std::fflush(nullptr);
    if (ompi_mpi_abort)
        ompi_mpi_abort(comm, code);
    else
        PMPI_Abort(comm, code);
    _exit(code);
}

}  // namespace interphase
