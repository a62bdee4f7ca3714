// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/batch_builder.hpp"

#include <algorithm>

namespace interphase::hard_sphere {

BatchPlace BatchBuilder::place(int i, int j, bool fixed_i, bool fixed_j)
{
    std::uint32_t &used_i = used_[static_cast<std::size_t>(i)], &used_j = used_[static_cast<std::size_t>(j)];
    const std::uint32_t taken = used_i | used_j;  // of fixed bodies never
    int slot;
    if (taken == all) {
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
    used_i |= fixed_i ? 0 : mark;
    used_j |= fixed_j ? 0 : mark;
    open.bodies[static_cast<std::size_t>(2 * place.lane)] = i;
    open.bodies[static_cast<std::size_t>(2 * place.lane + 1)] = j;
    if (open.filled == lanes) close(slot);
    return place;
}

void BatchBuilder::close(int slot)
{
    Open& open = open_[static_cast<std::size_t>(slot)];
    for (int k = 0; k < 2 * open.filled; ++k)
        used_[static_cast<std::size_t>(open.bodies[static_cast<std::size_t>(k)])] &= ~(std::uint32_t{1} << slot);
    open.filled = 0;
}

}  // namespace interphase::hard_sphere
