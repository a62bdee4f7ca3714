// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/wen_yu.hpp"

#include <cmath>

#include "forces/drag/schiller_naumann.hpp"

namespace interphase {

double wen_yu(const DragState& state)
{
    return schiller_naumann_over_stokes(state.reynolds) * std::pow(state.voidage, -3.65);
}

}  // namespace interphase
