// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "base/count.hpp"
#include "base/problem.hpp"
#include "records/particle_snapshots.hpp"
#include "records/results.hpp"
#include "run/case_gas.hpp"
#include "run/gas_case.hpp"
#include "run/observation.hpp"
#include "run/particle_engine.hpp"
#include "run/population.hpp"
#include "run/processor_time.hpp"
#include "run/record_schedule.hpp"
#include "run/spent_time.hpp"
#include "statistics/statistics.hpp"
#include "step/coupling_step.hpp"

namespace interphase {

/// What a run records: rows and attributes of results.h5, snapshots, and the gas's own files; when each is due; and
/// whether the disk takes it. All members are collective.
class RunRecords {
public:
    /// What it looks at; without a gas, who comes and goes is counted by `without_gas`, else by `coupling`.
    struct Scene {
        const Communicator& comm;
        const Settings& settings;
        GasCase& gas_case;
        ParticleEngine& solids;
        CaseGas* gas;
        CouplingStep* coupling;
        PopulationWatch* without_gas;
        const Population& at_start;
        const ProcessorTime& processor;
    };

    /// Replaces earlier records, or goes on behind those up to `goes_on_from` [s].
    RunRecords(const Scene& scene, std::optional<double> goes_on_from);

    /// What the run is, and that a part of it starts now.
    void describe(double solid_step, double gas_step);

    /// The books of the gas step that has ended.
    void add_ledger_row();

    struct Moment {
        double gas_step;  ///< [s]
        bool at_start, at_end;
        bool shown;  ///< a line of progress is due
    };
    /// What is due now. A UserError where the disk is full.
    void record(const Moment& moment);

    /// Whether earlier records reach this moment: with a snapshot of it.
    bool hold_this_moment() const { return snapshots_.last() == scene_.gas_case.time(); }

    /// What was seen when last a row, a line or the end was due.
    const Observation& last_seen() const { return last_seen_; }

    const PopulationTotals& came_and_went() const;

    struct Ending {
        std::string stopped_by;  ///< empty at the end time
        SpentTime spent;
        std::vector<Count> warnings;  ///< of the engines
        std::vector<Count> counters;  ///< of plug-ins
    };
    void describe_end(const Ending& ending);

    /// All rows so far are in the file then.
    void flush();

    /// When rows and snapshots are due next.
    void keep(Archive& archive);

private:
    void describe_population();
    void add_processor_time_row();
    void add_counters_row();
    void take_statistics(const Moment& moment);
    void add_tap_row();
    Problem full_disk() const;
    void refuse_full_disk() const;

    Scene scene_;
    Results results_;
    ParticleSnapshots snapshots_;
    RecordSchedule rows_;
    std::optional<RecordSchedule> own_snapshots_;  ///< where snapshots do not follow the fields
    std::optional<Statistics> statistics_;         ///< where they are asked for, as are the next two
    std::optional<RecordSchedule> samples_, taps_;
    Observation last_seen_;
};

}  // namespace interphase
