// SPDX-License-Identifier: GPL-3.0-or-later
#include "drag/beetstra.hpp"

#include <cmath>

namespace interphase {

double beetstra(const DragState& state)
{
    const double eps = state.voidage;
    const double phi = solid_fraction(state);
    const double re = state.reynolds;

    const double creeping = 10.0 * phi / (eps * eps) + eps * eps * (1.0 + 1.5 * std::sqrt(phi));

    // The published quotient holds Re^-0.343 and Re^(-0.5 - 2 phi), infinite at Re = 0. Multiplied out by the
    // powers of Re in front, it has positive exponents only.
    const double power = std::pow(re, 0.5 + 2.0 * phi);
    const double numerator = (1.0 / eps + 3.0 * eps * phi) * re + 8.4 * std::pow(re, 1.0 - 0.343);
    const double inertial = numerator * power / (power + std::pow(10.0, 3.0 * phi));

    return creeping + 0.413 / (24.0 * eps * eps) * inertial;
}

}  // namespace interphase
