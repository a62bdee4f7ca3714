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
    /// particle's share of a cell changes continuously as it moves. `positions` [n].
    void spread_by_kernel(const Vectors& positions, const std::vector<int>& own_cell);

    std::size_t particles() const { return first_.size() - 1; }

    /// Adds sum_i w_ic q_i to `of_cells` [local_count].
    template <class Record>
    void deposit(const std::vector<Record>& of_particles, std::vector<Record>& of_cells) const
    {
        for (std::size_t i = 0; i < particles(); ++i) {
            const Numbers<Record> q = numbers(of_particles[i]);
            for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
                numbers(of_cells[static_cast<std::size_t>(cell_[k])]) += weight_[k] * q;
        }
    }

    /// sum_c w_ic q_c for each particle [n].
    template <class Record>
    void interpolate(const std::vector<Record>& of_cells, std::vector<Record>& of_particles) const
    {
        of_particles.resize(particles());
        for (std::size_t i = 0; i < particles(); ++i) {
            Numbers<Record> q = Numbers<Record>::Zero();
            for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
                q += weight_[k] * numbers(of_cells[static_cast<std::size_t>(cell_[k])]);
            numbers(of_particles[i]) = q;
        }
    }

private:
    const CellNeighbourhood& cells_;
    std::vector<std::size_t> first_{0};  ///< entry of each particle, and one past the last
    std::vector<int> cell_;              ///< what follows the last entry is spare
    Scalars weight_;                     ///< likewise
};

}  // namespace interphase
