// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/drag/drag_state.hpp"

namespace interphase {

/// Drag factor of Hill, Koch and Ladd ("Koch-Hill").
///
/// Source: R. J. Hill, D. L. Koch, A. J. C. Ladd, J. Fluid Mech. 448 (2001) 213-241 (small Re) and 243-278
/// (moderate Re), as collected by D. L. Koch, R. J. Hill, Annu. Rev. Fluid Mech. 33 (2001) 619-647:
/// lattice-Boltzmann simulations of random arrays. The whole force is F_t = F_0(phi) + F_3(phi) Re_a, phi = 1 - eps,
/// F_0 a quotient of polynomials below phi = 0.4 and Carman and Kozeny's form from there on. The quotient is led over
/// into the dense form with the weight of S. Benyahia, M. Syamlal, T. J. O'Brien, Powder Technol. 162 (2006) 166;
/// without it, drag would drop by 3.8 % at phi = 0.4.
///
/// Definitions: F_t is the whole force over 6 pi mu a U (a radius, U superficial), so F = eps F_t. Re_a is of the
/// radius and U, so Re_a = Re / 2.
///
/// Coefficients on which texts and codes disagree:
/// - 0.212, also seen as 0.0212. For phi < 0.0953 Benyahia et al. give F_3 = 0.03667 + 0.9351 phi = 0.1258 at that
///   point; the formula above gives 0.1258 with 0.212, and 0.1076 with 0.0212.
/// - 17.14, also seen as 16.14. Expanded in phi, the quotient has 17.14 - 0.681 = 16.459 before phi; the exact
///   expansion (S. Kim, W. B. Russel, J. Fluid Mech. 154 (1985) 269) has 16.456. With 16.14, F at Re = 0 is lower
///   by up to 4.5 % (near phi = 0.25).
///
/// Valid for phi from about 0.1 to 0.64 and Re up to about 200. F_3 is used at every phi and down to Re = 0, as
/// simulations of fluidised beds do. (For Re_a below 1 to 3 the paper has inertia growing as Re_a^2; it is a few
/// per cent of F there.) As phi -> 0, F -> 1 + 0.045 Re: Stokes drag, then 18 % below the standard drag curve at Re
/// = 10, 22 % above it at Re = 100 and out of reach beyond.
double koch_hill(const DragState& state);

}  // namespace interphase
