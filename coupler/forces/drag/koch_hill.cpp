// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/koch_hill.hpp"

#include <cmath>

namespace interphase {
namespace {

double creeping_dilute(double phi)
{
    const double logarithmic = phi > 0.0 ? 135.0 / 64.0 * phi * std::log(phi) : 0.0;
    return (1.0 + 3.0 * std::sqrt(0.5 * phi) + logarithmic + 17.14 * phi) /
           (1.0 + phi * (0.681 + phi * (-8.48 + phi * 8.16)));
}

double creeping_dense(double phi, double eps) { return 10.0 * phi / (eps * eps * eps); }

double creeping(double phi, double eps)
{
    constexpr double dense_from = 0.4;
    if (phi >= dense_from) {
        return creeping_dense(phi, eps);
    }
    const double dense_weight = phi > 0.0 ? std::exp(-10.0 * (dense_from - phi) / phi) : 0.0;
    return (1.0 - dense_weight) * creeping_dilute(phi) + dense_weight * creeping_dense(phi, eps);
}

}  // namespace

double koch_hill(const DragState& state)
{
    const double eps = state.voidage;
    const double phi = solid_fraction(state);
    const double inertial = 0.0673 + 0.212 * phi + 0.0232 * std::pow(eps, -5.0);
    const double radius_reynolds = 0.5 * state.reynolds;
    return eps * (creeping(phi, eps) + inertial * radius_reynolds);
}

}  // namespace interphase
