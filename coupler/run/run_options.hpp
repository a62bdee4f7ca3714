// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase {

/// What the command line says of a run, beside the case.
struct RunOptions {
    bool resumes = false;     ///< go on from the newest whole checkpoint
    bool overwrites = false;  ///< replace what an earlier run has left
    double wall_limit = 0;    ///< end, with a checkpoint, before this time of the wall clock [s]; 0: none
};

}  // namespace interphase
