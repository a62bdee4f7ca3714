// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/cell_weights.hpp"

namespace interphase {

CellWeights::CellWeights(const Joints& joints, const CellSubdivision& subdivision, std::size_t cells)
    : joints_(joints),
      subdivision_(subdivision),
      cells_(cells),
      place_of_joint_(joints.count(), nowhere),
      entry_at_(cells + joints.shared().size(), nowhere)
{
    for (std::size_t n = 0; n < joints.shared().size(); ++n)
        place_of_joint_[static_cast<std::size_t>(joints.shared()[n])] = static_cast<int>(cells + n);
}

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
    const int place = place_of_joint_[static_cast<std::size_t>(joint)];
    if (place != nowhere) {
        make_room(1);
        add_at(place, weight);
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
    const int corner = joints_.of_corner(at.face, at.corner);
    const int edge = joints_.of_edge(at.face, at.edge), face = joints_.of_face(at.face);
    if (place_of_joint_[static_cast<std::size_t>(corner)] != nowhere) {
        make_room(1);
        add_at(cell, at.in_cell);
        add(face, at.on_face);
        add(edge, at.on_edge);
        add(corner, at.on_corner);
        end_particle(particle);
        return;
    }
    // The cells of a face are among those of its edge, these among those of its corner, all of them in ascending order.
    const Joints::Shares shares = joints_.shares(corner);
    make_room(shares.size());
    Entry* const begin = &entries_[used_];
    Entry* entry = begin;
    for (const Joints::Share& share : shares)
        *entry++ = {static_cast<std::size_t>(share.cell), share.part * at.on_corner};
    const auto add_to_these = [begin](const Joints::Shares& some, double weight) {
        Entry* to = begin;
        for (const Joints::Share& share : some) {
            while (to->place != static_cast<std::size_t>(share.cell))
                ++to;
            to->weight += share.part * weight;
        }
    };
    add_to_these(joints_.shares(edge), at.on_edge);
    add_to_these(joints_.shares(face), at.on_face);
    const Joints::Share own{cell, 1.0};
    add_to_these({&own, &own + 1}, at.in_cell);
    used_ += shares.size();
    particle_.push_back(particle);
    first_.push_back(used_);
}

}  // namespace interphase
