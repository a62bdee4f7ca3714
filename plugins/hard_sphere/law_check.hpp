// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>

#include "base/text.hpp"
#include "hard_sphere/law_functions.hpp"

namespace interphase::hard_sphere {

/// Asks a law for all that it may be asked for: approaches from 0 to 1 km/s, the effective masses and radii of spheres
/// of these sizes, as light as foam and as heavy as platinum, gaps up to the range. Returns what is wrong first, or
/// nothing. `materials`: of two types.
template <class Law>
std::string complaint_of(const typename Law::template Materials<double>& materials, const Sizes& sizes)
{
    using F = LawFunctions<Law>;
    constexpr double light = 10, heavy = 22e3, third = 4 * 3.14159265358979 / 3;  // [kg/m3]
    for (const double radius : {0.5 * sizes.smallest, sizes.largest})
        for (const double mass :
             {0.5 * light * third * std::pow(sizes.smallest, 3), heavy * third * std::pow(sizes.largest, 3)})
            for (double exponent = -7; exponent <= 3; exponent += 0.25) {
                const Meeting<double> meeting{exponent < -6 ? 0 : std::pow(10, exponent), mass, radius};
                const auto state = F::next({}, materials, meeting, 1e-4);
                const auto beyond = [&](const char* name, double value, double most) -> std::string {
                    if (value >= 0 && value <= most) return "";
                    return std::string(name) + " of " + text(value) + " at an approach of " + text(meeting.speed) +
                           " m/s, an effective mass of " + text(mass) + " kg and radius of " + text(radius) +
                           " m; it must be a number from 0 " + (most > 1 ? "on" : "to 1");
                };
                for (const std::string& found :
                     {beyond("restitution", F::restitution(materials, meeting, state), 1),
                      beyond("tangential_restitution", F::tangential_restitution(materials, meeting, state), 1),
                      beyond("friction", F::friction(materials, meeting, state), 1e30),
                      beyond("rolling_friction", F::rolling_friction(materials, meeting, state), 1e30)})
                    if (!found.empty()) return found;
            }
    if constexpr (F::attracts) {
        const double range = F::range(materials);
        if (!(range >= 0 && range <= 2 * sizes.smallest))
            return "range of " + text(range) + " m; it must be a number from 0 to the smallest diameter, " +
                   text(2 * sizes.smallest) + " m";
        for (const double radius : {0.5 * sizes.smallest, sizes.largest})
            for (int part = 0; part <= 20; ++part) {
                const double gap = part * range / 20, force = F::attraction(materials, {gap, radius});
                if (!std::isfinite(force))
                    return "attraction of " + text(force) + " N at a gap of " + text(gap) +
                           " m and an effective radius of " + text(radius) + " m; it must be a number";
                if (range == 0 && force != 0)
                    return "attraction of " + text(force) + " N, but a range of 0; say how far it reaches";
            }
    }
    return "";
}

}  // namespace interphase::hard_sphere
