// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>

#include <type_traits>
#include <vector>

namespace interphase::walls {

/// What each rank has, in the order of ranks. `Item`: doubles and nothing else. Collective.
template <class Item>
std::vector<Item> of_all_ranks(const std::vector<Item>& mine, MPI_Comm world)
{
    constexpr int numbers = sizeof(Item) / sizeof(double);
    static_assert(std::is_trivially_copyable_v<Item> && sizeof(Item) == numbers * sizeof(double));
    int count = numbers * static_cast<int>(mine.size()), ranks = 1;
    MPI_Comm_size(world, &ranks);
    std::vector<int> counts(static_cast<std::size_t>(ranks)), starts(static_cast<std::size_t>(ranks) + 1, 0);
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
    for (std::size_t r = 0; r < counts.size(); ++r)
        starts[r + 1] = starts[r] + counts[r];
    std::vector<Item> all(static_cast<std::size_t>(starts.back() / numbers));
    MPI_Allgatherv(mine.data(), count, MPI_DOUBLE, all.data(), counts.data(), starts.data(), MPI_DOUBLE, world);
    return all;
}

}  // namespace interphase::walls
