// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "records/results.hpp"
#include "statistics/bed_surface.hpp"
#include "statistics/bubbles.hpp"
#include "statistics/mean_fields.hpp"
#include "statistics/statistics_scene.hpp"
#include "statistics/voidage_counts.hpp"
#include "step/coupling_step.hpp"
#include "step/solids.hpp"

namespace interphase {

/// The rows of /statistics in results.h5: of each sample what means and errors are made of later. All members are
/// collective.
class Statistics {
public:
    /// `gas` and `gas_bounds` null: no gas, and of the voidage nothing. Throws a UserError for a scene that cannot be
    /// (statistics_scene.hpp).
    Statistics(const Communicator& comm, const StatisticsSettings& settings, Solids& solids, Gas* gas,
               const Box* gas_bounds);

    /// What is sampled, as attributes of /statistics.
    void describe(Results& results) const;

    /// Of what the mean fields are now.
    void describe_mean_fields(Results& results) const;

    /// Adds a row, and the sample to the mean fields. `coupling` null: no gas.
    void sample(double time, const CouplingStep* coupling, Results& results);

    /// What was chosen by the bed as it was at the start, and what was summed up since.
    void keep(Archive& archive);

    double seconds() const { return seconds_; }  ///< wall-clock time of this rank's samples so far

private:
    void ready();
    void sample_windows(Results::Row& row);
    void sample_overlaps(Results::Row& row);
    void sample_voidage(Results::Row& row, const Scalars& voidage) const;
    void sample_surface(Results::Row& row, const Scalars& voidage);
    void sample_energy(Results::Row& row);
    void sample_fields(double time, const CouplingStep& coupling);

    Communicator comm_;
    const StatisticsSettings& settings_;
    Solids& solids_;
    Gas* gas_;
    const MeshView* mesh_;
    StatisticsScene scene_;
    Scalars voidage_edges_;
    double cells_ = 0;  ///< of all ranks
    std::optional<BedSurface> surface_;
    std::optional<Layers> layers_;
    std::optional<Bubbles> bubbles_;
    std::optional<MeanFields> mean_fields_;
    double seconds_ = 0;
};

}  // namespace interphase
