// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/moved_cells.hpp"

#include <stdexcept>
#include <string>
#include <unordered_map>

namespace interphase {

void move_addresses(const Communicator& comm, const Archive& archive, std::vector<CellAddress>& addresses)
{
    const Archive::CellMoves& moves = *archive.moved_cells();
    std::unordered_map<int, std::vector<std::size_t>> wanted;  // number of the cell -> who looks for it
    for (int part = 0; part < archive.parts(); ++part) {
        const std::vector<int> numbers = archive.cell_numbers(part);
        for (std::size_t i = 0; i < addresses.size(); ++i)
            if (addresses[i].known() && addresses[i].rank == part)
                wanted[numbers.at(static_cast<std::size_t>(addresses[i].cell))].push_back(i);
    }
    for (int rank = 0; rank < comm.size(); ++rank) {
        auto count = static_cast<int>(moves.own.size());
        MPI_Bcast(&count, 1, MPI_INT, rank, comm.handle());
        std::vector<int> numbers = moves.own;
        numbers.resize(static_cast<std::size_t>(count));
        MPI_Bcast(numbers.data(), count, MPI_INT, rank, comm.handle());
        for (int cell = 0; cell < count && !wanted.empty(); ++cell) {
            const auto found = wanted.find(numbers[static_cast<std::size_t>(cell)]);
            if (found == wanted.end()) continue;
            for (const std::size_t i : found->second)
                addresses[i] = {rank, cell};
            wanted.erase(found);
        }
    }
    if (comm.any(!wanted.empty())) throw std::runtime_error("particles of a saved state are in cells that no rank has");
}

}  // namespace interphase
