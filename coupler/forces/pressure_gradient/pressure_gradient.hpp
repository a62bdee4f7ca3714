// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/term.hpp"

namespace interphase {

/// The full pressure's gradient acts on the particle's volume, buoyancy included: F = -V_p grad p.
class PressureGradient : public Term {
public:
    void act(const ParticleInGas& at, Response& response) override { response.pressed_volume += at.volume; }
};

}  // namespace interphase
