// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/schiller_naumann.hpp"

#include <cmath>

namespace interphase {

double schiller_naumann_over_stokes(double reynolds)
{
    return reynolds < 1000.0 ? 1.0 + 0.15 * std::pow(reynolds, 0.687) : 0.44 / 24.0 * reynolds;
}

double schiller_naumann(const DragState& state)
{
    return schiller_naumann_over_stokes(state.reynolds / state.voidage) / state.voidage;
}

}  // namespace interphase
