// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hard_sphere/law.hpp"

namespace interphase::laws {

/// Viscoelastic spheres: a Hertzian contact with a dashpot in its material (Kuwabara and Kono, Jpn. J. Appl. Phys. 26
/// (1987) 1230; Brilliantov et al., Phys. Rev. E 53 (1996) 5382), force rho (xi^1.5 + 1.5 A xi^0.5 dxi/dt) on the
/// overlap xi, never below 0, rho = 4/3 E_e r_e^0.5. The restitution falls with the approach, from 1 at v = 0.
struct Viscoelastic {
    template <class D>
    struct Materials {
        D modulus;      ///< E_e of the pair, 1/E_e = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j [Pa]
        D dissipation;  ///< A [s]
        D tangential_restitution, friction;
    };
    static constexpr hard_sphere::MaterialProperty properties[] = {{"contactModulus", 1, 1e30},
                                                                   {"dissipativeTime", 0, 1e30},
                                                                   {"tangentialRestitution", 0, 1},
                                                                   {"coefficientFriction", 0, 1e30}};

    /// The Pade approximant of Mueller and Poeschel, Phys. Rev. E 84 (2011) 021302, in
    /// v* = (1.5 A)^0.5 (rho/m)^0.2 v^0.1. Off the solution of the equation of motion by less than 0.001 for e above
    /// 0.7 and by 0.008 at most.
    template <class D>
    static D restitution(const Materials<D>& materials, const hard_sphere::Meeting<D>& meeting)
    {
        using namespace hard_sphere;
        const D stiffness = 4.0 / 3 * materials.modulus * square_root(meeting.radius) / meeting.mass;
        const D v = square_root(D(1.5 * materials.dissipation * power(D(stiffness * stiffness * meeting.speed), 0.2)));
        return (1 + 0.501086 * v) / (1 + v * (0.501086 + v * (1.15345 + v * (0.577977 + v * 0.532178))));
    }
    template <class D>
    static D tangential_restitution(const Materials<D>& materials, const hard_sphere::Meeting<D>&)
    {
        return materials.tangential_restitution;
    }
    template <class D>
    static D friction(const Materials<D>& materials, const hard_sphere::Meeting<D>&)
    {
        return materials.friction;
    }
};

}  // namespace interphase::laws
