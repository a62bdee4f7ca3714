// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/cell_weights.hpp"

#include <cmath>

namespace interphase {

void CellWeights::place_in_own_cell(const std::vector<int>& own_cell)
{
    cell_ = own_cell;
    weight_.assign(own_cell.size(), 1.0);
    first_.resize(own_cell.size() + 1);
    for (std::size_t i = 0; i < first_.size(); ++i)
        first_[i] = i;
}

void CellWeights::spread_by_kernel(const Vectors& positions, const std::vector<int>& own_cell)
{
    first_.assign(1, 0);
    first_.reserve(own_cell.size() + 1);
    std::size_t used = 0;
    for (std::size_t i = 0; i < own_cell.size(); ++i) {
        const Vector& x = positions[i];
        double total = 0;
        const auto own = static_cast<std::size_t>(own_cell[i]);
        const auto [begin, end] = cells_.neighbours_near(own, x);
        const std::size_t most = used + static_cast<std::size_t>(end - begin) + 1;
        if (most > cell_.size()) {
            cell_.resize(2 * most);
            weight_.resize(2 * most);
        }
        for (const int* n = begin; n != end; ++n) {
            const auto c = static_cast<std::size_t>(*n);
            const Vector& centre = cells_.centre(c);
            const Vector& reach = cells_.reach(c);
            const double dx = std::abs(x[0] - centre[0]), dy = std::abs(x[1] - centre[1]),
                         dz = std::abs(x[2] - centre[2]);
            if (dx >= reach[0] || dy >= reach[1] || dz >= reach[2]) continue;
            const double weight = (1 - dx / reach[0]) * (1 - dy / reach[1]) * (1 - dz / reach[2]) * cells_.volume(c);
            cell_[used] = *n;
            weight_[used++] = weight;
            total += weight;
        }
        if (total <= 0) {  // an oddly shaped cell whose box does not hold all of it
            cell_[used] = own_cell[i];
            weight_[used++] = total = 1.0;
        }
        for (std::size_t k = first_.back(); k < used; ++k)
            weight_[k] /= total;
        first_.push_back(used);
    }
}

}  // namespace interphase
