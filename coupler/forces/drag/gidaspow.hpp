// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/drag/drag_state.hpp"

namespace interphase {

/// Drag factor of Gidaspow: Ergun's law below a voidage of 0.8, Wen and Yu's from there on.
///
/// Source: D. Gidaspow, Multiphase Flow and Fluidization: Continuum and Kinetic Theory Descriptions, Academic Press
/// (1994); J. Ding, D. Gidaspow, AIChE J. 36 (1990) 523.
///
/// The two laws do not meet at 0.8; the jump is kept as published. Going to the denser side the drag rises by 15 %
/// at Re = 0, 2.5 % at Re = 5, 73 % at Re = 100, and to 3.7 times at Re = 1000.
///
/// Valid where its parts are: 0.35 <= eps <= 1, Re up to about 1500 on the dense side.
double gidaspow(const DragState& state);

}  // namespace interphase
