// SPDX-License-Identifier: GPL-3.0-or-later
#include "mp_pic/stress_law.hpp"

#include <algorithm>
#include <cmath>

namespace interphase::mp_pic {

namespace {

constexpr double alpha = 1e-7;

}  // namespace

double HarrisCrighton::stress(double solid_fraction) const
{
    const double phi = std::clamp(solid_fraction, 0.0, 1 - alpha);
    return pressure * std::pow(phi, exponent) / std::max(close_packing - phi, alpha * (1 - phi));
}

double Lun::stress(double solid_fraction) const
{
    const double phi = std::clamp(solid_fraction, 0.0, 1.0);
    const double contact = std::pow(std::max(1 - phi / close_packing, alpha), -2.5 * close_packing);
    return density * phi * temperature * (1 + 2 * (1 + restitution) * phi * contact);
}

}  // namespace interphase::mp_pic
