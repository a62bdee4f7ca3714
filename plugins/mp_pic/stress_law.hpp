// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mp_pic/stress.hpp"

namespace interphase::mp_pic {

/// The stresses that fix mp_pic knows, as stress.hpp has them.

/// Harris and Crighton, J. Fluid Mech. 266 (1994) 243, as Snider, J. Comput. Phys. 170 (2001) 523, made it safe beyond
/// close packing; eq. 8 of the paper:
///     tau = P_s phi^xi / max(phi_cp - phi, alpha (1 - phi)),  alpha = 1e-7.
/// Published: P_s 1 to 100 Pa, xi 2 to 5 (Auzerais, Jackson and Russel, J. Fluid Mech. 195 (1988) 437).
struct HarrisCrighton {
    double pressure;       ///< P_s [Pa]
    double exponent;       ///< xi
    double close_packing;  ///< phi_cp
    static constexpr StressNumber numbers[] = {{"P_s", "Pa", above_zero, unbounded, 1, 100},
                                               {"xi", "", above_zero, unbounded, 2, 5}};

    /// [Pa] at a solid fraction of 0 to 1; at most that of phi = 1 - alpha, so that it is finite everywhere.
    double stress(double solid_fraction) const;
};

/// Lun, Savage, Jeffrey and Chepurniy, J. Fluid Mech. 140 (1984) 223, the kinetic and collisional pressure:
///     tau = rho_p phi Theta (1 + 2 (1 + e) phi g0)
/// with the radial distribution of Lun and Savage, Acta Mech. 63 (1986) 15, g0 = (1 - phi/phi_cp)^(-2.5 phi_cp), which
/// is kept finite beyond close packing: 1 - phi/phi_cp is at least alpha = 1e-7. Theta is given: no equation is solved
/// for it.
struct Lun {
    double density;        ///< of the particles [kg/m3]
    double temperature;    ///< granular, Theta [m2/s2]
    double restitution;    ///< e, 0 to 1
    double close_packing;  ///< phi_cp
    static constexpr StressNumber numbers[] = {{"density", "kg/m3", above_zero, unbounded},
                                               {"temperature", "m2/s2", above_zero, unbounded},
                                               {"restitution", "", 0, 1}};

    double stress(double solid_fraction) const;  ///< [Pa]
};

}  // namespace interphase::mp_pic
