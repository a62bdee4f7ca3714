// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/home_search.hpp"

#include "exchange/sparse_exchange.hpp"

namespace interphase {

namespace {

/// A walk that passes from rank to rank more often than this has lost its way; the particle is searched for instead.
constexpr int most_hand_overs = 8;

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
        Scalars questions;
        Slots order;
        for (Slots& slots : asked) {
            counts.push_back(static_cast<int>(slots.size()));
            for (const std::size_t slot : slots) {
                const Vector x = positions.col(static_cast<Eigen::Index>(slot));
                questions.insert(questions.end(), {x.x(), x.y(), x.z(), static_cast<double>(homes[slot].cell)});
                order.push_back(slot);
            }
            slots.clear();
        }
        if (!comm_.any(!order.empty())) break;

        exchange.plan(counts);
        const Scalars arrived = exchange.forward(questions, 4);
        Scalars answers;
        answers.reserve(exchange.received() * 2);
        for (std::size_t i = 0; i < exchange.received(); ++i) {
            const double* q = &arrived[4 * i];
            const CellAddress address = walk_or_search({q[0], q[1], q[2]}, static_cast<int>(q[3]));
            answers.insert(answers.end(), {static_cast<double>(address.rank), static_cast<double>(address.cell)});
        }
        const Scalars found = exchange.backward(answers, 2);
        for (std::size_t i = 0; i < order.size(); ++i) {
            const CellAddress asked_for = homes[order[i]];
            const CellAddress address{static_cast<int>(found[2 * i]), static_cast<int>(found[2 * i + 1])};
            if (address.known() && address.rank == asked_for.rank)
                homes[order[i]] = address;  // that rank has it
            else if (address.known() && address.rank == me)
                settle(order[i], walk_or_search(positions.col(static_cast<Eigen::Index>(order[i])), address.cell));
            else
                settle(order[i], round < most_hand_overs ? address : CellAddress{});
        }
    }
    doubles_sent_ += exchange.doubles_sent();
    return lost;
}

void HomeSearch::search_everywhere(const VectorsView& positions, const Slots& lost, std::vector<CellAddress>& homes)
{
    std::vector<int> counts;
    Scalars questions;
    Slots order;
    for (int rank = 0; rank < comm_.size(); ++rank) {
        const std::size_t before = order.size();
        for (const std::size_t slot : lost) {
            const Vector x = positions.col(static_cast<Eigen::Index>(slot));
            if (!contains(bounds_[static_cast<std::size_t>(rank)], x)) continue;
            questions.insert(questions.end(), {x.x(), x.y(), x.z()});
            order.push_back(slot);
        }
        counts.push_back(static_cast<int>(order.size() - before));
    }
    SparseExchange exchange(comm_);
    exchange.plan(counts);
    const Scalars arrived = exchange.forward(questions, 3);
    Scalars answers;
    for (std::size_t i = 0; i < exchange.received(); ++i) {
        const CellAddress address = locator_.search({arrived[3 * i], arrived[3 * i + 1], arrived[3 * i + 2]});
        answers.insert(answers.end(), {static_cast<double>(address.rank), static_cast<double>(address.cell)});
    }
    const Scalars found = exchange.backward(answers, 2);
    for (const std::size_t slot : lost)
        homes[slot] = CellAddress{};
    for (std::size_t i = 0; i < order.size(); ++i) {  // of several, the lowest rank's cell
        CellAddress& home = homes[order[i]];
        if (!home.known() && found[2 * i] >= 0)
            home = {static_cast<int>(found[2 * i]), static_cast<int>(found[2 * i + 1])};
    }
    doubles_sent_ += exchange.doubles_sent();
}

}  // namespace interphase
