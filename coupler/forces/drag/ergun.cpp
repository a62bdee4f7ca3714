// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/ergun.hpp"

namespace interphase {

double ergun(const DragState& state)
{
    return (150.0 * solid_fraction(state) + 1.75 * state.reynolds) / (18.0 * state.voidage * state.voidage);
}

}  // namespace interphase
