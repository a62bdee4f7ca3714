// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/drag/drag_state.hpp"

namespace interphase {

/// Drag factor of Wen and Yu.
///
/// Source: C. Y. Wen, Y. H. Yu, Mechanics of fluidization, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100-111, in the
/// form of D. Gidaspow, Multiphase Flow and Fluidization, Academic Press (1994): beta = 3/4 C_D eps (1 - eps) rho
/// |u_g - v| / d eps^-2.65, C_D of Schiller and Naumann at the superficial Re.
///
/// Definitions: Wen and Yu compare a fluidised particle's weight with an isolated sphere's drag at the same
/// superficial velocity; the ratio is eps^-4.7, and includes the pressure gradient's share. Without it that would
/// be F = eps^-3.7 C_D Re / 24; the form in use, and here, has eps^-3.65, which is Richardson and Zaki's exponent
/// 4.65 for slow settling.
///
/// Valid for fluidised beds, 0.4 <= eps <= 1 (best above 0.8), up to the drag crisis near Re = 2e5.
double wen_yu(const DragState& state);

}  // namespace interphase
