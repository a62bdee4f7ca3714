// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "base/vector.hpp"
#include "exchange/cell_locator.hpp"

namespace interphase {

/// What the coupler keeps of each particle between gas steps, beside the FluidForce. The particle engine carries both
/// along when particles change rank or place, as plain bytes; a new particle starts with the defaults.
struct ParticleCoupling {
    CellAddress owner_cell;                 ///< gas cell that held the centre
    CellAddress home;                       ///< rank that brought it to the gas last, and its number there
    double assumed_impulse[3] = {0, 0, 0};  ///< of drag and pressure, by the gas solve [kg m/s]

    // only what tells how far contacts held it in the last gas step, hence single precision
    float start_velocity[3] = {0, 0, 0};  ///< with which it began the gas step [m/s]
    float free_change[3] = {0, 0, 0};     ///< velocity change it would see without contacts [m/s]
    bool was_outside = false;             ///< it has moved without gas since
    unsigned char unused[3] = {0, 0, 0};  ///< a gap would hold what memory held, and two checkpoints would differ
    float response_time = 0;  ///< by which a constant acceleration changes its velocity; 0: nothing is known of it [s]
};

static_assert(std::is_trivially_copyable_v<ParticleCoupling>);
static_assert(sizeof(ParticleCoupling) == 2 * sizeof(CellAddress) + 3 * sizeof(double) + 8 * sizeof(float), "no gap");

}  // namespace interphase
