// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/owner_cell_search.hpp"

#include <limits>
#include <utility>

#include "exchange/exchange_plan.hpp"

namespace interphase {

namespace {

/// A walk that passes from rank to rank more often than this has lost its way; the particle is searched for instead.
constexpr int most_hand_overs = 8;

/// Is the particle at this position in your cell, or near it? The answer is a CellAddress.
struct WalkQuestion {
    double position[3];
    int start;  ///< the asked rank's cell
};

/// Is it anywhere in your part of the mesh? The answer is a CellAddress.
struct SearchQuestion {
    double position[3];
};

/// Which of your cells at the edge of the mesh is nearest? The answer is a NearCell.
struct EdgeQuestion {
    double position[3];
    double reach;
};

/// Of a particle's reach. A point on the face between two ranks' cells may by round-off be in neither, and a point as
/// near to a wall as that is not outside.
constexpr double round_off = 1e-7;

/// Not along any plane that meshes and packings are likely to have.
const Vector beside(0.42, 0.73, 0.54);

}  // namespace

OwnerCellSearch::OwnerCellSearch(const Communicator& comm, const CellLocator& locator) : comm_(comm), locator_(locator)
{
    const Box mine = locator_.bounds();
    const Scalars all = comm_.all_gather(Scalars(mine.data(), mine.data() + mine.size()));
    for (int rank = 0; rank < comm_.size(); ++rank)
        bounds_.emplace_back(Eigen::Map<const Box>(all.data() + rank * mine.size()));
}

void OwnerCellSearch::update(const VectorsView& positions, const ScalarsView& reach,
                             std::vector<CellAddress>& owner_cells)
{
    const auto column = [](std::size_t slot) { return static_cast<Eigen::Index>(slot); };
    const auto here = [&](std::size_t slot) -> Vector { return positions.col(column(slot)); };
    const auto beside_it = [&](std::size_t slot) -> Vector {
        return here(slot) + round_off * reach[column(slot)] * beside;
    };
    beyond_edge_ = 0;
    Slots lost = walk_from_last_owners(positions, owner_cells);
    if (!comm_.any(!lost.empty())) return;
    lost = search_everywhere(lost, here, owner_cells);
    if (!comm_.any(!lost.empty())) return;
    lost = search_everywhere(lost, beside_it, owner_cells);
    if (!comm_.any(!lost.empty())) return;
    find_nearest(positions, reach, lost, owner_cells);
}

CellAddress OwnerCellSearch::walk_or_search(const Vector& point, int start) const
{
    const CellAddress address = locator_.walk(point, start);
    return address.known() ? address : locator_.search(point);
}

OwnerCellSearch::Slots OwnerCellSearch::walk_from_last_owners(const VectorsView& positions,
                                                              std::vector<CellAddress>& owner_cells)
{
    const int me = comm_.rank();
    Slots lost;
    std::vector<Slots> asked(static_cast<std::size_t>(comm_.size()));

    const auto settle = [&](std::size_t slot, const CellAddress& address) {
        owner_cells[slot] = address;
        if (!address.known())
            lost.push_back(slot);
        else if (address.rank != me)
            asked[static_cast<std::size_t>(address.rank)].push_back(slot);
    };
    for (std::size_t slot = 0; slot < owner_cells.size(); ++slot) {
        const CellAddress owner = owner_cells[slot];
        settle(slot, owner.known() && owner.rank == me
                         ? walk_or_search(positions.col(static_cast<Eigen::Index>(slot)), owner.cell)
                         : owner);
    }
    if (comm_.size() == 1) return lost;

    ExchangePlan exchange(comm_);
    for (int round = 0; round <= most_hand_overs; ++round) {  // by the last of them each is settled
        std::vector<int> counts;
        std::vector<WalkQuestion> questions;
        Slots order;
        for (Slots& slots : asked) {
            counts.push_back(static_cast<int>(slots.size()));
            for (const std::size_t slot : slots) {
                questions.emplace_back();
                set(questions.back().position, positions.col(static_cast<Eigen::Index>(slot)));
                questions.back().start = owner_cells[slot].cell;
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
            const CellAddress asked_for = owner_cells[order[i]], address = found[i];
            if (address.known() && address.rank == asked_for.rank)
                owner_cells[order[i]] = address;  // that rank has it
            else if (round >= most_hand_overs)
                settle(order[i], {});
            else if (address.known() && address.rank == me)
                settle(order[i], walk_or_search(positions.col(static_cast<Eigen::Index>(order[i])), address.cell));
            else
                settle(order[i], address);
        }
    }
    bytes_sent_ += exchange.bytes_sent();
    return lost;
}

template <class Place>
OwnerCellSearch::Slots OwnerCellSearch::search_everywhere(const Slots& lost, const Place& place,
                                                          std::vector<CellAddress>& owner_cells)
{
    std::vector<int> counts;
    std::vector<SearchQuestion> questions;
    Slots order;
    for (const Box& bounds : bounds_) {
        const std::size_t before = order.size();
        for (const std::size_t slot : lost) {
            const Vector x = place(slot);
            if (!contains(bounds, x)) continue;
            questions.emplace_back();
            set(questions.back().position, x);
            order.push_back(slot);
        }
        counts.push_back(static_cast<int>(order.size() - before));
    }
    ExchangePlan exchange(comm_);
    exchange.plan(counts);
    std::vector<CellAddress> answers;
    for (const SearchQuestion& asked_here : exchange.forward(std::move(questions)))
        answers.push_back(locator_.search(to_vector(asked_here.position)));
    const std::vector<CellAddress> found = exchange.backward(std::move(answers));
    for (const std::size_t slot : lost)
        owner_cells[slot] = CellAddress{};
    for (std::size_t i = 0; i < order.size(); ++i) {  // of several, the lowest rank's cell
        CellAddress& owner = owner_cells[order[i]];
        if (!owner.known()) owner = found[i];
    }
    bytes_sent_ += exchange.bytes_sent();
    Slots still_lost;
    for (const std::size_t slot : lost)
        if (!owner_cells[slot].known()) still_lost.push_back(slot);
    return still_lost;
}

void OwnerCellSearch::find_nearest(const VectorsView& positions, const ScalarsView& reach, const Slots& lost,
                                   std::vector<CellAddress>& owner_cells)
{
    std::vector<int> counts, ranks;
    std::vector<EdgeQuestion> questions;
    Slots order;
    for (int rank = 0; rank < comm_.size(); ++rank) {
        const std::size_t before = order.size();
        for (const std::size_t slot : lost) {
            const auto column = static_cast<Eigen::Index>(slot);
            Box around = bounds_[static_cast<std::size_t>(rank)];
            around.col(0).array() -= reach[column];
            around.col(1).array() += reach[column];
            if (!contains(around, positions.col(column))) continue;
            questions.emplace_back();
            set(questions.back().position, positions.col(column));
            questions.back().reach = reach[column];
            order.push_back(slot);
            ranks.push_back(rank);
        }
        counts.push_back(static_cast<int>(order.size() - before));
    }
    ExchangePlan exchange(comm_);
    exchange.plan(counts);
    std::vector<NearCell> answers;
    for (const EdgeQuestion& asked_here : exchange.forward(std::move(questions)))
        answers.push_back(locator_.nearest(to_vector(asked_here.position), asked_here.reach));
    const std::vector<NearCell> found = exchange.backward(std::move(answers));
    Scalars nearest(owner_cells.size(), std::numeric_limits<double>::max());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t slot = order[i];
        if (found[i].cell < 0 || !(found[i].distance < nearest[slot])) continue;
        nearest[slot] = found[i].distance;
        owner_cells[slot] = {ranks[i], found[i].cell};
    }
    for (const std::size_t slot : lost)
        beyond_edge_ += owner_cells[slot].known() && nearest[slot] > round_off * reach[static_cast<Eigen::Index>(slot)];
    bytes_sent_ += exchange.bytes_sent();
}

}  // namespace interphase
