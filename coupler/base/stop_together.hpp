// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>

#include <exception>
#include <string>

#include "base/exit_code.hpp"

namespace interphase {

/// Why a program ends before its end, as the user reads it.
struct Failure {
    ExitCode code = ExitCode::internal;
    std::string message;
};

Failure failure_of(const std::exception& error);

/// Called where a rank fails, before it unwinds into anything collective: a rank that the others do not follow within
/// seconds tells the failure and ends all of them. Returns where every rank has come here. MPI_COMM_WORLD.
void stop_if_alone(const std::string& program, const Failure& failure);

/// The end of a program that cannot go on: tells the failure once, however many ranks have it, and ends all ranks with
/// its code. Between MPI_Init and MPI_Finalize.
[[noreturn]] void stop_together(const std::string& program, const Failure& failure);

/// Ends all ranks with `code`. Open MPI's own words about that, which would bury ours, stay away.
[[noreturn]] void end_all_ranks(MPI_Comm comm, int code);

}  // namespace interphase
