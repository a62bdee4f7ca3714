// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/batch_builder.hpp"

#include <algorithm>

namespace interphase::hard_sphere {

BatchPlace BatchBuilder::place(int i, int j, bool fixed_i, bool fixed_j)
{
    std::uint32_t taken = 0;
    if (!fixed_i) taken |= used_[static_cast<std::size_t>(i)];
    if (!fixed_j) taken |= used_[static_cast<std::size_t>(j)];
    int slot;
    if (~taken == 0) {
        slot = static_cast<int>(std::max_element(open_.begin(), open_.end(),
                                                 [](const Open& a, const Open& b) { return a.filled < b.filled; }) -
                                open_.begin());
        close(slot);
    } else {
        slot = __builtin_ctz(~taken);
    }

    Open& open = open_[static_cast<std::size_t>(slot)];
    if (open.filled == 0) open.batch = count_++;
    const BatchPlace place{open.batch, open.filled++};
    const std::uint32_t mark = std::uint32_t{1} << slot;
    const auto use = [&](int body) {
        used_[static_cast<std::size_t>(body)] |= mark;
        open.bodies[static_cast<std::size_t>(open.marked++)] = body;
    };
    if (!fixed_i) use(i);
    if (!fixed_j) use(j);
    if (open.filled == lanes) close(slot);
    return place;
}

void BatchBuilder::close(int slot)
{
    Open& open = open_[static_cast<std::size_t>(slot)];
    for (int k = 0; k < open.marked; ++k)
        used_[static_cast<std::size_t>(open.bodies[static_cast<std::size_t>(k)])] &= ~(std::uint32_t{1} << slot);
    open = {};
}

}  // namespace interphase::hard_sphere
