// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "base/vector.hpp"

namespace interphase {

/// Below this gas step over relaxation time the drag rate of the slip at the step's start serves for the whole step:
/// half a step then changes the slip by less than a twentieth of what it is off balance, and a settling particle not at
/// all.
constexpr double short_step = 0.1;

/// The drag rate k [kg/s] that a step of `dt` [s] takes for constant, of a rate that depends on the slip: that of the
/// slip half way through. Slip u - v relaxes as d(u - v)/dt = -(k/m)(u - v) - a, so that is an equation for k; long
/// steps see the slip of balance, and do not jump between the rates of too small and too large a slip. Second order in
/// dt.
/// @param rate_of       k [kg/s] of a slip speed [m/s]
/// @param slip          at the start [m/s]
/// @param acceleration  gives a, by other forces than drag, as far as they are free to act [m/s2]; short steps do not
/// ask
template <class Rate, class Acceleration>
double rate_over_step(const Rate& rate_of, const Vector& slip, double mass, const Acceleration& acceleration, double dt)
{
    double k = rate_of(slip.norm());
    if (!(k * dt / mass > short_step)) return k;
    const Vector a = acceleration();
    constexpr int most_tries = 6;
    constexpr double close_enough = 1e-3;
    for (int n = 0; n < most_tries; ++n) {
        const double gone = -std::expm1(-0.5 * k * dt / mass);
        const Vector balance = -mass / k * a;
        const double next = rate_of((slip + gone * (balance - slip)).norm());
        // Where the slip is that of balance, next falls with a power p <= 1 of k: taken in full it would swing about
        // the answer. p is about 0.6 where that matters.
        constexpr double power = 0.6;
        const double ratio = next / k;
        k *= std::pow(ratio, 1 / (1 + power * gone));
        if (std::abs(ratio - 1) < close_enough) break;
    }
    return k;
}

}  // namespace interphase
