// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "base/communicator.hpp"
#include "base/numbers.hpp"
#include "exchange/exchange_plan.hpp"
#include "mapping/cell_subdivision.hpp"
#include "mapping/joint_numbering.hpp"

namespace interphase {

/// The cells that meet at each joint, and their shares of it: a cell's share is the integral of the joint's function
/// over the cell, over that over all its cells. So shares sum to one, and a density that is uniform gives every cell
/// its own volume of it.
class Joints {
public:
    /// Collective; the mesh must not change afterwards.
    Joints(const Communicator& comm, const JointNumbering& numbering, const CellSubdivision& subdivision,
           std::size_t cells);

    std::size_t count() const { return first_share_.size() - 1; }
    /// Those that other ranks may know, too.
    const std::vector<int>& shared() const { return shared_; }
    /// The joint's place in shared(), or -1.
    int place_in_shared(int joint) const { return place_in_shared_[static_cast<std::size_t>(joint)]; }

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
    /// Of the cells of this rank at a joint, by ascending number.
    Shares shares(int joint) const
    {
        const auto j = static_cast<std::size_t>(joint);
        return {shares_.data() + first_share_[j], shares_.data() + first_share_[j + 1]};
    }

    /// Replaces the values of the shared joints, `values[i]` that of shared()[i], by their sums over the ranks that
    /// share each. Collective.
    template <class Record>
    void sum_shared(std::vector<Record>& values) const
    {
        if (comm_.size() == 1) return;
        const std::vector<Record> parts = to_home_.forward(std::move(values));
        std::vector<Record> sums(homes_, Record{});
        for (std::size_t i = 0; i < parts.size(); ++i)
            numbers(sums[home_of_part_[i]]) += numbers(parts[i]);
        std::vector<Record> answers(parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i)
            answers[i] = sums[home_of_part_[i]];
        values = to_home_.backward(std::move(answers));
    }

    std::size_t bytes_sent() const { return to_home_.bytes_sent(); }

private:
    void plan_sums(const JointNumbering& numbering);
    void find_shares(const CellSubdivision& subdivision, std::size_t cells);

    Communicator comm_;
    std::vector<std::size_t> first_share_;
    std::vector<Share> shares_;

    std::vector<int> place_in_shared_;  ///< of each joint
    std::vector<int> shared_;           ///< ordered by the rank of their home
    ExchangePlan to_home_;              ///< from the ranks that share joints to one that sums them
    std::size_t homes_ = 0;
    std::vector<std::size_t> home_of_part_;
};

}  // namespace interphase
