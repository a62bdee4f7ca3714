// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <memory>
#include <optional>

#include "base/exit_code.hpp"
#include "run/checkpoint.hpp"
#include "run/checkpoint_schedule.hpp"
#include "run/count_news.hpp"
#include "run/gas_case.hpp"
#include "run/lockstep_clock.hpp"
#include "run/particle_engine.hpp"
#include "run/population.hpp"
#include "run/processor_time.hpp"
#include "run/report.hpp"
#include "run/run_options.hpp"
#include "run/run_records.hpp"
#include "run/signal_requests.hpp"
#include "run/wall_limit.hpp"
#include "step/coupling_step.hpp"

namespace interphase {

/// A case from its start to its end: checks it, steps, records. Which engines there are is the caller's choice.
class CoupledRun {
public:
    /// Throws a UserError for a case that cannot run. Collective, as are all members.
    CoupledRun(GasCase& gas_case, const ParticleEngineMaker& engines, const RunOptions& options = {});

    /// Returns the exit code: of the end time, of the limit of wall-clock time, or of the signal that ended it after a
    /// step (run/signal_requests.hpp). Throws a UserError if the run cannot go on; what was recorded so far is kept.
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
    std::vector<Count> counts() const;
    void tell_counts();
    void step();
    void follow_end_time();
    long steps_until(double end) const;
    double wanted_gas_step() const;
    void record(bool at_start);
    void look_for_the_end();
    std::string stopped_by() const;
    Wholes booked() const;  ///< but for the particles
    Wholes wholes() const;
    void finish();
    void keep_what_is_known(const std::exception& error);  ///< after it

    void find_checkpoint();
    void make_way_for_checkpoints(bool overwrites) const;
    Checkpoints::Facts facts() const;  ///< on the first rank
    void refuse_other_run(const Checkpoints::Found& found) const;
    void keep(Archive& archive);
    void go_on();
    std::string describe_checkpoints() const;
    void checkpoint_if_due();
    void write_checkpoint(CheckpointSchedule::Due why);
    std::string way_to_go_on() const;

    Communicator comm_;
    Stopwatch stopwatch_{Phase::setup};
    ProcessorTime processor_{comm_, stopwatch_};
    GasCase& case_;
    Settings settings_;
    std::unique_ptr<CaseGas> gas_;
    std::unique_ptr<ParticleEngine> solids_;
    LockstepClock clock_{1};
    std::unique_ptr<CouplingStep> coupling_;
    std::optional<PopulationWatch> without_gas_;  ///< where no coupling step counts who comes and goes
    Population at_start_;
    std::optional<RunRecords> records_;
    Report report_;
    CountNews count_news_;
    double gas_step_ = 0;
    std::optional<SignalRequests> requests_;  ///< while it runs
    int signal_ = 0;                          ///< that ends the run, the same on all ranks
    WallLimit wall_limit_;
    bool out_of_time_ = false;  ///< by the wall clock
    double end_time_ = 0;       ///< as the engine of the particles knows it [s]
    bool ended_ = false;        ///< the end of the run has been recorded
    Checkpoints checkpoints_{comm_};
    CheckpointSchedule checkpoint_schedule_;
    Checkpoints::Facts facts_;                ///< as the run began: what is edited later, it does not know
    std::optional<Checkpoints::Found> kept_;  ///< from which the run is to go on
    SpentTime spent_before_;                  ///< by the parts of the run before this one
};

}  // namespace interphase
