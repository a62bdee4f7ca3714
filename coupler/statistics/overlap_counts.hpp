// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/communicator.hpp"
#include "step/solids.hpp"

namespace interphase {

/// Overlaps of spheres with each other, over the smaller diameter of the two.
struct OverlapCounts {
    Scalars counts;    ///< in the bins between overlap_edges(); those below in the first, those above in the last
    double pairs = 0;  ///< that overlap
    double largest = 0;
    Scalars below;  ///< number below each share
};

/// [751] evenly spaced in the logarithm, 1e-7 to 10^0.5: the bins are 2.3 % wide.
const Scalars& overlap_edges();

/// Each pair once, over all ranks and periodic sides. Collective.
OverlapCounts overlap_counts(const Communicator& comm, const ParticleView& particles, const PeriodicBox& periods,
                             const Scalars& shares);

}  // namespace interphase
