// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/drag/drag_state.hpp"

namespace interphase {

/// Drag factor of Ergun's packed bed.
///
/// Source: S. Ergun, Fluid flow through packed columns, Chem. Eng. Prog. 48 (1952) 89-94: -dp/dx = 150 mu (1 -
/// eps)^2 U / (eps^3 d^2) + 1.75 rho (1 - eps) U^2 / (eps^3 d), U superficial.
///
/// Definitions: at rest, the gas balances eps (-dp/dx) = beta U / eps, so beta = 150 mu (1 - eps)^2 / (eps d^2) +
/// 1.75 rho (1 - eps) U / (eps d).
///
/// Valid for packed beds, voidage about 0.35 to 0.55, Re / (1 - eps) up to about 2500 (Re = 1500 at voidage 0.4).
/// It has no dilute limit: F = 0 at voidage 1 and Re = 0, and the viscous drag there is missing.
double ergun(const DragState& state);

}  // namespace interphase
