// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "base/problem.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// How far a file of frames, as dumps atom, custom, local and xyz write them, is whole and of no later step than one:
/// the place [bytes] behind its last such frame.
struct WholeFrames {
    std::uintmax_t end = 0;
    bool torn = false;  ///< the frame there is not whole
};
/// Empty where the text is of another kind.
std::optional<WholeFrames> whole_frames(std::istream& text, std::int64_t last_step);

/// Before LIGGGHTS's init(), in a run that goes on from `time` [s] at the present step: dumps into one file go on
/// behind the frames that it has. Later frames, which the run makes again, are put into a file beside it; where dumps
/// of a style cannot go on, all of the file is. `resumed`: what a dump would write at the start was written before;
/// elsewhere it is written anew. What there is to be told of this rank's files.
std::vector<Problem> go_on_dumping(LAMMPS_NS::LAMMPS& lmp, double time, bool resumed);

}  // namespace interphase
