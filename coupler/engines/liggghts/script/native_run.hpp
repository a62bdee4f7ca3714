// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace interphase {

/// What the packaged program `liggghts` does, on all ranks of MPI_COMM_WORLD: reads the script that the arguments name
/// (or standard input), stops on signals after the step. Before the script, the plug-ins are loaded: a UserError where
/// that fails. LIGGGHTS's own errors are UserErrors, too. `arguments`: after the program's name.
void run_natively(const std::vector<std::string>& arguments, const std::vector<std::string>& plugins);

}  // namespace interphase
