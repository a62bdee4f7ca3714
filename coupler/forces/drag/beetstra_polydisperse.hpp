// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/drag/drag_state.hpp"

namespace interphase {

/// Drag factor of Beetstra, van der Hoef and Kuipers for spheres of several sizes: with y = d/<d>, <d> the Sauter mean
/// diameter around, and F that of spheres of one size (beetstra.hpp) at Re of <d>,
///     F_i = (y + 0.064 y^3) F(eps, Re <d>/d).
///
/// Source: R. Beetstra, M. A. van der Hoef, J. A. M. Kuipers, AIChE J. 53 (2007) 489, and, for Re = 0, J. Fluid Mech.
/// 528 (2005) 233, where the whole force is (eps y + (1 - eps) y^2 + 0.064 eps y^3) F/eps: without the pressure
/// gradient's share, (1 - eps) y^2 F/eps of it, that is the above.
///
/// Valid for 0.1 <= 1 - eps <= 0.6, Re <= 1000; backed by mixtures of two sizes up to a ratio of 4. With y = 1 it is
/// 6.4 % above the drag of spheres of one size: the fit's price for larger ratios.
double beetstra_polydisperse(const DragState& state);

}  // namespace interphase
