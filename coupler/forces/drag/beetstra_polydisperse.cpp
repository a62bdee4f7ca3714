// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/beetstra_polydisperse.hpp"

#include "forces/drag/beetstra.hpp"

namespace interphase {

double beetstra_polydisperse(const DragState& state)
{
    const double y = state.diameter_ratio;
    DragState of_mean = state;
    of_mean.reynolds /= y;
    return (y + 0.064 * y * y * y) * beetstra(of_mean);
}

}  // namespace interphase
