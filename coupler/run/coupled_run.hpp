// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <memory>
#include <optional>

#include "records/particle_snapshots.hpp"
#include "records/results.hpp"
#include "run/checkpoint.hpp"
#include "run/gas_case.hpp"
#include "run/lockstep_clock.hpp"
#include "run/particle_engine.hpp"
#include "run/population.hpp"
#include "run/record_schedule.hpp"
#include "run/report.hpp"
#include "run/stop_request.hpp"
#include "step/coupling_step.hpp"

namespace interphase {

/// From where a run starts.
enum class Beginning { anew, last_checkpoint };

/// A case from its start to its end: checks it, steps, records. Which engines there are is the caller's choice.
class CoupledRun {
public:
    /// Throws a UserError for a case that cannot run. Collective, as are all members.
    CoupledRun(GasCase& gas_case, const MakeParticleEngine& make_particles, Beginning beginning = Beginning::anew);

    /// Returns 0 at the end time, or the signal that ended it after a step (run/stop_request.hpp). Throws a UserError
    /// if the run cannot go on; what was recorded so far is kept.
    int run();

private:
    void refuse_empty_scene() const;
    void check_weights() const;
    void check_scene() const;
    LockstepClock choose_clock() const;
    void check_given_step() const;
    double longest_solid_step() const;
    void describe_run();
    std::vector<EngineWarnings*> warners() const;
    void tell_warnings();
    void tell_own_warnings() const;
    void describe_population();
    PopulationTotals came_and_went() const;
    void step();
    void follow_end_time();
    long steps_until(double end) const;
    double wanted_gas_step() const;
    void record(bool snapshot);
    Problem full_disk() const;
    void refuse_full_disk() const;
    void finish();
    void keep_what_is_known(const std::exception& error);  ///< after it

    void find_checkpoint();
    void put_records_aside() const;
    void put_checkpoints_aside() const;
    Checkpoints::Facts facts() const;  ///< on the first rank
    void refuse_other_run(const Checkpoints::Found& found) const;
    void keep(Archive& archive);
    void go_on();
    void begin_checkpoints();
    bool checkpoint_due();
    void checkpoint();

    Communicator comm_;
    Stopwatch stopwatch_{Phase::setup};
    GasCase& case_;
    Settings settings_;
    std::unique_ptr<CaseGas> gas_;
    std::unique_ptr<ParticleEngine> solids_;
    LockstepClock clock_{1};
    std::unique_ptr<CouplingStep> coupling_;
    std::unique_ptr<Results> results_;
    std::unique_ptr<ParticleSnapshots> snapshots_;
    Report report_;
    Observation last_seen_;
    std::optional<RecordSchedule> rows_, own_snapshots_;  ///< the latter where snapshots do not follow the fields
    double gas_step_ = 0;
    std::optional<StopRequest> requests_;  ///< while it runs
    int stopped_by_ = 0;                   ///< a signal, the same on all ranks
    double end_time_ = 0;                  ///< as the engine of the particles knows it [s]
    bool ended_ = false;                   ///< the end of the run has been recorded
    double last_snapshot_ = -1e300;        ///< [s]
    Population at_start_;
    Checkpoints checkpoints_{comm_};
    std::optional<Checkpoints::Found> kept_;  ///< from which the run is to go on
    std::optional<RecordSchedule> simulated_checkpoints_;
    double last_checkpoint_ = 0;                  ///< by the wall clock, from the start [s]
    std::optional<PopulationWatch> without_gas_;  ///< where no coupling step counts who comes and goes
};

}  // namespace interphase
