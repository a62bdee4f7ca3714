// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/cell_weights.hpp"

#include <algorithm>

namespace interphase {

void CellWeights::clear()
{
    for (const int joint : used_)
        number_[static_cast<std::size_t>(joint)] = unused;
    used_ = joints_.shared();
    for (std::size_t n = 0; n < used_.size(); ++n)
        number_[static_cast<std::size_t>(used_[n])] = static_cast<int>(n);
    particle_.clear();
    first_.assign(1, 0);
    entries_.clear();
}

void CellWeights::add(int joint, double weight)
{
    if (weight == 0) return;
    int& number = number_[static_cast<std::size_t>(joint)];
    if (number == unused) {
        number = static_cast<int>(used_.size());
        used_.push_back(joint);
    }
    entries_.push_back({static_cast<std::size_t>(number), weight});
}

void CellWeights::add_to_cell(std::size_t particle, int cell)
{
    add(joints_.of_cell(static_cast<std::size_t>(cell)), 1.0);
    particle_.push_back(particle);
    first_.push_back(entries_.size());
}

void CellWeights::add_spread(std::size_t particle, const Vector& position, int cell)
{
    const auto own = static_cast<std::size_t>(cell);
    const CellSubdivision::Place at = subdivision_.place(position, own);
    add(joints_.of_cell(own), at.in_cell);
    add(joints_.of_face(at.face), at.on_face);
    add(joints_.of_edge(at.face, at.edge), at.on_edge);
    add(joints_.of_corner(at.face, at.corner), at.on_corner);
    particle_.push_back(particle);
    first_.push_back(entries_.size());
}

double CellWeights::crowding(std::size_t index, int cell) const
{
    // The particle's joints, from the centre of its cell to a corner, have more and more cells, each joint all those of
    // the one before. Where they are alike, 1/(the own cell's share) is their number.
    double outer_weight = 0, outer_cells = 0, sum = 0;
    for (std::size_t k = first_[index + 1]; k-- > first_[index];) {
        const int joint = used_[entries_[k].joint];
        const auto* share = std::find_if(joints_.shares_begin(joint), joints_.shares_end(joint),
                                         [cell](const Joints::Share& s) { return s.cell == cell; });
        if (share == joints_.shares_end(joint)) continue;
        const double cells = 1 / share->part;
        sum += std::max(0.0, outer_cells - cells) * outer_weight * outer_weight;
        outer_cells = cells;
        outer_weight += entries_[k].weight * share->part;
    }
    return sum + outer_cells * outer_weight * outer_weight;
}

}  // namespace interphase
