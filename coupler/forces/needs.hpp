// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase {

/// What an interphase term looks at, or answers with, beyond what every one does. It is computed, mapped and sent only
/// where some term asks for it.
struct Needs {
    bool velocity_gradient = false;  ///< of the gas
    bool viscous_force = false;      ///< div tau of the gas
    bool mean_diameter = false;      ///< of the particles around
    bool added_mass = false;         ///< the response has one

    Needs& operator|=(const Needs& other)
    {
        velocity_gradient |= other.velocity_gradient;
        viscous_force |= other.viscous_force;
        mean_diameter |= other.mean_diameter;
        added_mass |= other.added_mass;
        return *this;
    }
};

}  // namespace interphase
