// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "run/observation.hpp"
#include "run/spent_time.hpp"
#include "step/coupling_step.hpp"
#include "step/population_totals.hpp"

namespace interphase {

/// What the terminal shows: the head of the run, a line now and then, and the summary. Only rank 0 prints.
class Report {
public:
    Report(bool prints, double start_time, double end_time);

    /// A run goes on from there [s]: what it takes per time is told of what comes now.
    void go_on_from(double time) { part_start_ = time; }

    /// The end has moved [s]; one beyond 1e30 s is not known.
    void end_at(double end_time);

    void head(const std::vector<std::pair<std::string, std::string>>& facts) const;

    /// Prints if the last line is more than a few seconds old.
    void progress(double time, const Observation& seen);
    bool progress_due() const;

    /// What happened.
    void note(const std::string& message) const;

    /// To standard error.
    void warn(const std::string& message) const;

    double wall_seconds() const;

    struct Summary {
        double simulated_time;
        std::string stopped_by;                ///< the signal's name or the limit; empty at the end time
        SpentTime spent;                       ///< by all parts of the run
        std::vector<const Account*> balances;  ///< of a run in which the particles act on the gas
        PopulationTotals population;
        std::vector<Count> counts;
        Wholes wholes;             ///< that the counts are parts of
        std::string way_to_go_on;  ///< empty where the run has reached its end
    };
    void summary(const Summary& of) const;

private:
    bool prints_;
    double start_time_, part_start_, end_time_;
    double wall_start_;
    double last_line_ = -1e300;
};

}  // namespace interphase
