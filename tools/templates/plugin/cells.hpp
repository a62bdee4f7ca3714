// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

/// Points sorted into cubic cells, so that those near a place are found without looking at all of them.
class Cells {
public:
    /// `x`: [n][3]. `reach`: the largest distance that near() has to cover; above 0.
    void sort(const double* const* x, int n, double reach)
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
        for (std::size_t c = 1; c < start_.size(); ++c)
            start_[c] += start_[c - 1];
        std::vector<int> next(start_.begin(), start_.end() - 1);
        for (int i = 0; i < n; ++i)
            order_[static_cast<std::size_t>(next[cell(x[i])]++)] = i;
    }

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
