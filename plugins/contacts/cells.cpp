// SPDX-License-Identifier: GPL-3.0-or-later
#include "contacts/cells.hpp"

#include <numeric>

namespace interphase::contacts {

void Cells::sort(const double* const* x, int n, double reach)
{
    order_.resize(static_cast<std::size_t>(n));
    if (n == 0) return;
    double high[3];
    for (int k = 0; k < 3; ++k) {
        low_[k] = high[k] = x[0][k];
        for (int i = 1; i < n; ++i) {
            low_[k] = std::min(low_[k], x[i][k]);
            high[k] = std::max(high[k], x[i][k]);
        }
    }
    width_ = reach;
    double count = 0;
    for (;; width_ *= 2) {  // a few points far apart must not ask for millions of empty cells
        count = 1;
        for (int k = 0; k < 3; ++k)
            count *= (high[k] - low_[k]) / width_ + 1;
        if (count <= 8.0 * n + 64) break;
    }
    for (int k = 0; k < 3; ++k)
        cells_[k] = static_cast<int>((high[k] - low_[k]) / width_) + 1;

    // counting sort: start_[c] is where the points of cell c begin in order_
    start_.assign(static_cast<std::size_t>(cells_[0] * cells_[1] * cells_[2]) + 1, 0);
    for (int i = 0; i < n; ++i)
        ++start_[cell(x[i]) + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (int i = 0; i < n; ++i)
        order_[static_cast<std::size_t>(next[cell(x[i])]++)] = i;
}

}  // namespace interphase::contacts
