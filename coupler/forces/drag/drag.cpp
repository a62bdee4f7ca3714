// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/drag.hpp"

#include <cmath>

#include "forces/drag/rate_over_step.hpp"
#include "forces/self_disturbance/self_disturbance.hpp"

namespace interphase {

Needs Drag::needs() const
{
    Needs needs;
    needs.mean_diameter = law_.looks_at == DragLooksAt::mean_diameter;
    return needs;
}

DragState Drag::asked_for(const ParticleInGas& at) const
{
    DragState state;
    switch (law_.looks_at) {
        case DragLooksAt::flow:
            break;
        case DragLooksAt::mean_diameter:
            state.diameter_ratio = at.diameter / at.mean_diameter;
            break;
        case DragLooksAt::cell_size:
            state.filter_size =
                std::cbrt(at.cell_volume) /
                cluster_length_(at.diameter, at.mass / at.volume, at.density, at.viscosity, at.gravity.norm());
            break;
    }
    return state;
}

double Drag::rate_at(const ParticleInGas& at, double voidage, double slip_speed) const
{
    return at.volume *
           drag_rate_per_volume(law_, voidage, slip_speed, at.diameter, at.density, at.viscosity, asked_for(at));
}

double Drag::departure(const DragState& state) const
{
    for (const DragLaw* other : {wen_yu_, ergun_})
        if (other->holds_at(state.voidage, state.reynolds))
            return std::abs(law_.factor(state) / other->factor(state) - 1);
    return 1;
}

void Drag::act(const ParticleInGas& at, Response& response)
{
    const Vector slip = at.slip();
    const SelfDisturbance own(at);
    const double eps = own.voidage();
    const double reynolds = superficial_reynolds(eps, slip.norm(), at.diameter, at.density, at.viscosity);
    const DragState asked = asked_for(at);
    if (!law_.holds_at(eps, reynolds)) {
        ++beyond_range_;
        DragState state = asked;
        state.voidage = eps;
        state.reynolds = reynolds;
        departure_ += departure(state);
    }
    const auto of_undisturbed = [&](double speed) {
        return at.volume * drag_rate_per_volume(law_, eps, speed, at.diameter, at.density, at.viscosity, asked);
    };
    bool limited = false;
    const auto rate_of = [&](double seen_speed) {
        const SelfDisturbance::Rate rate = own.rate(of_undisturbed, seen_speed);
        limited |= rate.limited;
        return rate.of_seen;
    };
    const double inertia = at.mass + response.added_mass;
    const auto acceleration = [&] {
        const Vector by_pressure = response.pressed_volume / at.mass * at.pressure_gradient;
        const Vector all = at.gravity - by_pressure + response.force / at.mass;
        return Vector((1 - at.held) * (at.mass / inertia) * all);
    };
    response.rate += rate_over_step(rate_of, slip, inertia, acceleration, at.duration);
    limited_ += limited;
}

}  // namespace interphase
