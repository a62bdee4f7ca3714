// SPDX-License-Identifier: GPL-3.0-or-later
// What ends a coupling step: particles outside the mesh, particles that got lost, numbers that cannot be.
#include <algorithm>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "step/coupling_step.hpp"
#include "step/particle_trouble.hpp"

namespace interphase {

void CouplingStep::inspect_start()
{
    const ParticleView particles = solids_.particles();
    particle_count_ = comm_.sum(static_cast<long>(particles.size()));
    comm_.fail_together(
        trouble(particles));  // before a value that is not finite spreads through the gas to other particles
}

void CouplingStep::refuse_particles_outside(const ParticleView& particles) const
{
    std::optional<Problem> problem;
    if (settings_.outside_mesh == OutsideMesh::stop)
        for (std::size_t i = 0; i < homes_.size() && !problem; ++i) {
            if (homes_[i].known()) continue;
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

void CouplingStep::refuse_loss(const ParticleView& particles, long lost) const
{
    const std::string how_many =
        std::to_string(lost) + " of " + std::to_string(particle_count_) +
        " particles were lost in this gas step: they were outside the particles' domain and were dropped";
    const std::string remedy =
        "check walls and boundaries in the script, and the solid step; a scene that removes particles "
        "on purpose says so with a fix massflow/mesh ... delete_atoms";

    // Which one: over all ranks, an array as long as the highest id. The run ends here, so that size does not matter.
    const auto highest = std::max_element(ids_at_start_.begin(), ids_at_start_.end());
    const double last_id = comm_.max(highest == ids_at_start_.end() ? 0.0 : *highest);
    Scalars there(static_cast<std::size_t>(last_id) + 1, 0.0);
    for (std::size_t i = 0; i < particles.size(); ++i)
        if (particles.id[i] <= last_id) there[static_cast<std::size_t>(particles.id[i])] = 1;
    comm_.sum(there);
    std::optional<Problem> problem;
    for (std::size_t i = 0; i < ids_at_start_.size() && !problem; ++i)
        if (there[static_cast<std::size_t>(ids_at_start_[i])] == 0)
            problem = Problem{how_many,
                              "particle " + std::to_string(ids_at_start_[i]) + " (rank " +
                                  std::to_string(comm_.rank()) + ") is one of them; it started the step at " +
                                  text(Vector(Eigen::Map<const Vector>(&positions_at_start_[3 * i]))),
                              remedy};
    comm_.fail_together(problem);
    throw UserError(how_many, "among particles that the script had just inserted", remedy);
}

std::optional<Problem> CouplingStep::trouble(const ParticleView& particles) const
{
    const auto problem = particle_trouble(particles, comm_.rank());
    return problem ? problem : gas_.trouble();
}

}  // namespace interphase
