// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/sparse_exchange.hpp"

#include <algorithm>

namespace interphase {

void SparseExchange::plan(const std::vector<int>& send_counts)
{
    std::vector<int> receive_counts(send_counts);
    if (comm_.size() > 1)
        MPI_Alltoall(send_counts.data(), 1, MPI_INT, receive_counts.data(), 1, MPI_INT, comm_.handle());

    const auto parts = [](const std::vector<int>& counts, std::size_t& total) {
        std::vector<Part> result;
        total = 0;
        for (std::size_t rank = 0; rank < counts.size(); ++rank) {
            if (counts[rank] == 0) continue;
            const auto count = static_cast<std::size_t>(counts[rank]);
            result.push_back({static_cast<int>(rank), total, count});
            total += count;
        }
        return result;
    };
    send_ = parts(send_counts, sent_);
    receive_ = parts(receive_counts, received_);
}

bool SparseExchange::stays_home() const
{
    const auto home = [this](const Part& part) { return part.rank == comm_.rank(); };
    return std::all_of(send_.begin(), send_.end(), home) && std::all_of(receive_.begin(), receive_.end(), home);
}

void SparseExchange::transfer(const Scalars& out, int width, const std::vector<Part>& to, const std::vector<Part>& from,
                              std::size_t arriving, Scalars& in) const
{
    constexpr int tag = 7301;
    const auto w = static_cast<std::size_t>(width);
    in.resize(arriving * w);
    std::vector<MPI_Request> requests;
    requests.reserve(to.size() + from.size());

    for (const Part& part : from) {
        if (part.rank == comm_.rank()) continue;
        requests.emplace_back();
        MPI_Irecv(in.data() + part.first * w, static_cast<int>(part.count * w), MPI_DOUBLE, part.rank, tag,
                  comm_.handle(), &requests.back());
    }
    for (const Part& part : to) {
        const double* first = out.data() + part.first * w;
        if (part.rank == comm_.rank()) {
            const auto mine =
                std::find_if(from.begin(), from.end(), [&](const Part& p) { return p.rank == part.rank; });
            std::copy(first, first + part.count * w, in.data() + mine->first * w);
            continue;
        }
        requests.emplace_back();
        MPI_Isend(first, static_cast<int>(part.count * w), MPI_DOUBLE, part.rank, tag, comm_.handle(),
                  &requests.back());
        doubles_sent_ += part.count * w;
    }
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

}  // namespace interphase
