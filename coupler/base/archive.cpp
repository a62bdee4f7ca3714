// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/archive.hpp"

namespace interphase {

Archive Archive::loading(const Communicator& comm, int parts, std::map<int, State> mine)
{
    Archive archive;
    archive.loads_ = true;
    archive.comm_ = comm;
    archive.parts_ = parts;
    if (archive.same_ranks())
        archive.state_ = std::move(mine[comm.rank()]);
    else
        archive.others_ = std::move(mine);
    return archive;
}

bool Archive::has(const std::string& name) const
{
    if (same_ranks()) return state_.count(prefix_ + name) > 0;
    int there = comm_->is_master() && others_.at(0).count(prefix_ + name) > 0 ? 1 : 0;
    MPI_Bcast(&there, 1, MPI_INT, 0, comm_->handle());
    return there != 0;
}

void Archive::whole_in_pieces(int part, const std::string& whole_name, std::size_t most,
                              const std::function<void(const std::vector<char>&)>& take) const
{
    const int holder = part % comm_->size();
    const std::vector<char>* here = nullptr;
    if (holder == comm_->rank()) {
        const State& state = same_ranks() ? state_ : others_.at(part);
        const auto entry = state.find(whole_name);
        if (entry != state.end()) here = &entry->second;
    }
    long size = here ? static_cast<long>(here->size()) : -1;
    MPI_Bcast(&size, 1, MPI_LONG, holder, comm_->handle());
    if (size < 0) throw std::runtime_error("the saved state of rank " + std::to_string(part) + " has no " + whole_name);
    std::vector<char> piece;
    for (std::size_t done = 0; done < static_cast<std::size_t>(size); done += piece.size()) {
        piece.resize(std::min(most, static_cast<std::size_t>(size) - done));
        if (here) std::copy_n(here->data() + done, piece.size(), piece.data());
        MPI_Bcast(piece.data(), static_cast<int>(piece.size()), MPI_BYTE, holder, comm_->handle());
        take(piece);
    }
}

void Archive::part_in_pieces(int part, const std::string& name, std::size_t most,
                             const std::function<void(const std::vector<char>&)>& take) const
{
    whole_in_pieces(part, prefix_ + name, most, take);
}

std::vector<char> Archive::whole(int part, const std::string& whole_name) const
{
    constexpr std::size_t most = std::size_t{1} << 30;  // MPI counts in int
    std::vector<char> all;
    whole_in_pieces(part, whole_name, most,
                    [&all](const std::vector<char>& piece) { all.insert(all.end(), piece.begin(), piece.end()); });
    return all;
}

std::vector<char> Archive::alike(const std::string& name) const
{
    std::vector<char> first = part(0, name);
    bool differs = false;
    for (const auto& [rank, state] : others_) {
        const auto entry = state.find(prefix_ + name);
        differs = differs || entry == state.end() || entry->second != first;
    }
    if (comm_->any(differs))
        throw std::runtime_error(prefix_ + name + " differs from rank to rank, and can be given back to " +
                                 std::to_string(parts_) + " ranks only");
    return first;
}

}  // namespace interphase
