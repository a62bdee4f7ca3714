// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/beetstra.hpp"

#include <algorithm>
#include <cmath>

namespace interphase {

double beetstra(const DragState& state)
{
    const double eps = state.voidage;
    const double phi = solid_fraction(state);
    const double re = state.reynolds;

    const double creeping = 10.0 * phi / (eps * eps) + eps * eps * (1.0 + 1.5 * std::sqrt(phi));

    // The published quotient holds Re^-0.343 and Re^(-0.5 - 2 phi), infinite at Re = 0. All is multiplied by the Re in
    // front; below `none` that leaves nothing of it beside the creeping part. Powers of Re share the logarithm: they
    // are what takes longest.
    constexpr double none = 1e-30;
    const double log_re = std::log(std::max(re, none));
    const double numerator = (1.0 / eps + 3.0 * eps * phi) * re + 8.4 * std::exp((1.0 - 0.343) * log_re);
    const double inertial = numerator / (1.0 + std::exp(3.0 * M_LN10 * phi - (0.5 + 2.0 * phi) * log_re));

    return creeping + 0.413 / (24.0 * eps * eps) * inertial;
}

}  // namespace interphase
