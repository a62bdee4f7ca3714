// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/syamlal_obrien.hpp"

#include <cmath>

#include "forces/drag/dalla_valle.hpp"

namespace interphase {
namespace {

/// Settling velocity of the suspension over that of an isolated sphere, both as slip (the positive root V_r).
double settling_ratio(double voidage, double particle_reynolds)
{
    const double slow = std::pow(voidage, 4.14);
    const double fast = voidage <= 0.85 ? 0.8 * std::pow(voidage, 1.28) : std::pow(voidage, 2.65);
    const double x = 0.06 * particle_reynolds;
    const double root = std::sqrt((x - slow) * (x - slow) + 4.0 * x * fast);
    // Two forms of one root, each free of cancellation on its side.
    return x < slow ? 0.5 * (slow - x + root) : 2.0 * x * fast / (x - slow + root);
}

}  // namespace

double syamlal_obrien(const DragState& state)
{
    const double particle_reynolds = state.reynolds / state.voidage;
    const double ratio = settling_ratio(state.voidage, particle_reynolds);
    return dalla_valle_over_stokes(particle_reynolds / ratio) / ratio;
}

}  // namespace interphase
