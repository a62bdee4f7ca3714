// SPDX-License-Identifier: GPL-3.0-or-later
// What ends a coupling step: particles outside the mesh, numbers that cannot be.
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "step/coupling_step.hpp"
#include "step/particle_trouble.hpp"

namespace interphase {

void CouplingStep::inspect_start()
{
    inspected_ = true;
    comm_.fail_together(
        trouble(solids_.particles()));  // before a value that is not finite spreads through the gas to other particles
}

void CouplingStep::refuse_particles_outside(const ParticleView& particles) const
{
    std::optional<Problem> problem;
    if (settings_.outside_mesh == OutsideMesh::stop)
        for (std::size_t i = 0; i < owner_cells_.size() && !problem; ++i) {
            if (owner_cells_[i].known()) continue;
            const Vector x = particles.position.col(static_cast<Eigen::Index>(i));
            problem =
                Problem{"particle " + std::to_string(particles.id[i]) + " (rank " + std::to_string(comm_.rank()) +
                            ") is in no gas cell",
                        "at " + text(x),
                        "keep the particles inside the mesh (walls in the script, initial positions, solid step), "
                        "or set `outsideMesh ignore;` in system/couplingDict to let such particles move without gas"};
        }
    comm_.fail_together(problem);
}

std::optional<Problem> CouplingStep::trouble(const ParticleView& particles) const
{
    const auto problem = particle_trouble(particles, comm_.rank());
    return problem ? problem : gas_.trouble();
}

}  // namespace interphase
