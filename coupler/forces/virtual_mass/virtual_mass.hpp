// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/term.hpp"

namespace interphase {

/// Inertia of the gas that a sphere pushes aside: F = C rho V_p (Du/Dt - dv/dt), C = 1/2, for spheres far from each
/// other (Auton, Hunt, Prud'homme, J. Fluid Mech. 197 (1988) 241). Both accelerations are implicit in the step: dv/dt
/// is an added mass, du/dt the change of the gas velocity over the step; u.grad u is of its start.
class VirtualMass : public Term {
public:
    static constexpr double coefficient = 0.5;

    Needs needs() const override
    {
        Needs needs;
        needs.velocity_gradient = needs.added_mass = true;
        return needs;
    }

    void act(const ParticleInGas& at, Response& response) override
    {
        const double displaced = coefficient * at.density * at.volume;
        response.added_mass += displaced;
        response.gas_mass += displaced;
        response.force += displaced * (at.velocity_gradient.transpose() * at.gas_velocity);
    }
};

}  // namespace interphase
