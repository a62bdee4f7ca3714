// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "hard_sphere/bodies.hpp"
#include "hard_sphere/cell_grid.hpp"

namespace interphase::hard_sphere {

/// Places in Bodies of two spheres.
struct Pair {
    int i;
    int j : 31;
    unsigned touch : 1;  ///< they touch within the step, or all but do
};

/// `touches`: 0, 1, or 2 for more: the solver asks no more.
inline void count_touch(std::uint8_t& touches, unsigned touch)
{
    touches = static_cast<std::uint8_t>(touches + (touch & (touches < 2)));
}

/// Finds the pairs that come nearer than `margin` on their straight paths within a step.
class PairSearch {
public:
    /// `bodies`, with `coarse`, in the order of `grid`, whose reach was at least `margin` [m]. Nearer than `touching`
    /// [m] counts as a touch.
    void find(const Bodies& bodies, const CellGrid& grid, double step, double margin, double touching);

    /// Looks at the pairs found once more, as velocities have changed: drops those that no longer come so near.
    void look_again(const Bodies& bodies, double step, double margin, double touching);

    /// How many pairs touch each body, 2 standing for more [bodies and walls].
    const std::vector<std::uint8_t>& touches() const { return touches_; }

    const Pair* begin() const { return pairs_.data(); }
    const Pair* end() const { return pairs_.data() + used_; }

private:
    /// Spheres first, first + 1, ... of two ranges that come near i: a byte for each, 0 if it does not, 1 near, 3
    /// touching.
    struct Row {
        int i, first[2];
        std::uint64_t found[2];
    };

    void look_through(const Coarse& spheres, const CellGrid& grid, double step, double margin, double touching);
    void write_pairs();

    std::vector<Row> rows_;  ///< these and the pairs grow only
    std::size_t row_count_ = 0;
    std::vector<Pair> pairs_;
    std::size_t used_ = 0;
    std::vector<std::uint8_t> touches_;
};

}  // namespace interphase::hard_sphere
