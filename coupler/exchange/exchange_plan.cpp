// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/exchange_plan.hpp"

#include <algorithm>

namespace interphase {

void ExchangePlan::plan(const std::vector<int>& send_counts)
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

bool ExchangePlan::stays_home() const
{
    const auto home = [this](const Part& part) { return part.rank == comm_.rank(); };
    return std::all_of(send_.begin(), send_.end(), home) && std::all_of(receive_.begin(), receive_.end(), home);
}

namespace {

/// The place of a part of several blocks in memory, as one MPI type: no copy into a buffer.
class PartOfBlocks {
public:
    template <class Place>
    PartOfBlocks(const std::vector<Message::Block>& blocks, std::size_t count, const Place& place_of)
    {
        std::vector<int> lengths;
        std::vector<MPI_Aint> places;
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            lengths.push_back(static_cast<int>(count * blocks[b].size));
            places.emplace_back();
            MPI_Get_address(place_of(b), &places.back());
        }
        MPI_Type_create_hindexed(static_cast<int>(blocks.size()), lengths.data(), places.data(), MPI_BYTE, &type_);
        MPI_Type_commit(&type_);
    }
    ~PartOfBlocks() { MPI_Type_free(&type_); }
    PartOfBlocks(const PartOfBlocks&) = delete;
    PartOfBlocks& operator=(const PartOfBlocks&) = delete;

    MPI_Datatype type() const { return type_; }

private:
    MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

}  // namespace

void ExchangePlan::transfer(const Message& message, const std::vector<Part>& to, const std::vector<Part>& from,
                            std::size_t arriving) const
{
    constexpr int tag = 7301;
    const std::vector<Message::Block>& blocks = message.blocks();
    std::vector<Message::Ends> ends;
    for (const Message::Block& block : blocks)
        ends.push_back(block.make_ready(arriving));
    std::vector<MPI_Request> requests;
    requests.reserve(to.size() + from.size());

    for (const Part& part : from) {
        if (part.rank == comm_.rank()) continue;
        const PartOfBlocks arrivals(blocks, part.count,
                                    [&](std::size_t b) { return ends[b].in + part.first * blocks[b].size; });
        requests.emplace_back();
        MPI_Irecv(MPI_BOTTOM, 1, arrivals.type(), part.rank, tag, comm_.handle(), &requests.back());
    }
    for (const Part& part : to) {
        const auto place_of = [&](std::size_t b) { return ends[b].out + part.first * blocks[b].size; };
        if (part.rank == comm_.rank()) {
            const auto mine =
                std::find_if(from.begin(), from.end(), [&](const Part& p) { return p.rank == part.rank; });
            for (std::size_t b = 0; b < blocks.size(); ++b)
                std::copy_n(place_of(b), part.count * blocks[b].size, ends[b].in + mine->first * blocks[b].size);
            continue;
        }
        const PartOfBlocks departures(blocks, part.count, place_of);
        requests.emplace_back();
        MPI_Isend(MPI_BOTTOM, 1, departures.type(), part.rank, tag, comm_.handle(), &requests.back());
        for (const Message::Block& block : blocks)
            bytes_sent_ += part.count * block.size;
    }
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

}  // namespace interphase
