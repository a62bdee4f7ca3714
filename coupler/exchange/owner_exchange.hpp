// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "exchange/cell_locator.hpp"
#include "exchange/exchange_plan.hpp"

namespace interphase {

/// Takes particle data to the ranks that own the particles' gas cells, and answers back. Particles whose cell is on
/// their own rank send nothing.
class OwnerExchange {
public:
    explicit OwnerExchange(const Communicator& comm) : comm_(comm), exchange_(comm) {}

    /// Plans the visits of this rank's particles to `owner_cells` [n]; particles without one stay away. Collective.
    void plan(const std::vector<CellAddress>& owner_cells);

    /// The cell of each visitor on this rank [visitors()].
    const std::vector<int>& cells() const { return cells_; }
    std::size_t visitors() const { return cells_.size(); }

    /// This rank's particles that visit a cell, in the order in which their records travel.
    const std::vector<std::size_t>& order() const { return order_; }

    /// A message of records per travelling particle, in their order, to the hosts. Where nobody leaves its rank the two
    /// ends change places instead of being copied, so count on neither's content but the visitors'.
    void gather(const Message& message) const
    {
        if (exchange_.stays_home())
            message.swap_ends();
        else
            exchange_.forward(message);
    }

    /// Records per visitor back to the travellers; likewise.
    void scatter(const Message& message) const
    {
        if (exchange_.stays_home())
            message.swap_ends();
        else
            exchange_.backward(message);
    }

    std::size_t bytes_sent() const { return exchange_.bytes_sent(); }

private:
    Communicator comm_;
    ExchangePlan exchange_;
    std::vector<std::size_t> order_;
    std::vector<int> cells_;
};

}  // namespace interphase
