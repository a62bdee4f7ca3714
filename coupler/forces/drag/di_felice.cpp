// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/di_felice.hpp"

#include <cmath>

#include "forces/drag/dalla_valle.hpp"

namespace interphase {

double di_felice(const DragState& state)
{
    double exponent = 3.7;
    if (state.reynolds > 0.0) {
        const double decades = 1.5 - std::log10(state.reynolds);
        exponent -= 0.65 * std::exp(-0.5 * decades * decades);
    }
    return dalla_valle_over_stokes(state.reynolds) * std::pow(state.voidage, -exponent);
}

}  // namespace interphase
