// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/archive.hpp"
#include "mapping/mesh_view.hpp"
#include "records/results.hpp"
#include "statistics/running_moments.hpp"
#include "step/cell_solids.hpp"
#include "step/gas.hpp"

namespace interphase {

/// Means and variances over the samples, cell by cell: of the voidage and the gas velocity every sample counts alike,
/// of the solid velocity by the solid volume, <eps_s v>/<eps_s>. The variance is that of the cell's mean velocity over
/// time, component by component; how velocities differ within a cell, the granular temperature, is no part of it.
class MeanFields {
public:
    explicit MeanFields(const MeshView& mesh);

    /// A sample of the own cells: `voidage` [n], gas `velocity` [n x 3, m/s], `solids` [n].
    void add(double time, const Scalars& voidage, const Scalars& velocity, const std::vector<CellSolids>& solids);

    double samples() const { return samples_; }

    /// meanVoidage, varianceVoidage, meanU, varianceU, meanSolidsU, varianceSolidsU; the last two are 0 where there
    /// never were solids.
    std::vector<CellField> fields() const;

    /// How many samples there are, and the times of the first and the last, as attributes of `group`.
    void describe(const std::string& group, Results& results) const;

    void keep(Archive& archive);

private:
    const MeshView& mesh_;
    RunningMoments voidage_, gas_, solids_;
    double samples_ = 0;
    double first_ = 0, last_ = 0;  ///< [s]
};

}  // namespace interphase
