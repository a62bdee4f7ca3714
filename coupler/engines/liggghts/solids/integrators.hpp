// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "base/communicator.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// Two fixes of the script that move the same particle, each by a whole step: it would go twice the way. None where
/// there are none among the particles of this rank, nor among those that could be inserted.
std::optional<Problem> moved_twice(LAMMPS_NS::LAMMPS& lmp, const std::string& script);

/// How many of this rank's particles no fix of the script moves.
long unmoved(LAMMPS_NS::LAMMPS& lmp);

}  // namespace interphase
