// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/drag/drag_state.hpp"

namespace interphase {

/// Drag factor of Beetstra, van der Hoef and Kuipers ("BVK").
///
/// Source: R. Beetstra, M. A. van der Hoef, J. A. M. Kuipers, Drag force of intermediate Reynolds number flow past
/// mono- and bidisperse arrays of spheres, AIChE J. 53 (2007) 489-501, the monodisperse fit; its limit at Re = 0 is
/// that of van der Hoef, Beetstra, Kuipers, J. Fluid Mech. 528 (2005) 233. A fit to lattice-Boltzmann simulations
/// of random arrays.
///
/// Definitions: the paper's drag force leaves out the pressure gradient's share, is made dimensionless by 3 pi mu d
/// U and uses Re = rho U d / mu, U superficial. All three are those of DragFactor; nothing is converted.
///
/// Valid for 0.1 <= 1 - eps <= 0.6 and Re <= 1000. For an isolated sphere it tends to Stokes drag at Re = 0, but
/// lies 8 % below the standard drag curve at Re = 10, 16 % above it at Re = 100 and 57 % at Re = 1000.
double beetstra(const DragState& state);

}  // namespace interphase
