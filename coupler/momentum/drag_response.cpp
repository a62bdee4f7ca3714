// SPDX-License-Identifier: GPL-3.0-or-later
#include "momentum/drag_response.hpp"

#include <algorithm>
#include <cmath>

namespace interphase {

double relaxed_share(double x)
{
    // the series avoids 0/0; its error at the switch is x^2/6 < 2e-17
    return x < 1e-8 ? 1.0 - 0.5 * x : -std::expm1(-x) / x;
}

double withheld_share(double x)
{
    // the fourth term of the series is below 1e-16 relative at the switch
    return x < 1e-4 ? x * (0.5 - x * (1.0 / 6.0 - x / 24.0)) : 1.0 - relaxed_share(x);
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
