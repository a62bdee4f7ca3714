// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase {

/// The solids of a gas cell: sum_i w_ic V_i and sum_i w_ic V_i v_i over the particles i, with the mapping's weights.
struct CellSolids {
    double volume;   ///< [m3]
    double flow[3];  ///< volume times velocity [m4/s]
};

}  // namespace interphase
