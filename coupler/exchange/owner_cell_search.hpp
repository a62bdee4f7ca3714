// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/communicator.hpp"
#include "exchange/cell_locator.hpp"

namespace interphase {

/// Finds every particle's owner cell: the gas cell that holds its centre, and the rank that has the cell.
///
/// A particle's last owner cell is where its search starts; most stay or go to a neighbour. Only particles whose owner
/// is on another rank cause messages. A particle that the walk loses, or that has none yet, is offered to the ranks
/// whose part of the mesh may hold it. One that is outside, yet nearer to the mesh's edge than its reach (a sphere in a
/// round vessel, whose mesh has facets), belongs to the cell there.
class OwnerCellSearch {
public:
    OwnerCellSearch(const Communicator& comm, const CellLocator& locator);

    /// Updates `owner_cells` [n] for the particles at `positions` [n], with `reach` [n, m]. A particle in no gas cell,
    /// nor near one, gets an unknown one. Collective.
    void update(const VectorsView& positions, const ScalarsView& reach, std::vector<CellAddress>& owner_cells);

    /// Of this rank's particles, how many were outside the mesh and given to a cell at its edge, in the last update.
    long beyond_edge() const { return beyond_edge_; }

    /// Bytes this rank has sent to others so far.
    std::size_t bytes_sent() const { return bytes_sent_; }

private:
    using Slots = std::vector<std::size_t>;

    /// Where is this particle, or what is there within `reach` [m] of it?
    struct Question {
        std::size_t slot;
        double reach;
        double position[3];
    };
    template <class Answer>
    struct Offered {
        std::size_t slot;
        int rank;
        Answer answer;
    };

    Slots walk_from_last_owners(const VectorsView& positions, std::vector<CellAddress>& owner_cells);
    /// Offers each question to the ranks whose part of the mesh is within its reach, which reply.
    template <class Answer, class Reply>
    std::vector<Offered<Answer>> offer(const std::vector<Question>& questions, const Reply& reply);
    /// Returns those that nobody has.
    Slots search_everywhere(const std::vector<Question>& questions, std::vector<CellAddress>& owner_cells);
    void find_nearest(const std::vector<Question>& questions, std::vector<CellAddress>& owner_cells);
    CellAddress walk_or_search(const Vector& point, int start) const;

    Communicator comm_;
    const CellLocator& locator_;
    std::vector<Box> bounds_;  ///< of each rank's part of the mesh
    std::size_t bytes_sent_ = 0;
    long beyond_edge_ = 0;
};

}  // namespace interphase
