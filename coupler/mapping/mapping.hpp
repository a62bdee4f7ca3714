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

    /// Computes the weights of the particles that visit this rank: `positions` [n x 3], `cells` [n].
    void place(const Scalars& positions, const std::vector<int>& cells);

    /// Solid volume per cell [m3] from that of each particle, within the packing limit. Fixes the packing hand-over for
    /// this step. Collective.
    Scalars solid_volume(const Scalars& of_particles);

    /// Contents of the own cells, sum_i w_ic q_i [own cells x width]. After solid_volume(). Collective.
    Scalars to_cells(const Scalars& of_particles, int width) const;

    /// Values at the particles, sum_c w_ic q_c [n x width], of own-cell values. After solid_volume(). Collective.
    void to_particles(const Scalars& of_cells, int width, Scalars& of_particles) const;

    long cells_relieved() const { return limit_.cells_relieved(); }
    std::size_t doubles_sent() const { return cells_.doubles_sent(); }

private:
    MappingType type_;
    CellNeighbourhood cells_;
    CellWeights weights_;
    PackingLimit limit_;
};

}  // namespace interphase
