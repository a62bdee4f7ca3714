// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace interphase {

/// The end of a program that cannot go on: prints the problem once, however many ranks have it, and stops the others
/// where this rank is alone with it. Returns the exit code. Between MPI_Init and MPI_Finalize.
int stop_together(const std::string& program, const std::string& problem);

}  // namespace interphase
