// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

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
    /// `centres` [count x 3, m] and `radii` [count, m]; `reach`: the largest gap between two surfaces that is of
    /// interest [m]; `slowest`: axis along which neighbours in memory change last (0 to 2).
    void sort(const double* centres, const double* radii, std::size_t count, double reach, int slowest);

    /// What holds all centres, by axis [m]. Nothing where there are none.
    const std::array<double, 3>& low() const { return low_; }
    const std::array<double, 3>& high() const { return high_; }

    /// order()[k] is the index, as given to sort(), of the sphere that comes k-th. [n]
    const std::vector<int>& order() const { return order_; }

    struct Range {
        int first, last;
    };

    /// Calls visit(i, a, b) with i and the ranges [first, last) a and b counting in the new order: together the ranges
    /// hold every partner within `reach` of i, and each pair comes once. Spheres farther apart are among them. Ranges
    /// come in twos since each holds a few spheres only.
    template <class Visit>
    void candidates(const Visit& visit) const;

private:
    struct Level {
        std::array<double, 3> inverse_size;
        std::array<double, 3> corner;  ///< of the first cell, slowest axis first
        std::array<int, 3> cells;      ///< with an empty layer, fineness cells along the fastest axis, all round
        int first_cell;
        int first_sphere, last_sphere;  ///< in the new order
    };

    std::vector<Level> choose_levels(const double* centres, const double* radii, std::size_t count, double reach,
                                     int slowest);
    int cell_at(const Level& level, const double* centre) const;

    static constexpr int most_levels = 8;
    /// Cells along the fastest axis in what is one along the others: neighbours in a row are read in one go, so the
    /// ends of the row may be cut finer.
    static constexpr int fineness = 2;
    std::array<double, 3> low_{}, high_{};
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
    const auto around = [=](int cell) __attribute__((always_inline))
    {
        return Range{start[cell - fineness], start[cell + fineness + 1]};
    };
    for (std::size_t l = 0; l < levels_.size(); ++l) {
        const Level& own = levels_[l];
        const int row = own.cells[2], layer = own.cells[1] * own.cells[2];
        for (int i = own.first_sphere; i < own.last_sphere; ++i) {
            const int c = sorted_cell_[static_cast<std::size_t>(i)];
            visit(i, Range{i + 1, start[c + fineness + 1]}, around(c + row));
            visit(i, around(c + layer - row), around(c + layer));
            visit(i, around(c + layer + row), Range{0, 0});
            for (std::size_t m = l + 1; m < levels_.size(); ++m) {
                const Level& coarser = levels_[m];
                const int width = coarser.cells[2], depth = coarser.cells[1] * coarser.cells[2];
                const int centre = coarser_cells_[static_cast<std::size_t>(i)][m];
                for (const int slow : {-depth, 0, depth}) {
                    visit(i, around(centre + slow - width), around(centre + slow));
                    visit(i, around(centre + slow + width), Range{0, 0});
                }
            }
        }
    }
}

}  // namespace interphase::hard_sphere
