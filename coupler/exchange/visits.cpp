// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/visits.hpp"

#include <algorithm>

namespace interphase {

void Visits::plan(const std::vector<CellAddress>& homes)
{
    particles_ = homes.size();
    std::vector<int> counts(static_cast<std::size_t>(comm_.size()), 0);
    for (const CellAddress& home : homes)
        if (home.known()) ++counts[static_cast<std::size_t>(home.rank)];

    std::vector<std::size_t> next(counts.size(), 0);
    for (std::size_t rank = 1; rank < counts.size(); ++rank)
        next[rank] = next[rank - 1] + static_cast<std::size_t>(counts[rank - 1]);
    order_.resize(next.back() + static_cast<std::size_t>(counts.back()));
    Scalars cell_numbers(order_.size());
    for (std::size_t i = 0; i < homes.size(); ++i) {
        if (!homes[i].known()) continue;
        const std::size_t place = next[static_cast<std::size_t>(homes[i].rank)]++;
        order_[place] = i;
        cell_numbers[place] = homes[i].cell;
    }
    exchange_.plan(counts);
    const Scalars arrived = exchange_.forward(cell_numbers, 1);
    cells_.resize(arrived.size());
    std::transform(arrived.begin(), arrived.end(), cells_.begin(), [](double c) { return static_cast<int>(c); });
}

void Visits::bring(const Scalars& of_particles, int width, Scalars& of_visitors)
{
    const auto w = static_cast<std::size_t>(width);
    buffer_.resize(order_.size() * w);
    for (std::size_t place = 0; place < order_.size(); ++place)
        std::copy_n(&of_particles[order_[place] * w], w, &buffer_[place * w]);
    exchange_.forward(buffer_, width, of_visitors);
}

void Visits::take_back(const Scalars& of_visitors, int width, Scalars& of_particles)
{
    const auto w = static_cast<std::size_t>(width);
    exchange_.backward(of_visitors, width, buffer_);
    of_particles.resize(particles_ * w);
    if (order_.size() < particles_) std::fill(of_particles.begin(), of_particles.end(), 0.0);
    for (std::size_t place = 0; place < order_.size(); ++place)
        std::copy_n(&buffer_[place * w], w, &of_particles[order_[place] * w]);
}

}  // namespace interphase
