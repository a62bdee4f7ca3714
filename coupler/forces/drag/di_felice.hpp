// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/drag/drag_state.hpp"

namespace interphase {

/// Drag factor of Di Felice.
///
/// Source: R. Di Felice, The voidage function for fluid-particle interaction systems, Int. J. Multiphase Flow 20
/// (1994) 153-159: an isolated sphere's drag (Dalla Valle) at the same superficial velocity, times eps^-chi, chi going
/// from 3.7 at small Re through a minimum near Re = 32 back to 3.7.
///
/// Definitions: Re is superficial. The drag leaves out the pressure gradient's share (buoyancy is counted with the
/// suspension's density), hence 3.7 = 4.7 - 1 at both ends.
///
/// Valid for 0.4 <= eps <= 1 and 0.01 < Re < 1e4; at Re = 0 the limit chi = 3.7 is taken, and F = 0.96 at voidage 1
/// (Dalla Valle's). As published, F falls by about 1 % from Re = 0.3 to 2 at voidage 0.4 (more in denser beds); the
/// force, Re F, always grows.
double di_felice(const DragState& state);

}  // namespace interphase
