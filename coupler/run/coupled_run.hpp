// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "engines/liggghts/solids/liggghts_solids.hpp"
#include "engines/openfoam/foam_case.hpp"
#include "records/particle_snapshots.hpp"
#include "records/results.hpp"
#include "run/lockstep_clock.hpp"
#include "run/population.hpp"
#include "run/report.hpp"
#include "step/coupling_step.hpp"

namespace interphase {

/// A case from its start to its end: reads and checks it, steps, records.
class CoupledRun {
public:
    /// Throws a UserError for a case that cannot run. Collective, as are all members.
    CoupledRun(int& argc, char**& argv);

    /// Throws a UserError if the run has to stop early; what was recorded so far is kept.
    void run();

private:
    void refuse_empty_scene() const;
    void check_weights() const;
    void check_scene() const;
    LockstepClock choose_clock() const;
    void check_given_step() const;
    double longest_solid_step() const;
    void describe_run();
    void step();
    double wanted_gas_step() const;
    void record(bool snapshot);
    void finish();

    Communicator comm_;
    Stopwatch stopwatch_{Phase::setup};
    FoamCase case_;
    Settings settings_;
    std::unique_ptr<FoamGas> gas_;
    std::unique_ptr<LiggghtsSolids> solids_;
    LockstepClock clock_{1};
    std::unique_ptr<CouplingStep> coupling_;
    std::unique_ptr<Results> results_;
    std::unique_ptr<ParticleSnapshots> snapshots_;
    Report report_;
    Observation last_seen_;
    double next_record_ = 0, next_snapshot_ = 0;
    double gas_step_ = 0;
    Population at_start_;
};

}  // namespace interphase
