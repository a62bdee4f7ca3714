// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/cluster_length.hpp"

#include <cmath>
#include <limits>

#include "forces/drag/schiller_naumann.hpp"

namespace interphase {

double terminal_velocity(double diameter, double density, double gas_density, double gas_viscosity, double gravity)
{
    const double stokes = std::abs(density - gas_density) * gravity * diameter * diameter / (18 * gas_viscosity);
    // v F(Re(v)) = v_Stokes. v^(1.687) at most: damped by that power the iteration converges from any side.
    constexpr int most_tries = 60;
    constexpr double close_enough = 1e-10, power = 1.687;
    double v = stokes;
    for (int n = 0; n < most_tries && v > 0; ++n) {
        DragState alone;
        alone.reynolds = gas_density * v * diameter / gas_viscosity;
        const double ratio = stokes / (v * schiller_naumann(alone));
        v *= std::pow(ratio, 1 / power);
        if (std::abs(ratio - 1) < close_enough) break;
    }
    return v;
}

double cluster_length(double diameter, double density, double gas_density, double gas_viscosity, double gravity)
{
    const double v = terminal_velocity(diameter, density, gas_density, gas_viscosity, gravity);
    if (!(v > 0)) return std::numeric_limits<double>::infinity();
    const double froude = v * v / (gravity * diameter);
    return v * v / gravity * std::pow(froude, -2.0 / 3);
}

}  // namespace interphase
