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
    const double following = (1.0 - held) * withheld;
    return {drag_rate * (relaxed_share(x) + held * withheld), following * mass * dt * acceleration, following};
}

Vector free_change(double mass, double drag_rate, const Vector& slip, const Vector& acceleration, double dt)
{
    const double x = drag_rate * dt / mass;
    return relaxed_share(x) * dt * (drag_rate / mass * slip + acceleration);
}

Hold hold_of_contacts(const Vector& by_contacts, const Vector& without_contacts, double weight)
{
    const double expected = without_contacts.norm();
    if (expected <= 0) return {1.0, 0.0};
    // shares of the weight: in a steady suspension the forces on a cell's solids differ from balance by less than the first
    constexpr double balanced = 0.02, telling = 0.1;
    const double known =
        weight > 0 ? std::clamp((expected / weight - balanced) / (telling - balanced), 0.0, 1.0) : 1.0;
    const double seen = std::clamp(-by_contacts.dot(without_contacts) / (expected * expected), 0.0, 1.0);
    return {known * seen, 1.0 - known};
}

double stiffening(double drag_rate, double mass, double doubt, double dt)
{
    return doubt > 0 ? 0.5 * doubt * drag_rate * withheld_share(drag_rate * dt / mass) : 0.0;
}

}  // namespace interphase
