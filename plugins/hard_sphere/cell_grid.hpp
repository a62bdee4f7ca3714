// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "hard_sphere/bodies.hpp"
#include "hard_sphere/processor.hpp"

namespace interphase::hard_sphere {

/// Sorts spheres into cells, so that those near each other are near in memory, and names the candidates for contact.
/// Made anew in every step: a counting sort costs less than a neighbour list that has to stay valid for fast particles.
///
/// Spheres of different size live in a hierarchy of grids with cells twice as wide from one to the next; a sphere is in
/// the finest one whose cells are as wide as its diameter and the reach. It looks for partners in its own grid and in
/// the coarser ones, so small spheres do not count as candidates of each other because a large one is about.
/// (Ogarko and Luding, Comput. Phys. Commun. 183 (2012) 931.)
class CellGrid {
public:
    /// `reach`: the largest gap between two surfaces that is of interest [m]; `slowest`: axis along which neighbours in
    /// memory change last (0 to 2).
    void sort(const std::vector<Place>& places, double reach, int slowest);

    /// order()[k] is the index, as given to sort(), of the sphere that comes k-th. [n]
    const std::vector<int>& order() const { return order_; }

    /// Calls visit(i, first, last) with i and [first, last) counting in the new order: together the ranges hold every
    /// partner within `reach` of i, and each pair comes once. Spheres farther apart are among them.
    template <class Visit>
    void candidates(const Visit& visit) const;

private:
    struct Level {
        double inverse_size;
        std::array<double, 3> corner;  ///< of the first cell, slowest axis first
        std::array<int, 3> cells;      ///< with an empty layer all round
        int first_cell;
        int first_sphere, last_sphere;  ///< in the new order
    };

    std::vector<Level> choose_levels(const std::vector<Place>& places, double reach, int slowest);
    int cell_at(const Level& level, const Place& place) const;

    static constexpr int most_levels = 8;
    std::array<int, 3> axes_{2, 0, 1};  ///< slowest to fastest
    std::vector<Level> levels_;
    std::vector<signed char> level_of_;
    std::vector<int> cell_of_, order_, start_;
    std::vector<int> sorted_cell_;
    std::vector<std::array<int, most_levels>> coarser_cells_;
};

template <class Visit>
INTERPHASE_INLINE void CellGrid::candidates(const Visit& visit) const
{
    const int* start = start_.data();
    for (std::size_t l = 0; l < levels_.size(); ++l) {
        const Level& own = levels_[l];
        const int row = own.cells[2], layer = own.cells[1] * own.cells[2];
        for (int i = own.first_sphere; i < own.last_sphere; ++i) {
            const int c = sorted_cell_[static_cast<std::size_t>(i)];
            visit(i, i + 1, start[c + 2]);
            for (const int neighbour : {c + row, c + layer - row, c + layer, c + layer + row})
                visit(i, start[neighbour - 1], start[neighbour + 2]);
            for (std::size_t m = l + 1; m < levels_.size(); ++m) {
                const Level& coarser = levels_[m];
                const int width = coarser.cells[2], depth = coarser.cells[1] * coarser.cells[2];
                const int centre = coarser_cells_[static_cast<std::size_t>(i)][m];
                for (const int slow : {-depth, 0, depth})
                    for (const int middle : {-width, 0, width}) {
                        const int neighbour = centre + slow + middle;
                        visit(i, start[neighbour - 1], start[neighbour + 2]);
                    }
            }
        }
    }
}

}  // namespace interphase::hard_sphere
