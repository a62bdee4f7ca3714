// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "base/count.hpp"
#include "step/gas.hpp"
#include "step/interphase_forces.hpp"
#include "step/solids.hpp"
#include "step/stability_watch.hpp"
#include "step/visitors.hpp"

namespace interphase {

/// Tells the stability watch of each coupling step.
class StepWatch {
public:
    StepWatch(const Communicator& comm, const Gas& gas, Solids& solids);

    /// The time that messages count from [s]; 0 at first.
    void start_at(double time) { time_ = time; }

    /// Before the gas is solved: how many cells particles would cross in `dt` [s].
    void note_crossing(const Visitors& visitors, double dt);

    /// Before the solids move by `solid_step` [s]: throws a UserError where a particle would leave the whole mesh in
    /// one of them, which engines answer with a crash, or the gas has no numbers. Collective.
    void refuse_impossible_flight(double solid_step) const;

    /// After the step of `dt` [s]; lets the forces know how fast particles answer on all ranks. Throws a UserError
    /// where the run is hopeless. Collective.
    void observe(InterphaseForces& forces, const Scalars& voidage, const Scalars& solid_volume, double dt);

    /// What there is to tell of the last step; empty where there is nothing new.
    const std::string& news() const { return news_; }
    double longest_step() const { return watch_.longest_step(); }  ///< that the next should have [s]
    /// Gas steps: the watch says the same on all ranks, so the first one counts for all.
    std::vector<Count> counts() const;

    void keep(Archive& archive)
    {
        archive.keep("stability", watch_);
        archive.keep("time", time_);
    }

private:
    StepState state_of_step(InterphaseForces& forces, const Scalars& voidage, const Scalars& solid_volume, double dt);

    Communicator comm_;
    const Gas& gas_;
    Solids& solids_;
    StabilityWatch watch_;
    double time_ = 0;      ///< [s]
    double crossing_ = 0;  ///< most gas cells that a particle of this rank crosses in the step
    double widest_;        ///< diagonal of the whole mesh [m]
    std::string news_;
};

}  // namespace interphase
