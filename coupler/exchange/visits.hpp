// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "exchange/cell_locator.hpp"
#include "exchange/sparse_exchange.hpp"

namespace interphase {

/// Takes particle data to the ranks that own the particles' gas cells, and answers back. Particles whose cell is on
/// their own rank send nothing.
class Visits {
public:
    explicit Visits(const Communicator& comm) : comm_(comm), exchange_(comm) {}

    /// Plans the visits of this rank's particles to `homes` [n]; particles without a home stay away. Collective.
    void plan(const std::vector<CellAddress>& homes);

    /// The cell of each visitor on this rank [visitors()].
    const std::vector<int>& cells() const { return cells_; }
    std::size_t visitors() const { return cells_.size(); }

    /// This rank's particles that visit a cell, in the order in which their records travel.
    const std::vector<std::size_t>& order() const { return order_; }

    /// Records of `width` doubles per travelling particle, in their order, to the hosts. Where nobody leaves its rank
    /// the two change places instead of being copied, so count on neither's content but the visitors'.
    void bring(Scalars& of_travellers, int width, Scalars& of_visitors) const
    {
        if (exchange_.stays_home())
            of_visitors.swap(of_travellers);
        else
            exchange_.forward(of_travellers, width, of_visitors);
    }

    /// Records per visitor back to the travellers; likewise.
    void take_back(Scalars& of_visitors, int width, Scalars& of_travellers) const
    {
        if (exchange_.stays_home())
            of_travellers.swap(of_visitors);
        else
            exchange_.backward(of_visitors, width, of_travellers);
    }

    std::size_t doubles_sent() const { return exchange_.doubles_sent(); }

private:
    Communicator comm_;
    SparseExchange exchange_;
    std::vector<std::size_t> order_;
    std::vector<int> cells_;
};

}  // namespace interphase
