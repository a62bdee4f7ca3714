// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/problem.hpp"
#include "settings/settings.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// After the script, in a run whose gas starts at `time` [s] from fields that an earlier run wrote: sets LIGGGHTS's
/// time to it. Particles of a restart file know their step, which has to be that time in steps of `solid_step` [s] from
/// `settings.step_at_time_zero` on: a UserError where it is not. Files of data know none; that is told.
std::optional<Problem> start_particles_at(LAMMPS_NS::LAMMPS& lmp, double time, double solid_step,
                                          const Settings& settings);

}  // namespace interphase
