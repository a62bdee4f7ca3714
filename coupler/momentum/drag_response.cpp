// SPDX-License-Identifier: GPL-3.0-or-later
#include "momentum/drag_response.hpp"

#include <algorithm>
#include <cmath>

namespace interphase {

namespace {

/// Below it the series are used: they avoid the cancellation, and the exponential where it hardly matters.
constexpr double small = 0.01;

}  // namespace

double relaxed_share(double x) { return x < small ? 1.0 - withheld_share(x) : -std::expm1(-x) / x; }

double withheld_share(double x)
{
    // x/2 - x^2/6 + x^3/24 - ...; the first term left out is below 1e-16 of the sum
    constexpr double third = 1.0 / 3, fifth = 1.0 / 5, sixth = 1.0 / 6, seventh = 1.0 / 7;
    if (x < small)
        return 0.5 * x * (1 - third * x * (1 - 0.25 * x * (1 - fifth * x * (1 - sixth * x * (1 - seventh * x)))));
    return 1.0 - relaxed_share(x);
}

AssumedDrag assume_drag(double mass, double drag_rate, double held, const Vector& acceleration, double dt)
{
    const double x = drag_rate * dt / mass;
    const double withheld = withheld_share(x);
    return {drag_rate * (relaxed_share(x) + held * withheld), (1.0 - held) * mass * dt * withheld * acceleration};
}

Vector free_change(double mass, double drag_rate, const Vector& slip, const Vector& acceleration, double dt)
{
    const double x = drag_rate * dt / mass;
    return relaxed_share(x) * dt * (drag_rate / mass * slip + acceleration);
}

double held_by_contacts(const Vector& change, const Vector& free_change)
{
    const double expected = free_change.squaredNorm();
    // m2/s2: a new particle, or one in balance. What it does is not known, and taking a free particle for held is the
    // safe mistake: the gas then gives too little, once; the other way round it would be pushed back by dt k / m times
    // too much.
    if (expected < 1e-24) return 1.0;
    return 1.0 - std::clamp(change.dot(free_change) / expected, 0.0, 1.0);
}

}  // namespace interphase
