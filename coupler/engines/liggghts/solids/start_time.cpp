// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/start_time.hpp"

#include <cmath>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "lammps.h"
#include "update.h"

namespace interphase {

std::optional<Problem> start_particles_at(LAMMPS_NS::LAMMPS& lmp, double time, double solid_step,
                                          const Settings& settings)
{
    if (time <= 0) return std::nullopt;  // of a bed that was filled without gas, the step may be any
    LAMMPS_NS::Update& update = *lmp.update;
    const auto step = static_cast<double>(update.ntimestep);
    const double of_particles = (step - settings.step_at_time_zero) * solid_step;
    const double tolerance = 0.5 * solid_step + 1e-6 * time;  // times have six digits in OpenFOAM's names of folders
    if (step > 0 && std::abs(of_particles - time) > tolerance)
        throw UserError("gas and particles do not start at the same time: the gas at t = " + text(time) +
                            " s, the particles at step " + text(step) + ", which is t = " + text(of_particles) +
                            " s in steps of " + text(solid_step) + " s",
                        "startFrom and startTime of system/controlDict, read_restart of " + settings.script,
                        "read the restart file of step " +
                            text(std::round(time / solid_step) + settings.step_at_time_zero) +
                            ", or start the gas from the time folder that belongs to the particles; where they do "
                            "belong together and "
                            "the steps are counted from elsewhere, say `particles { stepAtTimeZero " +
                            text(step - std::round(time / solid_step)) + "; }` in system/couplingDict");
    update.atime = time;
    update.atimestep = update.ntimestep;
    if (step > 0) return std::nullopt;
    return Problem{"the gas starts at t = " + text(time) +
                       " s, and the particles of the script have no time: they are taken as those of that time",
                   settings.script, "none is needed if they are; read_restart brings particles with their step"};
}

}  // namespace interphase
