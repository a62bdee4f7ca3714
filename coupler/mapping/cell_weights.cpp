// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/cell_weights.hpp"

namespace interphase {

CellWeights::CellWeights(const Joints& joints, const CellSubdivision& subdivision, const CornerCells& corner_cells,
                         std::size_t cells)
    : joints_(joints),
      subdivision_(subdivision),
      corner_cells_(corner_cells),
      cells_(cells),
      entry_at_(cells + joints.shared().size(), nowhere)
{}

void CellWeights::clear()
{
    particle_.clear();
    first_.assign(1, 0);
    used_ = 0;
}

void CellWeights::make_room(std::size_t entries)
{
    if (used_ + entries > entries_.size()) entries_.resize(2 * (used_ + entries));
}

void CellWeights::add_at(int place, double weight)
{
    int& entry = entry_at_[static_cast<std::size_t>(place)];
    if (entry == nowhere) {
        entry = static_cast<int>(used_ - first_.back());
        entries_[used_++] = {static_cast<std::size_t>(place), weight};
    } else
        entries_[first_.back() + static_cast<std::size_t>(entry)].weight += weight;
}

void CellWeights::add(int joint, double weight)
{
    if (weight == 0) return;
    const int shared = joints_.place_in_shared(joint);
    if (shared >= 0) {
        make_room(1);
        add_at(static_cast<int>(cells_) + shared, weight);
        return;
    }
    const auto shares = joints_.shares(joint);
    make_room(shares.size());
    for (const Joints::Share& share : shares)
        add_at(share.cell, share.part * weight);
}

void CellWeights::end_particle(std::size_t particle)
{
    for (std::size_t k = first_.back(); k < used_; ++k)
        entry_at_[entries_[k].place] = nowhere;
    particle_.push_back(particle);
    first_.push_back(used_);
}

void CellWeights::add_to_cell(std::size_t particle, int cell)
{
    make_room(1);
    add_at(cell, 1.0);
    end_particle(particle);
}

void CellWeights::add_spread(std::size_t particle, const Vector& position, int cell)
{
    const CellSubdivision::Place at = subdivision_.place(position, static_cast<std::size_t>(cell));
    const CornerCells::Cells& cells = corner_cells_.at(at.corner);
    if (cells.is_even()) {
        // each joint's function in equal parts to its cells, two, four or eight: the products again, of halves
        make_room(8);
        std::array<double, 3> over;
        for (std::size_t axis = 0; axis < 3; ++axis)
            over[axis] = 0.5 * cells.open[axis] * at.smoothed[axis];
        for (unsigned bits = 0; bits < 8; ++bits) {
            entries_[used_] = {static_cast<std::size_t>(cells.cell[bits]), (bits & 1 ? over[0] : 1 - over[0]) *
                                                                               (bits & 2 ? over[1] : 1 - over[1]) *
                                                                               (bits & 4 ? over[2] : 1 - over[2])};
            used_ += cells.cell[bits] >= 0;
        }
        particle_.push_back(particle);
        first_.push_back(used_);
        return;
    }
    add_joints(at, 1.0);
    end_particle(particle);
}

void CellWeights::add_point(const Vector& position, int cell, double share)
{
    add_joints(subdivision_.place(position, static_cast<std::size_t>(cell)), share);
}

void CellWeights::add_joints(const CellSubdivision::Place& at, double share)
{
    const CellSubdivision::Corner& corner = subdivision_.corner(at.corner);
    const std::array<double, 8> functions = at.functions();
    for (std::size_t n = 0; n < 8; ++n)
        if (corner[n] >= 0) add(corner[n], share * functions[n]);
}

}  // namespace interphase
