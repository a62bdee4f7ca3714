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
    if (x < small) return x / 2 * (1 - x / 3 * (1 - x / 4 * (1 - x / 5 * (1 - x / 6 * (1 - x / 7)))));
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
    if (expected < 1e-24) return 0.0;  // m2/s2: a particle in balance, nothing to hold
    return 1.0 - std::clamp(change.dot(free_change) / expected, 0.0, 1.0);
}

}  // namespace interphase
