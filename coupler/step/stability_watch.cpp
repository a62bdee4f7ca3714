// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/stability_watch.hpp"

#include <cmath>
#include <cstdio>

#include "base/text.hpp"

namespace interphase {

namespace {

// How the step is adapted. A doubted one is halved, which turns growth at a limit of the time stepping into decay, and
// gets a window's time to show it; where something grows from step to step, three steps.
constexpr int patience_with_oscillation = Alternation::window;
constexpr int patience_with_growth = 3;
constexpr int long_calm = 100;
constexpr double shortened = 0.6;  // of the last step: what was seen before says nothing of this one

constexpr double at_rest = 1e-9;  // no motion below it is of interest [m/s]

std::string about(double value)
{
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3g", value);
    return buffer;
}

std::string place(const StepState& state)
{
    return "the largest pressure gradient, " + about(state.highest_pressure_gradient) + " Pa/m, is at " +
           text(state.where) + "; the fastest particle, " + std::to_string(state.fastest_id) + ", has " +
           about(state.fastest) + " m/s at " + text(state.fastest_at);
}

std::string moment(const StepState& state, const std::string& how_long)
{
    return "t = " + text(state.time) + " s, " + how_long + " of " + text(state.duration) + " s";
}

std::string shorter_step(double limit)
{
    return "a gas step below " + about(limit) +
           " s (deltaT in system/controlDict), or `adjustTimeStep yes;` there, which lets it be shortened until it "
           "is calm";
}

std::optional<Problem> both(const std::optional<Problem>& first, const std::optional<Problem>& second)
{
    if (first && second) return followed_by(*first, *second);
    return first ? first : second;
}

bool finite(const StepState& state)
{
    return std::isfinite(state.kinetic_energy + state.mean_velocity.sum() + state.mean_pressure_gradient.sum() +
                         state.gas_speed);
}

}  // namespace

Finding StabilityWatch::observe(const StepState& state)
{
    remember(state);
    const Trouble trouble = worst(state);
    const bool sets_in = trouble.stability != Stability::calm && !in_doubt_;
    adapt_step(state.duration, trouble);

    Finding finding{trouble.stability, watch_crossing(state)};
    finding.problem = both(finding.problem, watch_waves(state));
    if (sets_in) ++counts_.episodes;
    if (sets_in || trouble.stability == Stability::hopeless)
        finding.problem =
            both(finding.problem, Problem{trouble.what, place(state),
                                          shorter_step(std::min(0.5 * state.duration, longest_calm_)) + trouble.remedy,
                                          moment(state, trouble.when)});
    return finding;
}

void StabilityWatch::remember(const StepState& state)
{
    // Who comes or goes changes the mean, maybe in every other step; a sum over other ranks differs by round-off.
    const bool others = std::abs(state.mass - mass_) > 1e-10 * mass_;
    if (state.duration < shortened * duration_) {
        gradient_ = Watched();
        told_of_this_step_ = false;
    }
    if (state.duration < shortened * duration_ || others) {
        velocity_ = Watched();
        accelerating_ = 0;
    }
    if (others) speed_ = 0;
    duration_ = state.duration;
    mass_ = state.mass;

    const double motion = std::max(state.gas_speed, state.mean_velocity.norm());
    usual_speed_ += (motion - usual_speed_) * (usual_speed_ > 0 ? 0.01 : 1);
    velocity_.series.add(state.mean_velocity);
    gradient_.series.add(state.mean_pressure_gradient);
}

StabilityWatch::Trouble StabilityWatch::worst(const StepState& state)
{
    if (!finite(state))
        return {Stability::hopeless, "pressure, velocity or energy is not finite", "in a gas step", "", true};
    const Yardstick weight{state.weight_gradient, limits_.pressure, "mean pressure gradient on the particles", " Pa/m",
                           "times the one that carries them"};
    Yardstick fall{gravity_ * state.duration, limits_.velocity, "mean velocity of the particles", " m/s",
                   "times what gravity gives in a gas step"};
    if (!(gravity_ > 0))
        fall = {std::max(usual_speed_, at_rest), 0.1 * limits_.velocity, fall.name, fall.unit,
                "times the usual speed of gas and particles"};

    const Trouble of_gradient = alternation(gradient_, weight);
    const Trouble of_velocity = alternation(velocity_, fall);
    const Trouble of_speed = acceleration(state);
    if (std::max(of_gradient.stability, of_velocity.stability) != Stability::calm) ++counts_.alternating;
    if (of_speed.stability != Stability::calm) ++counts_.accelerating;
    const Trouble& oscillation = of_velocity.stability > of_gradient.stability ? of_velocity : of_gradient;
    return of_speed.stability > oscillation.stability ? of_speed : oscillation;
}

StabilityWatch::Trouble StabilityWatch::alternation(Watched& watched, const Yardstick& yardstick) const
{
    const Alternation& series = watched.series;
    if (!(yardstick.scale > 0)) return {};
    const double swing = series.swing() / yardstick.scale, amplitude = series.amplitude() / yardstick.scale;
    const bool lasts = series.purity() > limits_.purity && series.persistence() > limits_.persistence &&
                       amplitude > yardstick.noticeable;
    const bool grows = series.growth() > 0 && series.unevenness() < limits_.unevenness &&
                       swing > std::max(limits_.swing, yardstick.noticeable) &&
                       series.swing() > limits_.outstanding * series.background();
    watched.large = lasts && amplitude > limits_.large ? watched.large + 1 : 0;
    if (!lasts && !grows) return {};

    Trouble trouble;
    trouble.grows = grows;
    const double size = grows ? swing : amplitude;
    trouble.what = "the " + yardstick.name + " alternates from gas step to gas step, by +-" +
                   about(size * yardstick.scale) + yardstick.unit + ", " + about(size) + " " + yardstick.scale_name;
    const int steps = grows ? series.growing() : std::max(watched.large, Alternation::window);
    trouble.when = "for " + std::to_string(steps) + " gas steps";
    if (grows)
        trouble.what += ", " + about(series.growth()) + " times as much as " + std::to_string(Alternation::ratios) +
                        " steps before";
    const bool hopeless =
        watched.large >= limits_.hopeless_large ||
        (grows && told_of_this_step_ && series.growing() >= limits_.hopeless_growing && swing > limits_.hopeless_swing);
    trouble.stability = hopeless ? Stability::hopeless : Stability::doubtful;
    trouble.what += hopeless ? ": the time stepping of gas and particles diverges"
                             : ": the gas step is too long for what gas and particles do to each other";
    return trouble;
}

StabilityWatch::Trouble StabilityWatch::acceleration(const StepState& state)
{
    const double speed = state.mass > 0 ? std::sqrt(2 * state.kinetic_energy / state.mass) : 0;
    const double before = speed_;
    speed_ = speed;
    const bool beyond_weight = speed - before > limits_.pull * gravity_ * state.duration;
    if (before < at_rest || speed < limits_.faster * before || !beyond_weight) {
        accelerating_ = 0;
        return {};
    }
    if (accelerating_++ == 0) {
        gas_speed_before_ = state.gas_speed;
        speed_before_ = before;
    }
    if (accelerating_ < limits_.accelerating || speed < limits_.beyond_gas * gas_speed_before_) return {};

    Trouble trouble;
    trouble.stability = accelerating_ >= limits_.hopeless_accelerating ? Stability::hopeless : Stability::doubtful;
    trouble.grows = true;
    trouble.what = "the particles' rms speed grows from gas step to gas step beyond what gravity and a gas of " +
                   about(gas_speed_before_) + " m/s can give, from " + about(speed_before_) + " to " + about(speed) +
                   " m/s";
    trouble.when = "for " + std::to_string(accelerating_) + " gas steps";
    trouble.remedy = "; check overlaps at the start and the solid step, too";
    return trouble;
}

void StabilityWatch::adapt_step(double duration, const Trouble& trouble)
{
    if (patience_ > 0) --patience_;
    if (trouble.stability != Stability::calm) {
        in_doubt_ = told_of_this_step_ = true;
        calm_steps_ = 0;
        if (patience_ > 0 && !(trouble.grows && patience_ > patience_with_growth)) return;
        doubted_step_ = duration;
        longest_calm_ = std::min(longest_calm_, 0.5 * duration);
        patience_ = trouble.grows ? patience_with_growth : patience_with_oscillation;
        return;
    }
    ++calm_steps_;
    if (calm_steps_ < long_calm) return;
    in_doubt_ = told_of_this_step_ = false;
    const bool bears_it = duration > 0.5 * longest_calm_;  // a step kept short by others says nothing of this limit
    if (!bears_it || (calm_steps_ - long_calm) % Alternation::window != 0) return;
    longest_calm_ *= 1.05;
    if (longest_calm_ > 4 * doubted_step_) longest_calm_ = DBL_MAX;
}

std::optional<Problem> StabilityWatch::watch_crossing(const StepState& state)
{
    longest_within_cells_ = state.largest_crossing > 0 ? state.duration / state.largest_crossing : DBL_MAX;
    if (!(state.largest_crossing > 1)) return {};
    return too_far(state, longest_within_cells_, counts_.crossing,
                   "a particle crosses " + about(state.largest_crossing) +
                       " gas cells in a gas step: it feels the gas of cells that it has left");
}

std::optional<Problem> StabilityWatch::watch_waves(const StepState& state)
{
    if (!(state.largest_wave_crossing > limits_.waves)) return {};
    return too_far(state, limits_.waves / state.largest_wave_crossing * state.duration, counts_.outrun,
                   "waves of the solid fraction run " + about(state.largest_wave_crossing) +
                       " gas cells in a gas step, while drag is of the voidage at its start: they grow, and the bed "
                       "may break up or stand at another height");
}

std::optional<Problem> StabilityWatch::too_far(const StepState& state, double limit, long& count,
                                               const std::string& what)
{
    longest_within_cells_ = std::min(longest_within_cells_, limit);
    if (++count > 1) return {};
    return Problem{what + " (told once, counted from now on)", place(state), shorter_step(limit),
                   moment(state, "in a gas step")};
}

void StabilityWatch::keep(Archive& archive)
{
    archive.keep("counts", counts_);
    archive.keep("gradient", gradient_);
    archive.keep("velocity", velocity_);
    archive.keep("duration", duration_);
    archive.keep("mass", mass_);
    archive.keep("usual_speed", usual_speed_);
    archive.keep("speed", speed_);
    archive.keep("accelerating", accelerating_);
    archive.keep("gas_speed_before", gas_speed_before_);
    archive.keep("speed_before", speed_before_);
    archive.keep("in_doubt", in_doubt_);
    archive.keep("told_of_this_step", told_of_this_step_);
    archive.keep("calm_steps", calm_steps_);
    archive.keep("patience", patience_);
    archive.keep("longest_calm", longest_calm_);
    archive.keep("longest_within_cells", longest_within_cells_);
    archive.keep("doubted_step", doubted_step_);
}

}  // namespace interphase
