// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase {

/// With what the program ends; tools/CLUSTERS.md has the table for users. 2 is left to tools/run, for a command line
/// that it refuses.
enum class ExitCode : int {
    finished = 0,    ///< the run reached its end
    refused = 1,     ///< case or command line are to be put right; nothing was computed
    diverged = 3,    ///< a step came out wrong: numbers that are not finite, particles that got lost
    liggghts = 4,    ///< LIGGGHTS ended with an error of its own
    openfoam = 5,    ///< OpenFOAM ended with an error of its own
    disk = 6,        ///< what was to be written could not be, or the disk of the case is full
    internal = 7,    ///< an error of the program itself, or no memory left
    wall_limit = 8,  ///< ended before its limit of wall-clock time; it can go on
};

/// With what a run ends that signal `number` has ended, as in a shell.
constexpr int exit_code_of_signal(int number) { return 128 + number; }

}  // namespace interphase
