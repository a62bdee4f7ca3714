// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/stability_watch.hpp"

#include <cmath>

#include "base/text.hpp"

namespace interphase {

namespace {

// How the step is adapted: a doubted one is halved, which at a limit of the time stepping changes a growth of 1.6 a step
// into decay, and has the window's time to show it; growing, it has three steps.
constexpr int patience_of_oscillation = Alternation::window;
constexpr int patience_of_growth = 3;
constexpr int long_calm = 100;
constexpr double shortened = 0.6;  // of the last step: what was seen before says nothing of this one

constexpr double at_rest = 1e-9;  // no motion below it is of interest [m/s]

std::string place(const StepState& state)
{
    return "\n  where:  the largest pressure gradient, " + text(state.highest_pressure_gradient) + " Pa/m, is at " +
           text(state.where) + "; the fastest particle, " + std::to_string(state.fastest_id) + ", has " +
           text(state.fastest) + " m/s at " + text(state.fastest_at);
}

std::string moment(const StepState& state, const std::string& how_long)
{
    return "\n  when:   t = " + text(state.time) + " s, " + how_long + " of " + text(state.duration) + " s";
}

bool finite(const StepState& state)
{
    return std::isfinite(state.kinetic_energy + state.mean_velocity.sum() + state.mean_pressure_gradient.sum() +
                         state.gas_speed);
}

std::string rounded(double value)
{
    return text(std::stod(std::to_string(value).substr(0, 32)) < 1e-6 ? value : value);
}

}  // namespace

Finding StabilityWatch::observe(const StepState& state)
{
    remember(state);
    const Trouble trouble = worst(state);
    adapt_step(state.duration, trouble);
    const std::string crossing = watch_crossing(state);

    Finding finding{trouble.stability, crossing};
    const bool sets_in = trouble.stability != Stability::calm && !in_doubt_;
    if (trouble.stability != Stability::calm) in_doubt_ = true;
    if (calm_steps_ >= long_calm) in_doubt_ = false;
    if (sets_in) ++counts_.episodes;
    if (sets_in || trouble.stability == Stability::hopeless)
        finding.message = trouble.what + place(state) + moment(state, trouble.when) + "\n  remedy: " + trouble.remedy;
    return finding;
}

void StabilityWatch::remember(const StepState& state)
{
    if (state.duration < shortened * duration_) {
        gradient_ = velocity_ = Watched();
        accelerating_ = 0;
    }
    if (state.mass != mass_) {  // who comes or goes changes the mean, and may do so in every other step
        velocity_ = Watched();
        accelerating_ = 0;
        speed_ = 0;
    }
    duration_ = state.duration;
    mass_ = state.mass;
    const double motion = std::max(state.gas_speed, state.mean_velocity.norm());
    usual_speed_ += (motion - usual_speed_) * (usual_speed_ > 0 ? 0.01 : 1);
    velocity_.series.add(state.mean_velocity);
    gradient_.series.add(state.mean_pressure_gradient);
}
