// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/solids_energy.hpp"

namespace interphase {

SolidsEnergy solids_energy(const Communicator& comm, Solids& solids, double floor)
{
    const ParticleView particles = solids.particles();
    const Vector g = solids.gravity();
    SolidsEnergy energy;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        const double m = particles.mass[at], r = particles.radius[at];
        energy.translation += 0.5 * m * particles.velocity.col(at).squaredNorm();
        energy.rotation += 0.5 * 0.4 * m * r * r * particles.angular_velocity.col(at).squaredNorm();
        energy.potential += m * (-g.dot(particles.position.col(at)) - g.norm() * floor);
    }
    comm.sum(energy);
    return energy;
}

}  // namespace interphase
