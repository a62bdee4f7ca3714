// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/communicator.hpp"
#include "base/numbers.hpp"
#include "exchange/exchange_plan.hpp"
#include "mapping/cell_subdivision.hpp"

namespace interphase {

/// The vertices of the subdivided mesh and the cells that meet there: a cell's own centre, the two cells at a face, the
/// cells around an edge, those around a corner. Each joint stands for the linear function that is 1 there and 0 at the
/// others.
///
/// Cells meet where faces lead from one to the other about the joint: a wall or a baffle parts them, faces of processor
/// and cyclic patches do not. A cell's share of a joint is the integral of the joint's function over the cell, over that
/// over all its cells: then a density that is uniform gives every cell its own volume of it, and shares sum to one.
class Joints {
public:
    /// Collective; the mesh must not change afterwards.
    Joints(const Communicator& comm, const MeshView& mesh, const CellSubdivision& subdivision);

    int of_cell(std::size_t cell) const { return static_cast<int>(cell); }
    int of_face(int face) const { return of_face_[static_cast<std::size_t>(face)]; }
    int of_edge(int face, int edge) const { return of_edge_[corner_slot(face, edge)]; }
    int of_corner(int face, int corner) const { return of_corner_[corner_slot(face, corner)]; }

    /// Joints of this rank's cells. Those shared with other ranks have the numbers of shared().
    std::size_t count() const { return first_share_.size() - 1; }
    const std::vector<int>& shared() const { return shared_; }

    struct Share {
        int cell;  ///< of this rank
        double part;
    };
    class Shares {
    public:
        Shares(const Share* begin, const Share* end) : begin_(begin), end_(end) {}
        const Share* begin() const { return begin_; }
        const Share* end() const { return end_; }
        std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }

    private:
        const Share *begin_, *end_;
    };
    /// Of the cells of this rank at a joint.
    Shares shares(int joint) const
    {
        const auto j = static_cast<std::size_t>(joint);
        return {shares_.data() + first_share_[j], shares_.data() + first_share_[j + 1]};
    }

    /// Replaces the values of the shared joints, `values[i]` that of shared()[i], by their sums over the ranks that share
    /// each. Others stay as they are. Collective.
    template <class Record>
    void sum_shared(std::vector<Record>& values) const
    {
        if (comm_.size() == 1) return;
        const std::vector<Record> parts =
            to_home_.forward(std::vector<Record>(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(shared_.size())));
        std::vector<Record> sums(homes_, Record{});
        for (std::size_t i = 0; i < parts.size(); ++i)
            numbers(sums[home_of_part_[i]]) += numbers(parts[i]);
        std::vector<Record> answers(parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i)
            answers[i] = sums[home_of_part_[i]];
        const std::vector<Record> whole = to_home_.backward(std::move(answers));
        std::copy(whole.begin(), whole.end(), values.begin());
    }

    std::size_t bytes_sent() const { return to_home_.bytes_sent(); }

private:
    std::size_t corner_slot(int face, int k) const
    {
        return first_corner_[static_cast<std::size_t>(face)] + static_cast<std::size_t>(k);
    }
    void plan_sums(const std::vector<std::int64_t>& labels, const std::vector<std::int64_t>& first_of_rank);
    void find_shares(const CellSubdivision& subdivision, std::size_t cells);

    Communicator comm_;
    std::vector<std::size_t> first_corner_;  ///< of each face
    std::vector<int> of_face_, of_edge_, of_corner_;
    std::vector<std::size_t> first_share_;
    std::vector<Share> shares_;

    std::vector<int> shared_;  ///< ordered by home rank, and there by label
    ExchangePlan to_home_;     ///< from the ranks that share joints to one that sums them
    std::size_t homes_ = 0;
    std::vector<std::size_t> home_of_part_;
};

}  // namespace interphase
