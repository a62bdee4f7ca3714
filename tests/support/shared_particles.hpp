// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "support/point_particles.hpp"
#include "support/world.hpp"

namespace interphase::test {

/// Particles at rest or in flight without gravity: of the list, the same on all ranks, number n lives on rank n modulo
/// their number.
inline PointParticles shared(const std::vector<Particle>& all, const Vector& gravity = Vector::Zero())
{
    std::vector<Particle> mine;
    for (std::size_t n = 0; n < all.size(); ++n)
        if (static_cast<int>(n) % world().size() == world().rank()) mine.push_back(all[n]);
    return {world(), mine, gravity, 1e-3};
}

}  // namespace interphase::test
