// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/home_search.hpp"

#include <utility>

#include "exchange/sparse_exchange.hpp"

namespace interphase {

namespace {

/// A walk that passes from rank to rank more often than this has lost its way; the particle is searched for instead.
constexpr int most_hand_overs = 8;

/// Is the particle at this position in your cell, or near it? The answer is a CellAddress.
struct WalkQuestion {
    double position[3];
    int start;  ///< the asked rank's cell
};

/// Is it anywhere in your part of the mesh?
struct SearchQuestion {
    double position[3];
};

}  // namespace

HomeSearch::HomeSearch(const Communicator& comm, const CellLocator& locator) : comm_(comm), locator_(locator)
{
    const Box mine = locator_.bounds();
    const Scalars all = comm_.all_gather(Scalars(mine.data(), mine.data() + mine.size()));
    for (int rank = 0; rank < comm_.size(); ++rank)
        bounds_.emplace_back(Eigen::Map<const Box>(all.data() + rank * mine.size()));
}

void HomeSearch::update(const VectorsView& positions, std::vector<CellAddress>& homes)
{
    const Slots lost = walk_from_last_homes(positions, homes);
    if (comm_.any(!lost.empty())) search_everywhere(positions, lost, homes);
}

CellAddress HomeSearch::walk_or_search(const Vector& point, int start) const
{
    const CellAddress address = locator_.walk(point, start);
    return address.known() ? address : locator_.search(point);
}

HomeSearch::Slots HomeSearch::walk_from_last_homes(const VectorsView& positions, std::vector<CellAddress>& homes)
{
    const int me = comm_.rank();
    Slots lost;
    std::vector<Slots> asked(static_cast<std::size_t>(comm_.size()));

    const auto settle = [&](std::size_t slot, const CellAddress& address) {
        homes[slot] = address;
        if (!address.known())
            lost.push_back(slot);
        else if (address.rank != me)
            asked[static_cast<std::size_t>(address.rank)].push_back(slot);
    };
    for (std::size_t slot = 0; slot < homes.size(); ++slot) {
        const CellAddress home = homes[slot];
        settle(slot, home.known() && home.rank == me
                         ? walk_or_search(positions.col(static_cast<Eigen::Index>(slot)), home.cell)
                         : home);
    }
    if (comm_.size() == 1) return lost;

    SparseExchange exchange(comm_);
    for (int round = 0;; ++round) {
        std::vector<int> counts;
        std::vector<WalkQuestion> questions;
        Slots order;
        for (Slots& slots : asked) {
            counts.push_back(static_cast<int>(slots.size()));
            for (const std::size_t slot : slots) {
                questions.emplace_back();
                set(questions.back().position, positions.col(static_cast<Eigen::Index>(slot)));
                questions.back().start = homes[slot].cell;
                order.push_back(slot);
            }
            slots.clear();
        }
        if (!comm_.any(!order.empty())) break;

        exchange.plan(counts);
        std::vector<CellAddress> answers;
        for (const WalkQuestion& asked_here : exchange.forward(std::move(questions)))
            answers.push_back(walk_or_search(to_vector(asked_here.position), asked_here.start));
        const std::vector<CellAddress> found = exchange.backward(std::move(answers));
        for (std::size_t i = 0; i < order.size(); ++i) {
            const CellAddress asked_for = homes[order[i]], address = found[i];
            if (address.known() && address.rank == asked_for.rank)
                homes[order[i]] = address;  // that rank has it
            else if (address.known() && address.rank == me)
                settle(order[i], walk_or_search(positions.col(static_cast<Eigen::Index>(order[i])), address.cell));
            else
                settle(order[i], round < most_hand_overs ? address : CellAddress{});
        }
    }
    bytes_sent_ += exchange.bytes_sent();
    return lost;
}

void HomeSearch::search_everywhere(const VectorsView& positions, const Slots& lost, std::vector<CellAddress>& homes)
{
    std::vector<int> counts;
    std::vector<SearchQuestion> questions;
    Slots order;
    for (int rank = 0; rank < comm_.size(); ++rank) {
        const std::size_t before = order.size();
        for (const std::size_t slot : lost) {
            const Vector x = positions.col(static_cast<Eigen::Index>(slot));
            if (!contains(bounds_[static_cast<std::size_t>(rank)], x)) continue;
            questions.emplace_back();
            set(questions.back().position, x);
            order.push_back(slot);
        }
        counts.push_back(static_cast<int>(order.size() - before));
    }
    SparseExchange exchange(comm_);
    exchange.plan(counts);
    std::vector<CellAddress> answers;
    for (const SearchQuestion& asked_here : exchange.forward(std::move(questions)))
        answers.push_back(locator_.search(to_vector(asked_here.position)));
    const std::vector<CellAddress> found = exchange.backward(std::move(answers));
    for (const std::size_t slot : lost)
        homes[slot] = CellAddress{};
    for (std::size_t i = 0; i < order.size(); ++i) {  // of several, the lowest rank's cell
        CellAddress& home = homes[order[i]];
        if (!home.known()) home = found[i];
    }
    bytes_sent_ += exchange.bytes_sent();
}

}  // namespace interphase
