// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace interphase {

/// What a drag law looks at.
struct DragState {
    /// Gas volume fraction eps around the particle [-], above 0, at most 1.
    double voidage = 1;
    /// Re = eps rho |u_g - v| d / mu [-], at least 0: of the superficial slip and the real particle's diameter.
    double reynolds = 0;
    /// d/<d> [-], <d> the Sauter mean diameter around; known to laws that look at the mean diameter.
    double diameter_ratio = 1;
    /// Size of the gas cell over the cluster length [-] (cluster_length.hpp); known to laws that look at the cell size.
    double filter_size = 0;
};

/// 1 - voidage, kept from turning negative where a voidage summed over particles exceeds 1 by round-off.
inline double solid_fraction(const DragState& state) { return std::max(1.0 - state.voidage, 0.0); }

}  // namespace interphase
