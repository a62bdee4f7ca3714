// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vector.hpp"

namespace interphase {

/// How the gas acts on one tracked particle over the coming step, summed over all interphase terms: with u the gas
/// velocity (that of the step's end, u' that of its start) and F_c what contacts do,
///
///     (m + added_mass) dv/dt = rate (u - v) - pressed_volume grad p + force + gas_mass (u - u')/dt + m g + F_c.
///
/// The step hands all of it to the gas with the opposite sign, so a term cannot open the books of momentum.
struct Response {
    double rate = 0;                ///< k of drag [kg/s]
    double pressed_volume = 0;      ///< [m3]
    double added_mass = 0;          ///< of gas that moves with it [kg]
    double gas_mass = 0;            ///< of gas whose own acceleration pushes the particle [kg]
    Vector force = Vector::Zero();  ///< known before the gas is solved [N]
};

}  // namespace interphase
