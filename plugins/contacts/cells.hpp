// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace interphase::contacts {

/// Points sorted into cubic cells, so that those near a place are found without looking at all of them.
class Cells {
public:
    /// `x`: [n][3], in metres. `reach`: the largest distance that near() has to cover [m], above 0.
    void sort(const double* const* x, int n, double reach);

    /// Calls visit(j) for every point j that is at most `reach` from the sorted point x, and for some farther ones.
    template <class Visit>
    void near(const double* x, const Visit& visit) const
    {
        int from[3], to[3];
        for (int k = 0; k < 3; ++k) {
            from[k] = std::max(index(x, k) - 1, 0);
            to[k] = std::min(index(x, k) + 1, cells_[k] - 1);
        }
        for (int c = from[2]; c <= to[2]; ++c)
            for (int b = from[1]; b <= to[1]; ++b)
                for (int p = start_[flat(from[0], b, c)]; p < start_[flat(to[0], b, c) + 1]; ++p)
                    visit(order_[static_cast<std::size_t>(p)]);
    }

private:
    int index(const double* x, int k) const
    {
        return std::min(static_cast<int>((x[k] - low_[k]) / width_), cells_[k] - 1);
    }
    std::size_t flat(int a, int b, int c) const
    {
        return static_cast<std::size_t>(a + cells_[0] * (b + cells_[1] * c));
    }
    std::size_t cell(const double* x) const { return flat(index(x, 0), index(x, 1), index(x, 2)); }

    double low_[3] = {0, 0, 0}, width_ = 1;
    int cells_[3] = {1, 1, 1};
    std::vector<int> start_, order_;
};

}  // namespace interphase::contacts
