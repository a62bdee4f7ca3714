// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/cell_weights.hpp"

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

}  // namespace interphase
