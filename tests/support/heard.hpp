// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the stability watch says of a series of gas steps.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "step/stability_watch.hpp"

namespace interphase::test {

constexpr double g = 9.81;        // [m/s2]
constexpr double weight = 1.0e4;  // the pressure gradient that carries the solids [Pa/m]

/// A bed that is carried, at rest, in gas of 1 m/s.
inline StepState bed(int step, double dt)
{
    StepState state;
    state.time = (step + 1) * dt;
    state.duration = dt;
    state.mass = 1 + 1e-14 * (step % 3);  // summed in another order
    state.mean_pressure_gradient.z() = -weight;
    state.weight_gradient = weight;
    state.gas_speed = 1;
    return state;
}

/// What the watch says of a series.
struct Heard {
    std::vector<Finding> findings;
    std::vector<std::string> messages;
    StabilityCounts counts;

    /// Number of the first step judged as bad as that, from 1 on; 0 if none is.
    int first(Stability stability) const
    {
        for (std::size_t i = 0; i < findings.size(); ++i)
            if (findings[i].stability >= stability) return static_cast<int>(i) + 1;
        return 0;
    }
    bool silent() const { return messages.empty() && first(Stability::doubtful) == 0; }
};

inline Heard hear(const std::vector<StepState>& states, double gravity = g)
{
    StabilityWatch watch(gravity);
    Heard heard;
    for (const StepState& state : states) {
        heard.findings.push_back(watch.observe(state));
        if (!heard.findings.back().message().empty()) heard.messages.push_back(heard.findings.back().message());
    }
    heard.counts = watch.counts();
    return heard;
}

using Series = std::function<double(int step)>;

/// The pressure gradient of a bed, over the one that carries it.
inline Heard hear_gradient(int steps, const Series& series, double dt = 1e-3)
{
    std::vector<StepState> states;
    for (int i = 0; i < steps; ++i) {
        states.push_back(bed(i, dt));
        states.back().mean_pressure_gradient.z() = -weight * series(i);
    }
    return hear(states);
}

/// The particles' velocity, all of them alike [m/s].
inline Heard hear_velocity(int steps, const Series& series, double dt = 1e-3, double gravity = g)
{
    std::vector<StepState> states;
    for (int i = 0; i < steps; ++i) {
        states.push_back(bed(i, dt));
        const double v = series(i);
        states.back().mean_velocity.z() = v;
        states.back().kinetic_energy = 0.5 * v * v;
        states.back().fastest = std::abs(v);
    }
    return hear(states, gravity);
}

/// +1, -1, +1, ...
inline double sign(int step) { return step % 2 == 0 ? 1 : -1; }

}  // namespace interphase::test
