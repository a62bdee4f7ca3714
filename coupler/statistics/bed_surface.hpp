// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/communicator.hpp"
#include "step/solids.hpp"

namespace interphase {

/// The top of the bed as a camera in front of it sees it: in columns across x, over the whole depth, the height z below
/// which a share of the column's solids lies [m].
class BedSurface {
public:
    /// `columns` side by side in the vessel.
    BedSurface(const Box& vessel, std::size_t columns, double share);

    /// Of each column; NaN where it has no solids. Spheres count by their volume, where their centres are; in bins a
    /// 512th of the vessel high, evenly filled. Collective.
    Scalars heights(const Communicator& comm, const ParticleView& particles) const;

    const Scalars& edges() const { return edges_; }  ///< x [m]
    /// The column at x; one at the side where x is beyond it.
    std::size_t column_at(double x) const;

private:
    Scalars edges_;
    double low_, bin_;  ///< z of the lowest, height [m]
    double share_;
};

/// Mean of the columns that have solids; NaN where none has.
double mean_height(const Scalars& heights);

}  // namespace interphase
