// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase {

/// C_D Re / 24 of an isolated sphere with C_D = (0.63 + 4.8 Re^-0.5)^2, its drag over Stokes drag; `reynolds` is of
/// the sphere's diameter and its slip. Tends to 0.96 at Re = 0, not 1.
///
/// Source: J. M. Dalla Valle, Micromeritics, 2nd ed., Pitman (1948). Above the standard drag curve by 8 % at Re = 1
/// to 10, 13 % at Re = 100 and 30 % at Re = 1000. A part of the laws of Di Felice and of Syamlal and O'Brien.
double dalla_valle_over_stokes(double reynolds);

}  // namespace interphase
