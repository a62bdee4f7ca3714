// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mapping/cell_neighbourhood.hpp"

namespace interphase {

/// Hands the solids of cells above a packing limit to their neighbours.
///
/// The hand-over is a linear operator on cell contents, with columns that sum to one: what it does to the solid volume
/// it does to every other quantity that particles give to the cells, and its transpose to what they get back. So volume
/// and momentum stay conserved while a cell is relieved.
class PackingLimit {
public:
    PackingLimit(const CellNeighbourhood& cells, const Communicator& comm, double limit)
        : cells_(cells), comm_(comm), limit_(limit)
    {}

    /// Relieves `solid_volume` [local_count, m3; halo part unused] until no own cell is above the limit, and remembers
    /// how. Throws a UserError where there is no room left for the excess. Collective.
    void relieve(Scalars& solid_volume);

    /// Does to another content [local_count x width] what relieve() did to the solid volume. Collective.
    void hand_over(Scalars& content, int width) const;

    /// The transpose, for cell values on their way to the particles [local_count x width]. Collective.
    void take_from_receivers(Scalars& values, int width) const;

    /// Cells of this rank that were above the limit in the last relieve().
    long cells_relieved() const { return cells_relieved_; }

private:
    struct Transfer {
        int from;  ///< own cell
        int to;    ///< local cell
        double fraction;
    };
    using Pass = std::vector<Transfer>;

    Pass transfers_for(const Scalars& solid_volume) const;
    void apply(const Pass& pass, Scalars& content, int width) const;

    const CellNeighbourhood& cells_;
    Communicator comm_;
    double limit_;
    std::vector<Pass> passes_;
    long cells_relieved_ = 0;
};

}  // namespace interphase
