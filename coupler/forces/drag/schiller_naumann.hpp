// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/drag/drag_state.hpp"

namespace interphase {

/// C_D Re / 24 of an isolated sphere, its drag over Stokes drag: 1 + 0.15 Re^0.687 below Re = 1000, C_D = 0.44 from
/// there on (a jump of +0.35 % in drag, kept as published). `reynolds` is of the sphere's diameter and its slip.
///
/// Source: L. Schiller, A. Naumann, Über die grundlegenden Berechnungen bei der Schwerkraftaufbereitung, Z. Ver.
/// Dtsch. Ing. 77 (1933) 318-320. Within 5 % of the standard drag curve below Re = 800 (R. Clift, J. R. Grace, M.
/// E. Weber, Bubbles, Drops, and Particles, Academic Press (1978), table 5.1); the constant is Newton's regime, up
/// to the drag crisis near Re = 2e5.
double schiller_naumann_over_stokes(double reynolds);

/// Drag factor of a sphere that feels no neighbours. The force on the particle does not depend on voidage at a
/// given slip: with Re_p = Re / eps (no voidage in the isolated sphere's slip), 3 pi mu d eps F = 3 pi mu d (1 +
/// 0.15 Re_p^0.687).
///
/// Valid for isolated particles (voidage near 1), Re_p < 2e5.
double schiller_naumann(const DragState& state);

}  // namespace interphase
