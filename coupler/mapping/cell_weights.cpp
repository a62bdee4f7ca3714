// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/cell_weights.hpp"

#include <cmath>
#include <type_traits>

namespace interphase {

void CellWeights::place_in_own_cell(const std::vector<int>& own_cell)
{
    cell_ = own_cell;
    weight_.assign(own_cell.size(), 1.0);
    first_.resize(own_cell.size() + 1);
    for (std::size_t i = 0; i < first_.size(); ++i)
        first_[i] = i;
}

void CellWeights::spread_by_kernel(const Scalars& positions, const std::vector<int>& own_cell)
{
    first_.assign(1, 0);
    first_.reserve(own_cell.size() + 1);
    std::size_t used = 0;
    for (std::size_t i = 0; i < own_cell.size(); ++i) {
        const Vector x(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
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

namespace {

/// One record of `width` numbers; a width known to the compiler unrolls.
template <int width>
using Record = Eigen::Array<double, width, 1>;

/// Calls `body` with the width as a constant where it is one that the coupling uses.
template <class Body>
void with_width(int width, Body&& body)
{
    switch (width) {
        case 1:
            return body(std::integral_constant<int, 1>{});
        case 4:
            return body(std::integral_constant<int, 4>{});
        case 6:
            return body(std::integral_constant<int, 6>{});
        case 7:
            return body(std::integral_constant<int, 7>{});
        case 9:
            return body(std::integral_constant<int, 9>{});
        case 10:
            return body(std::integral_constant<int, 10>{});
        default:
            return body(std::integral_constant<int, Eigen::Dynamic>{});
    }
}

}  // namespace

void CellWeights::add_to_cells(const Scalars& of_particles, int width, Scalars& of_cells) const
{
    const auto w = static_cast<std::size_t>(width);
    with_width(width, [&](const auto fixed) {
        using Numbers = Record<decltype(fixed)::value>;
        for (std::size_t i = 0; i < particles(); ++i) {
            const Numbers q = Eigen::Map<const Numbers>(&of_particles[i * w], width);
            for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
                Eigen::Map<Numbers>(&of_cells[static_cast<std::size_t>(cell_[k]) * w], width) += weight_[k] * q;
        }
    });
}

void CellWeights::at_particles(const Scalars& of_cells, int width, Scalars& of_particles) const
{
    const auto w = static_cast<std::size_t>(width);
    of_particles.resize(particles() * w);
    with_width(width, [&](const auto fixed) {
        using Numbers = Record<decltype(fixed)::value>;
        for (std::size_t i = 0; i < particles(); ++i) {
            Numbers q = Numbers::Zero(width);
            for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
                q += weight_[k] * Eigen::Map<const Numbers>(&of_cells[static_cast<std::size_t>(cell_[k]) * w], width);
            Eigen::Map<Numbers>(&of_particles[i * w], width) = q;
        }
    });
}

}  // namespace interphase
