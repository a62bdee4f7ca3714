// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hard_sphere/any_law.hpp"
#include "hard_sphere/bodies.hpp"
#include "hard_sphere/cluster.hpp"
#include "hard_sphere/step_limits.hpp"

namespace interphase::hard_sphere {

/// Fills in the contacts between spheres of a cluster what follows from their paths, as contact_of_spheres() does for
/// one, and what the law says, and starts them (start_from_memory()). Expects the bodies, their materials, in `speed` 1
/// or, where the contact passed on an impulse in the last step, 0, and in `tangential` that impulse. Overlaps are added
/// to `overlaps`. `width`: as of sweep().
void make_ready(Bodies& bodies, Cluster& cluster, const AnyLaw& law, const StepLimits& limits,
                std::vector<Overlap>& overlaps, int width = 0);

/// Gives the bodies the impulses of the last step, which are in `tangential`, and splits them along the normals as they
/// are now, and the couples against rolling. Contacts that pulled would be none: theirs are dropped.
void start_from_memory(std::vector<Body>& bodies, Cluster& cluster);

}  // namespace interphase::hard_sphere
