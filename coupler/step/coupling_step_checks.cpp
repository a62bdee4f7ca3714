// SPDX-License-Identifier: GPL-3.0-or-later
// The start as it is found, and what ends a coupling step: particles outside the mesh, numbers that cannot be.
#include <cmath>

#include "base/sphere.hpp"
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

/// The first step does it once more, and counts what it finds; those in no cell are its to judge, too.
void CouplingStep::look_at_start()
{
    inspect_start();
    const ParticleView particles = solids_.particles();
    std::vector<CellAddress> cells(particles.size());
    place_in_periods(particles);
    owner_cell_search_.update(images_of(particles), particles.radius, cells);
    owner_exchange_.plan(cells);
    travellers_.visitor.clear();
    for (const std::size_t i : owner_exchange_.order()) {
        const auto column = static_cast<Eigen::Index>(i);
        Visitor visitor{};
        set(visitor.position, images_of(particles).col(column));
        set(visitor.velocity, particles.velocity.col(column));
        visitor.volume = sphere_volume(particles.radius[column]);
        travellers_.visitor.push_back(visitor);
    }
    owner_exchange_.gather(Message(travellers_.visitor, visitors_.visitor));
    visitors_.cell = owner_exchange_.cells();
    place_visitors();
    if (settings_.two_way) take_voidage(mapping_.solid_volume(volumes_));  // else the gas does not feel the particles
}

void CouplingStep::refuse_other_periods() const
{
    const Vector low = comm_.min(Vector(gas_.locator().bounds().col(0)));
    for (const Vector& translation : gas_.translations())
        for (int axis = 0; axis < 3; ++axis) {
            const double length = periods_.length(axis), tie = 1e-6 * length;
            if (!periods_.periodic[static_cast<std::size_t>(axis)] || std::abs(translation[axis]) <= tie) continue;
            const bool moves_along_axis = std::abs(translation.norm() - std::abs(translation[axis])) <= tie;
            if (moves_along_axis && std::abs(std::abs(translation[axis]) - length) <= tie &&
                std::abs(low[axis] - periods_.box(axis, 0)) <= tie)
                continue;
            const std::string name(1, "xyz"[axis]);
            throw UserError("particles repeat along " + name + " from " + text(periods_.box(axis, 0)) + " to " +
                                text(periods_.box(axis, 1)) + " m; the gas mesh begins at " + text(low[axis]) +
                                " m, and a cyclic pair of it moves by " + text(translation),
                            "the region of create_box in the script, and constant/polyMesh",
                            "give both the same periods");
        }
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
