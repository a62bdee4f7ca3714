// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace interphase {

/// Speed [m/s], against the particles, at which a disturbance of the solid fraction phi runs through particles that
/// drag carries: phi |dw/dphi|, w = eps s the hindered velocity (Kynch, Trans. Faraday Soc. 48 (1952) 166). A particle
/// whose weight less buoyancy is given has k(eps, s) s proportional to eps, so
///     dln w/dphi = -1/eps - (1/eps + dln k/dphi)/(1 + dln k/dln s);
/// with k ~ eps^(1 - n + 1) of Richardson and Zaki's w ~ eps^n it is n phi w/eps.
/// @param rate_of  drag rate k [kg/s] of a voidage and a slip speed [m/s]
/// @param slip     s, above 0 [m/s]
template <class Rate>
double kinematic_wave_speed(const Rate& rate_of, double voidage, double slip)
{
    constexpr double step = 1e-3;  // of differences that are right to 1e-6: the voidage's, and a share of the slip
    const double by_fraction = std::log(rate_of(voidage - step, slip) / rate_of(voidage + step, slip)) / (2 * step);
    const double by_slip =
        std::log(rate_of(voidage, slip * (1 + step)) / rate_of(voidage, slip * (1 - step))) / (2 * step);
    const double phi = 1 - voidage;
    return phi * slip * std::abs(1 + (1 + voidage * by_fraction) / (1 + by_slip));
}

}  // namespace interphase
