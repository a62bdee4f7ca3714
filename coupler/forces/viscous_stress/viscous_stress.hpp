// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/term.hpp"

namespace interphase {

/// The gas's viscous stress acts on the particle's volume as its pressure does: F = V_p div tau, of the gas velocity
/// at the start of the step. Source: Z. Y. Zhou, S. B. Kuang, K. W. Chu, A. B. Yu, Discrete particle simulation of
/// particle-fluid flow: model formulations and their applicability, J. Fluid Mech. 661 (2010) 482, eq. 2.8b.
class ViscousStress : public Term {
public:
    Needs needs() const override
    {
        Needs needs;
        needs.viscous_force = true;
        return needs;
    }
    void act(const ParticleInGas& at, Response& response) override { response.force += at.volume * at.viscous_force; }
};

}  // namespace interphase
