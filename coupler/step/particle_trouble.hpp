// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/problem.hpp"
#include "step/solids.hpp"

namespace interphase {

/// What is wrong with a particle of this rank, if anything, as a user is told it: a position or velocity that is not
/// finite, a weight that is no number of particles.
std::optional<Problem> particle_trouble(const ParticleView& particles, int rank);

}  // namespace interphase
