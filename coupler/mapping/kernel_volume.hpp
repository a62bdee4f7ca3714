// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace interphase {

/// The volume over which a particle is spread, 1/sum_c (w_ic^2/V_c) [m3]: its own part in the solid fraction that it
/// sees is its volume over this one. 0: nobody feels it.
struct KernelVolume {
    double here = 0;        ///< where the particle is in its cell
    double on_its_way = 0;  ///< on average along its way, of the particle against its trace
};

/// The standard deviation [m] of a Gaussian kernel of this volume [m3], (4 pi)^(3/2) sigma^3.
inline double kernel_deviation(double kernel_volume) { return std::cbrt(kernel_volume) / std::sqrt(4 * M_PI); }

/// The other way round, from its square [m2].
inline double kernel_volume(double variance) { return std::pow(4 * M_PI * variance, 1.5); }

}  // namespace interphase
