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
    cell_.clear();
    weight_.clear();
    for (std::size_t i = 0; i < own_cell.size(); ++i) {
        const Vector x(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
        double total = 0;
        const auto own = static_cast<std::size_t>(own_cell[i]);
        const auto [begin, end] = cells_.neighbours_near(own, x);
        for (const int* n = begin; n != end; ++n) {
            const auto c = static_cast<std::size_t>(*n);
            const Vector& centre = cells_.centre(c);
            const Vector& reach = cells_.reach(c);
            const double dx = std::abs(x[0] - centre[0]), dy = std::abs(x[1] - centre[1]),
                         dz = std::abs(x[2] - centre[2]);
            if (dx >= reach[0] || dy >= reach[1] || dz >= reach[2]) continue;
            const double weight = (1 - dx / reach[0]) * (1 - dy / reach[1]) * (1 - dz / reach[2]) * cells_.volume(c);
            cell_.push_back(*n);
            weight_.push_back(weight);
            total += weight;
        }
        if (total <= 0) {  // an oddly shaped cell whose box does not hold all of it
            cell_.push_back(own_cell[i]);
            weight_.push_back(total = 1.0);
        }
        for (std::size_t k = first_.back(); k < weight_.size(); ++k)
            weight_[k] /= total;
        first_.push_back(weight_.size());
    }
}

namespace {

/// Calls `body` with the width as a constant where it is one that the coupling uses, so that the inner loops unroll.
template <class Body>
void with_width(int width, Body&& body)
{
    switch (width) {
        case 1:
            return body(std::integral_constant<std::size_t, 1>{});
        case 4:
            return body(std::integral_constant<std::size_t, 4>{});
        case 6:
            return body(std::integral_constant<std::size_t, 6>{});
        case 7:
            return body(std::integral_constant<std::size_t, 7>{});
        case 9:
            return body(std::integral_constant<std::size_t, 9>{});
        case 10:
            return body(std::integral_constant<std::size_t, 10>{});
        case 11:
            return body(std::integral_constant<std::size_t, 11>{});
        default:
            return body(static_cast<std::size_t>(width));
    }
}

}  // namespace

void CellWeights::add_to_cells(const Scalars& of_particles, int width, Scalars& of_cells) const
{
    with_width(width, [&](const auto w) {
        for (std::size_t i = 0; i < particles(); ++i) {
            const double* q = &of_particles[i * w];
            for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
                double* cell = &of_cells[static_cast<std::size_t>(cell_[k]) * w];
                for (std::size_t m = 0; m < w; ++m)
                    cell[m] += weight_[k] * q[m];
            }
        }
    });
}

void CellWeights::at_particles(const Scalars& of_cells, int width, Scalars& of_particles) const
{
    of_particles.resize(particles() * static_cast<std::size_t>(width));
    with_width(width, [&](const auto w) {
        for (std::size_t i = 0; i < particles(); ++i) {
            double* q = &of_particles[i * w];
            for (std::size_t m = 0; m < w; ++m)
                q[m] = 0;
            for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
                const double weight = weight_[k];
                const double* cell = &of_cells[static_cast<std::size_t>(cell_[k]) * w];
                for (std::size_t m = 0; m < w; ++m)
                    q[m] += weight * cell[m];
            }
        }
    });
}

}  // namespace interphase
