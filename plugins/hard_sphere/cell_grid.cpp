// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace interphase::hard_sphere {

std::vector<CellGrid::Level> CellGrid::choose_levels(const double* centres, const double* radii, std::size_t count,
                                                     double reach, int slowest)
{
    std::array<double, 3> low, high;
    low.fill(1e300);
    high.fill(-1e300);
    double smallest = 1e300, largest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], centres[3 * i + axis]);
            high[axis] = std::max(high[axis], centres[3 * i + axis]);
        }
        smallest = std::min(smallest, radii[i]);
        largest = std::max(largest, radii[i]);
    }
    low_ = low;
    high_ = high;
    const auto extent = [&](int axis) {
        return high[static_cast<std::size_t>(axis)] - low[static_cast<std::size_t>(axis)];
    };
    axes_ = {slowest, (slowest + 1) % 3, (slowest + 2) % 3};
    if (extent(axes_[1]) < extent(axes_[2])) std::swap(axes_[1], axes_[2]);

    std::vector<Level> levels;
    // a few wide cells serve scattered spheres better than millions of empty ones
    const double most_cells = 8.0 * fineness * static_cast<double>(count) + 1000;
    const double widest = 2 * largest + reach;
    for (double size = 2 * smallest + reach;; size *= 2) {
        const bool last = size >= widest * (1 - 1e-12) || levels.size() + 1 == most_levels;
        if (last) size = std::max(size, widest);
        Level level{};
        for (;; size *= 1.26) {
            double cells = 1;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto axis = static_cast<std::size_t>(axes_[k]);
                level.corner[k] = low[axis] - size;
                const double width = k == 2 ? size / fineness : size;
                const double across = std::floor((high[axis] - low[axis]) / width) + (k == 2 ? 1 + 2 * fineness : 3);
                level.inverse_size[k] = 1 / width;
                cells *= across;
                level.cells[k] = static_cast<int>(std::min(across, 1e6));
            }
            if (cells <= most_cells) break;
        }
        levels.push_back(level);
        if (last) break;
    }
    return levels;
}

int CellGrid::cell_at(const Level& level, const double* centre) const
{
    int at[3];
    for (std::size_t k = 0; k < 3; ++k)
        at[k] = static_cast<int>((centre[axes_[k]] - level.corner[k]) * level.inverse_size[k]);
    return level.first_cell + (at[0] * level.cells[1] + at[1]) * level.cells[2] + at[2];
}

void CellGrid::sort(const double* centres, const double* radii, std::size_t count, double reach, int slowest)
{
    levels_ = choose_levels(centres, radii, count, reach, slowest);
    int cells = 0;
    for (Level& level : levels_) {
        level.first_cell = cells;
        cells += level.cells[0] * level.cells[1] * level.cells[2];
    }

    cell_of_.resize(count);
    level_of_.assign(count, 0);
    start_.assign(static_cast<std::size_t>(cells) + 2, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const double diameter = 2 * radii[i] + reach;
        std::size_t l = 0;
        while (l + 1 < levels_.size() && diameter * levels_[l].inverse_size[0] > 1 + 1e-12)
            ++l;
        level_of_[i] = static_cast<signed char>(l);
        cell_of_[i] = cell_at(levels_[l], centres + 3 * i);
        ++start_[static_cast<std::size_t>(cell_of_[i]) + 1];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    for (Level& level : levels_) {
        level.first_sphere = start_[static_cast<std::size_t>(level.first_cell)];
        const int beyond = level.first_cell + level.cells[0] * level.cells[1] * level.cells[2];
        level.last_sphere = start_[static_cast<std::size_t>(beyond)];
    }

    order_.resize(count);
    sorted_cell_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const int k = start_[static_cast<std::size_t>(cell_of_[i])]++;
        order_[static_cast<std::size_t>(k)] = static_cast<int>(i);
        sorted_cell_[static_cast<std::size_t>(k)] = cell_of_[i];
    }
    // filling has moved every start to the next cell's
    std::rotate(start_.begin(), start_.end() - 1, start_.end());
    start_[0] = 0;

    if (levels_.size() == 1) return;
    coarser_cells_.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
        const auto i = static_cast<std::size_t>(order_[k]);
        for (std::size_t m = static_cast<std::size_t>(level_of_[i]) + 1; m < levels_.size(); ++m)
            coarser_cells_[k][m] = cell_at(levels_[m], centres + 3 * i);
    }
}

}  // namespace interphase::hard_sphere
