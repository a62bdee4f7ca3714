// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapping/cell_weights.hpp"
#include "mapping/mapping_type.hpp"
#include "mapping/packing_limit.hpp"

namespace interphase {

/// Particles to gas cells and back: weights, halo and packing limit in one pair of transposed operators.
class Mapping {
public:
    Mapping(const Communicator& comm, const MeshView& mesh, MappingType type, double kernel_width,
            double maximum_packing);

    /// Computes the weights of the particles that visit this rank: `positions` [n], `cells` [n].
    void place(const Vectors& positions, const std::vector<int>& cells);

    /// Solid volume per cell [m3] from that of each particle, within the packing limit. Fixes the packing hand-over for
    /// this step. Collective.
    Scalars solid_volume(const Scalars& of_particles);

    /// Contents of the own cells, sum_i w_ic q_i [own cells], of a record of doubles: deposition. After solid_volume().
    /// Collective.
    template <class Record>
    std::vector<Record> deposit(const std::vector<Record>& of_particles) const
    {
        std::vector<Record> content(cells_.local_count(), Record{});
        weights_.deposit(of_particles, content);
        cells_.add_halo_to_owners(content);
        limit_.hand_over(content);
        content.resize(cells_.own_count());
        return content;
    }

    /// Values at the particles, sum_c w_ic q_c [n], of own-cell values: interpolation, its transpose. After
    /// solid_volume(). Collective.
    template <class Record>
    void interpolate(std::vector<Record> of_cells, std::vector<Record>& of_particles) const
    {
        of_cells.resize(cells_.local_count(), Record{});
        limit_.take_from_receivers(of_cells);
        cells_.fill_halo(of_cells);
        weights_.interpolate(of_cells, of_particles);
    }

    long cells_relieved() const { return limit_.cells_relieved(); }
    std::size_t bytes_sent() const { return cells_.bytes_sent(); }

private:
    MappingType type_;
    CellNeighbourhood cells_;
    CellWeights weights_;
    PackingLimit limit_;
};

}  // namespace interphase
