// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/drag/drag_state.hpp"

namespace interphase {

/// Drag factor for cells that do not resolve clusters: Beetstra's, times
///     c = 1 - h(phi) / (1 + a(phi) L/D),
/// D the size of the cell (cube root of its volume), L the cluster length (cluster_length.hpp). c -> 1 in fine cells.
///
/// Source: S. Radl, S. Sundaresan, A drag model for filtered Euler-Lagrange simulations of clustered gas-particle
/// suspensions, Chem. Eng. Sci. 117 (2014) 416: piecewise cubics a and h, from simulations of periodic suspensions of
/// fine particles (75 and 150 um, 1500 kg/m3, in air). Of tracked particles that are real ones: what parcels smooth
/// out besides is not in it.
double radl_sundaresan(const DragState& state);

/// c above.
double radl_sundaresan_correction(double solid_fraction, double filter_size);

}  // namespace interphase
