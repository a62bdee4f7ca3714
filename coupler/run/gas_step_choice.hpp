// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase {

/// What an adjusted gas step answers to. Times in s.
struct GasStepLimits {
    double last;             ///< the step before
    double solid_step;       ///< its smallest change
    double courant;          ///< largest Courant number in the step before; 0 where nothing moves
    double largest_courant;  ///< wanted
    double largest;          ///< step that is allowed, by the user and by what the coupling bears
};

/// The next gas step wanted [s]: such that the Courant number stays below its limit. It grows gently, by a fifth,
/// though by a whole solid step, or it never would; it shrinks at once.
double adjusted_gas_step(const GasStepLimits& limits);

}  // namespace interphase
