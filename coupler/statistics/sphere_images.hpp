// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/communicator.hpp"
#include "step/solids.hpp"

namespace interphase {

/// A sphere [m], of a particle's number.
struct NumberedSphere {
    double at[3];
    double radius;
    double id;
};

/// The spheres of other ranks, and images of spheres across periodic sides, that may touch those of this rank: which
/// are in the box around them. Collective.
std::vector<NumberedSphere> spheres_around(const Communicator& comm, const ParticleView& particles,
                                           const PeriodicBox& periods);

}  // namespace interphase
