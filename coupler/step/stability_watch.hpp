// SPDX-License-Identifier: GPL-3.0-or-later
//
// Says whether the time stepping goes wrong: the books close to round-off while a bed explodes, so that only what gas
// and particles do over several steps can tell.
#pragma once

#include <algorithm>
#include <cfloat>
#include <optional>
#include <string>

#include "base/archive.hpp"
#include "base/problem.hpp"
#include "step/alternation.hpp"
#include "step/step_state.hpp"

namespace interphase {

enum class Stability {
    calm,
    doubtful,  ///< results suffer: told and counted
    hopeless   ///< the run diverges: it should end
};

struct Finding {
    Stability stability = Stability::calm;
    /// To be told now; none where there is nothing new: an oscillation or a growth is told once for each time it sets
    /// in, and a particle that crosses more than a cell, or a wave, once a run.
    std::optional<Problem> problem;

    std::string message() const { return problem ? problem->message() : ""; }  ///< empty where there is nothing new
};

/// What is physically allowed. A particle under forces of the order of its weight gains about g dt in a step, so its
/// velocity alternates by g dt/2 at the most (a ball that bounces twice a step does); gas in a bed of given weight
/// swings slowly around the gradient that carries it, in slugging beds by half of it over tens of steps.
struct StabilityLimits {
    /// An oscillation of two steps is told when it has this share of the variance of 24 steps: see Alternation::window
    /// for how seldom noise has.
    double purity = 0.85;
    /// ... and has not decayed (younger over older half of the window): what a start or a jump of an inlet sets off
    /// dies away, by a fifth in 12 steps at the least.
    double persistence = 0.8;
    /// ... and is larger than this: of the pressure gradient, over the one that carries the weight. Below it the drop
    /// over a bed is right within what its closures are.
    double pressure = 0.05;
    /// ... or of the velocity, over g dt; without gravity, over a tenth of what gas and particles move at.
    double velocity = 1;

    /// A swing that turns round and grows in each of six steps on end, as evenly as an unstable mode, is told when it
    /// exceeds `swing` times the weight's gradient or what is told of the velocity, and `outstanding` times its usual
    /// size (in 2e7 steps each of six kinds of noise none did; at 4 times, one in 1e6). It is hopeless when it was told
    /// before at this gas step, has grown for `hopeless_growing` steps and exceeds `hopeless_swing`.
    double unevenness = 1.5;
    double swing = 0.2;
    double outstanding = 6;
    int hopeless_growing = 7;
    double hopeless_swing = 10;

    /// An oscillation that has been told and stays above this for so many steps (four windows) is hopeless too.
    double large = 3;
    int hopeless_large = 96;

    /// The particles' rms speed grows beyond reason when it grows by 30 % in so many steps on end, each time by more
    /// than `pull` times g dt, and beyond `beyond_gas` times the gas speed that there was. From rest, a constant force
    /// makes it grow by 30 % for 3 steps, one that grows linearly for 7, quadratically for 10: (11/10)^3 = 1.33.
    double faster = 1.3;
    double pull = 5;
    double beyond_gas = 3;
    int accelerating = 8;
    int hopeless_accelerating = 12;

    /// Drag is of the voidage at the start of a step, so waves that run further than this in it [gas cells] grow.
    /// In 3 s columns of liquid did at 0.32 cells a step what they do in short steps, and were 4 to 13 % off the law's
    /// height at 0.7 to 0.95 (cases/suspension).
    double waves = 0.5;
};

/// Steps with something wrong, so far.
struct StabilityCounts {
    long alternating = 0;   ///< doubtful: oscillation of two steps
    long accelerating = 0;  ///< doubtful: speed beyond what gravity and gas can give
    long crossing = 0;      ///< a particle crossed more than a gas cell
    long outrun = 0;        ///< waves of the solid fraction crossed too much of one
    long episodes = 0;      ///< times that doubt set in after calm
};

/// Is fed once a gas step with numbers over all ranks, and says the same on all of them.
class StabilityWatch {
public:
    /// Gravity's magnitude [m/s2].
    explicit StabilityWatch(double gravity, const StabilityLimits& limits = {}) : gravity_(gravity), limits_(limits) {}

    Finding observe(const StepState& state);

    /// What the next gas step should not exceed [s]: the last one halved in doubt, growing again by 5 % every 24 steps
    /// after 100 calm ones; and such that no particle crosses more than a gas cell, and no wave too much of one.
    double longest_step() const { return std::min(longest_calm_, longest_within_cells_); }

    const StabilityCounts& counts() const { return counts_; }

    void keep(Archive& archive);

private:
    struct Trouble {
        Stability stability = Stability::calm;
        std::string what, when, remedy;
        bool grows = false;  ///< from step to step, so that the step is halved without delay
    };
    struct Watched {
        Alternation series;
        int large = 0;  ///< steps on end with a large amplitude

        void keep(Archive& archive)
        {
            archive.keep("series", series);
            archive.keep("large", large);
        }
    };
    struct Yardstick {
        double scale;       ///< what physics gives [unit]
        double noticeable;  ///< amplitude that is told, over the scale
        std::string name, unit, scale_name;
    };

    void remember(const StepState& state);
    Trouble worst(const StepState& state);
    Trouble alternation(Watched& watched, const Yardstick& yardstick) const;
    Trouble acceleration(const StepState& state);
    void adapt_step(double duration, const Trouble& trouble);
    std::optional<Problem> watch_crossing(const StepState& state);
    std::optional<Problem> watch_waves(const StepState& state);
    /// Counts a step that ran too far, and shortens what longest_step() allows to `limit` [s]. What to tell of it: the
    /// first time only.
    std::optional<Problem> too_far(const StepState& state, double limit, long& count, const std::string& what);

    double gravity_;
    StabilityLimits limits_;
    StabilityCounts counts_;
    Watched gradient_, velocity_;
    double duration_ = 0, mass_ = 0;  ///< of the last step
    double usual_speed_ = 0;          ///< of gas and particles, over some 100 steps [m/s]

    double speed_ = 0;                                ///< rms of the particles [m/s]
    int accelerating_ = 0;                            ///< steps on end
    double gas_speed_before_ = 0, speed_before_ = 0;  ///< when that began [m/s]

    bool in_doubt_ = false;
    bool told_of_this_step_ = false;
    long calm_steps_ = 0;
    int patience_ = 0;  ///< steps until the step may be halved again
    double longest_calm_ = DBL_MAX, longest_within_cells_ = DBL_MAX;
    double doubted_step_ = DBL_MAX;
};

}  // namespace interphase
