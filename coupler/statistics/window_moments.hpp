// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/communicator.hpp"
#include "statistics/statistics_scene.hpp"

namespace interphase {

/// Per window [w], of the spheres whose centres are in it; one on an edge belongs to the right window.
struct WindowMoments {
    Scalars number;          ///< of centres
    Scalars real;            ///< particles, by the weights of parcels
    Scalars sum[2];          ///< of real particles' velocities, horizontal (x) and vertical (z) [m/s]
    Scalars temperature[2];  ///< 1/N sum (v - mean)^2 over N real particles (eqs. 21, 22) [m2/s2]; NaN with one centre
                             ///< or none
};

/// Over the whole depth, or of the slice at the front wall alone. Collective.
WindowMoments window_moments(const Communicator& comm, const ParticleView& particles, const SampleWindows& windows,
                             bool front_only);

}  // namespace interphase
