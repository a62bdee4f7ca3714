// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/owner_exchange.hpp"

#include <utility>

namespace interphase {

void OwnerExchange::plan(const std::vector<CellAddress>& owner_cells)
{
    std::vector<int> counts(static_cast<std::size_t>(comm_.size()), 0);
    for (const CellAddress& owner : owner_cells)
        if (owner.known()) ++counts[static_cast<std::size_t>(owner.rank)];

    std::vector<std::size_t> next(counts.size(), 0);
    for (std::size_t rank = 1; rank < counts.size(); ++rank)
        next[rank] = next[rank - 1] + static_cast<std::size_t>(counts[rank - 1]);
    order_.resize(next.back() + static_cast<std::size_t>(counts.back()));
    std::vector<int> cells_to_visit(order_.size());
    for (std::size_t i = 0; i < owner_cells.size(); ++i) {
        if (!owner_cells[i].known()) continue;
        const std::size_t place = next[static_cast<std::size_t>(owner_cells[i].rank)]++;
        order_[place] = i;
        cells_to_visit[place] = owner_cells[i].cell;
    }
    exchange_.plan(counts);
    cells_ = exchange_.forward(std::move(cells_to_visit));
}

}  // namespace interphase
