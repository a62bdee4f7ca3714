// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hard_sphere/bodies.hpp"
#include "hard_sphere/cluster.hpp"

namespace interphase::hard_sphere {

enum class Direction { forward, backward };

/// Poisson's hypothesis for impacts of bodies that touch others, too: compression stops their approach, then
/// restitution returns e_n times the impulse that this took, and e_t times the tangential one. (Newton's, e_n times the
/// velocity, can gain energy there: it repels bodies that others have stopped already. For two bodies the hypotheses
/// agree. Pfeiffer and Glocker, Multibody Dynamics with Unilateral Contacts, Wiley 1996, ch. 8.)
enum class Phase { compression, release, after_release };

/// One pass of projected Gauss-Seidel over a cluster's batches, in their order or against it: each contact in turn gets
/// the impulse that its bodies need, given all others (Jean, CMAME 177 (1999) 235). Normal: v_n + gap/step >= 0;
/// tangential: no slip, within Coulomb's cone. Each update takes kinetic energy or leaves it, but for the release of
/// impacts. `width`: how many contacts are taken at once, 1, 4 or, where the processor has registers for it, 8; 0:
/// what suits it best.
void sweep(std::vector<Body>& bodies, Cluster& cluster, Direction direction, Phase phase, int width = 0);

}  // namespace interphase::hard_sphere
