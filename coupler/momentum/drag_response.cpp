// SPDX-License-Identifier: GPL-3.0-or-later
#include "momentum/drag_response.hpp"

#include <algorithm>
#include <cmath>

namespace interphase {

namespace {

/// Below it the series are used: they avoid the cancellation, and the exponential where it hardly matters.
constexpr double small = 0.01;

}  // namespace

Shares shares(double x)
{
    // x/2 - x^2/6 + x^3/24 - ...; the first term left out is below 1e-16 of the sum
    constexpr double third = 1.0 / 3, fifth = 1.0 / 5, sixth = 1.0 / 6, seventh = 1.0 / 7;
    if (x < small) {
        const double withheld =
            0.5 * x * (1 - third * x * (1 - 0.25 * x * (1 - fifth * x * (1 - sixth * x * (1 - seventh * x)))));
        return {1.0 - withheld, withheld};
    }
    const double relaxed = -std::expm1(-x) / x;
    return {relaxed, 1.0 - relaxed};
}

double relaxed_share(double x) { return shares(x).relaxed; }

double withheld_share(double x) { return shares(x).withheld; }

Shares answered(double mass, double added_mass, double drag_rate, double dt)
{
    const double inertia = mass + added_mass;
    return answered(mass, added_mass, shares(drag_rate * dt / inertia));
}

AssumedDrag assume_drag(double mass, double drag_rate, double held, const Vector& acceleration, double dt,
                        double added_mass)
{
    return assume_drag(mass, drag_rate, held, acceleration, dt, answered(mass, added_mass, drag_rate, dt));
}

double response_time(double mass, double drag_rate, double dt, double added_mass)
{
    return dt * answered(mass, added_mass, drag_rate, dt).relaxed;
}

Vector free_change(double mass, double drag_rate, const Vector& slip, const Vector& acceleration, double response_time)
{
    return response_time * (drag_rate / mass * slip + acceleration);
}

void Hold::judge(const Vector& by_contacts, const Vector& without_contacts, double weight)
{
    const double expected = without_contacts.norm();
    if (expected <= 0) {
        *this = Hold{1.0, 0.0, steps};
        return;
    }
    constexpr double balanced = 0.02, telling = 0.1;               // shares of the weight
    constexpr double still = 1e-3, untouched = 0.1, pushed = 0.3;  // shares of what is expected
    const auto rise = [](double x, double from, double to) { return std::clamp((x - from) / (to - from), 0.0, 1.0); };
    const double known = weight > 0 ? rise(expected / weight, balanced, telling) : 1.0;
    const bool rests = (by_contacts + without_contacts).norm() <= still * std::max(expected, telling * weight);
    if (!rests)
        steps = 0;
    else if (known >= 1)  // in balance it may be free as well, and what was believed before stays
        steps = steps < 0 ? enough : std::min(steps + 1, enough);  // the first sight counts at once
    steps = std::max(steps, 0L);
    held = static_cast<double>(steps) / enough;
    doubt = (1.0 - held) * (1.0 - known * (1.0 - rise(by_contacts.norm() / expected, untouched, pushed)));
}

double stiffening(double drag_rate, double mass, double doubt, double dt, double added_mass)
{
    return doubt > 0 ? 0.5 * doubt * drag_rate * answered(mass, added_mass, drag_rate, dt).withheld : 0.0;
}

}  // namespace interphase
