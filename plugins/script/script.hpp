// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fix.h"

/// What integrators that bring their own collisions take from the script, and what they do not bear in it. `fix` is the
/// integrator: messages name its style. All are collective and end the run where something is wrong.
namespace interphase::script {

/// Nothing else moves the particles.
void refuse_other_integrators(LAMMPS_NS::LAMMPS& lmp, const LAMMPS_NS::Fix& fix);

/// From `unbounded` on there is no bound worth a word.
struct Bounds {
    double least, most;
};
constexpr double unbounded = 1e30;

/// Reads `fix ID all property/global NAME peratomtypepair ...`, a number within the bounds for each pair of types:
/// `take` gets the two types, from 0, and the number.
void read_between_types(LAMMPS_NS::LAMMPS& lmp, const LAMMPS_NS::Fix& fix, const char* name, const Bounds& bounds,
                        const std::function<void(int, int, double)>& take);

/// LIGGGHTS sorts particles every 1000 steps if the script says nothing, and takes the bins' width from a pair style.
/// Where there is none it is `width` [m].
void sort_by_default(LAMMPS_NS::LAMMPS& lmp, double width);

/// Gives the numbers f_ID[1], f_ID[2], ... of the fix names that a script may use: a variable `ID_NAME`, of style
/// equal, for each of `names`, so that nobody has to count places (`thermo_style custom step v_ID_NAME`). A variable of
/// that name that is there already stays as it is.
void name_values(LAMMPS_NS::LAMMPS& lmp, const LAMMPS_NS::Fix& fix, const std::vector<std::string>& names);

}  // namespace interphase::script
