// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/drag/drag_state.hpp"

namespace interphase {

/// Drag factor of Syamlal and O'Brien.
///
/// Source: M. Syamlal, T. J. O'Brien, Computer simulation of bubbles in a fluidized bed, AIChE Symp. Ser. 85 (1989)
/// 22-31, and Derivation of a drag coefficient from velocity-voidage correlation, US DOE METC (1987); equations as
/// in M. Syamlal, W. Rogers, T. J. O'Brien, MFIX documentation: Theory guide, DOE/METC-94/1004 (1993). A suspension
/// settles V_r times as fast (slip between the phases) as an isolated sphere with Dalla Valle's drag; V_r is of
/// J. Garside, M. R. Al-Dibouni, Ind. Eng. Chem. Process Des. Dev. 16 (1977) 206, whose high-Re limit is piecewise in
/// voidage with a step of 0.05 % at 0.85, kept as published.
///
/// Definitions: the paper's Re_p = rho |u_g - v| d / mu is made of the slip between the phases, Re_p = Re / eps.
/// The formula is the one with the pressure gradient shared by both phases, so F = C_D(Re_p / V_r) Re_p / (24
/// V_r^2).
///
/// Valid for 0.4 <= eps <= 1, Re up to about 3e4, with the published constants (0.8 and 2.65: users of the law
/// refit them to a measured minimum fluidisation velocity; we do not). F = 0.96 at voidage 1 and Re = 0 (Dalla
/// Valle's). As published, F of dense beds falls where V_r grows with Re, by 30 % up to Re = 1 at voidage 0.5 and
/// by 61 % at 0.4; the force, Re F, always grows.
double syamlal_obrien(const DragState& state);

}  // namespace interphase
