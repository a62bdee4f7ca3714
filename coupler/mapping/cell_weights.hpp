// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mapping/cell_neighbourhood.hpp"

namespace interphase {

/// The weights w_ic with which particle i belongs to cell c; sum_c w_ic = 1 for each i. The same weights carry particle
/// data to the cells and gas data back, which is what conserves momentum between the two.
class CellWeights {
public:
    explicit CellWeights(const CellNeighbourhood& cells) : cells_(cells) {}

    /// Each particle wholly in its own cell.
    void place_in_own_cell(const std::vector<int>& own_cell);

    /// Each particle spread over the cells whose reach holds its centre:
    /// w_ic ~ V_c prod_axis max(0, 1 - |x_i - x_c| / reach_c). On a uniform grid of boxes no smaller than the reach
    /// this is trilinear (cloud-in-cell: Hockney and Eastwood, Computer Simulation Using Particles, 1988, ch. 5), so a
    /// particle's share of a cell changes continuously as it moves. `positions` [n x 3].
    void spread_by_kernel(const Scalars& positions, const std::vector<int>& own_cell);

    std::size_t particles() const { return first_.size() - 1; }

    /// Adds sum_i w_ic q_i to `of_cells` [local_count x width].
    void add_to_cells(const Scalars& of_particles, int width, Scalars& of_cells) const;

    /// sum_c w_ic q_c for each particle [n x width].
    void at_particles(const Scalars& of_cells, int width, Scalars& of_particles) const;

private:
    const CellNeighbourhood& cells_;
    std::vector<std::size_t> first_{0};  ///< entry of each particle, and one past the last
    std::vector<int> cell_;              ///< what follows the last entry is spare
    Scalars weight_;                     ///< likewise
};

}  // namespace interphase
