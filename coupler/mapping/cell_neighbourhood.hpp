// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "base/communicator.hpp"
#include "base/numbers.hpp"
#include "exchange/exchange_plan.hpp"
#include "mapping/mesh_view.hpp"

namespace interphase {

/// This rank's gas cells, the cells of other ranks within their reach (the halo), and who is near whom.
///
/// A cell's reach is a box about its centre, of half-widths `reach` = max(extent, least reach) per axis. A neighbour
/// of a cell is any cell whose reach touches it, the cell itself first. Cells are numbered locally: own ones first, as
/// in the MeshView, then the halo. Found from centres and extents alone, so it works on any mesh and partition.
class CellNeighbourhood {
public:
    /// Collective; the mesh must not change afterwards.
    CellNeighbourhood(const Communicator& comm, const MeshView& own, double least_reach);

    std::size_t own_count() const { return own_count_; }
    std::size_t local_count() const { return volume_.size(); }

    const Vector& centre(std::size_t local) const { return centre_[local]; }
    const Vector& reach(std::size_t local) const { return reach_[local]; }
    double volume(std::size_t local) const { return volume_[local]; }

    /// Local numbers of the neighbours of own cell `cell`.
    const int* neighbours_begin(std::size_t cell) const { return neighbours_.data() + first_[cell]; }
    const int* neighbours_end(std::size_t cell) const { return neighbours_.data() + first_[cell + 1]; }

    /// The neighbours whose reach touches the eighth of the cell that `point` is in: all that can hold a point there.
    /// On a uniform grid these are 8 of the 27.
    std::pair<const int*, const int*> neighbours_near(std::size_t cell, const Vector& point) const
    {
        const std::size_t list = 8 * cell + octant(cell, point);
        return {of_octants_.data() + first_of_octants_[list], of_octants_.data() + first_of_octants_[list + 1]};
    }

    /// Sets the halo's part of `values` [local_count()] to what the owners have. Collective.
    template <class Record>
    void fill_halo(std::vector<Record>& values) const
    {
        if (comm_.size() == 1) return;
        std::vector<Record> out(served_.size());
        for (std::size_t i = 0; i < served_.size(); ++i)
            out[i] = values[served_[i]];
        const std::vector<Record> in = exchange_.backward(std::move(out));
        std::copy(in.begin(), in.end(), values.begin() + static_cast<std::ptrdiff_t>(own_count_));
    }

    /// Adds the halo's part of `values` to the owners' and clears it. Collective.
    template <class Record>
    void add_halo_to_owners(std::vector<Record>& values) const
    {
        if (comm_.size() == 1) return;
        const auto halo = values.begin() + static_cast<std::ptrdiff_t>(own_count_);
        const std::vector<Record> in = exchange_.forward(std::vector<Record>(halo, values.end()));
        for (std::size_t i = 0; i < served_.size(); ++i)
            numbers(values[served_[i]]) += numbers(in[i]);
        std::fill(halo, values.end(), Record{});
    }

    std::size_t bytes_sent() const { return exchange_.bytes_sent(); }

private:
    struct Candidates;

    std::size_t octant(std::size_t cell, const Vector& point) const
    {
        const Vector& c = centre_[cell];
        return (point[0] > c[0] ? 1u : 0u) + (point[1] > c[1] ? 2u : 0u) + (point[2] > c[2] ? 4u : 0u);
    }

    Candidates add_reaching_cells_of_others(const MeshView& own);
    void find_neighbours(const MeshView& own);
    void sort_into_octants(const MeshView& own);
    void drop_unused_halo(const Candidates& candidates);

    Communicator comm_;
    std::size_t own_count_;
    Vectors centre_;
    Vectors reach_;
    Scalars volume_;
    std::vector<std::size_t> first_;
    std::vector<int> neighbours_;
    std::vector<std::size_t> first_of_octants_;
    std::vector<int> of_octants_;
    ExchangePlan exchange_;            ///< from owners to those that hold halo copies
    std::vector<std::size_t> served_;  ///< own cells that others hold, ordered by rank
};

}  // namespace interphase
