// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/owner_cell_search.hpp"

#include <map>
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

/// Of a particle's reach. A point on the face between two ranks' cells may by round-off be in neither, and a point as
/// near to a wall as that is not outside.
constexpr double round_off = 1e-7;

/// Not along any plane that meshes and packings are likely to have.
const Vector beside(0.42, 0.73, 0.54);

}  // namespace

OwnerCellSearch::OwnerCellSearch(const Communicator& comm, const CellLocator& locator)
    : comm_(comm), locator_(locator), bounds_(comm.gather_boxes(locator.bounds()))
{}

void OwnerCellSearch::update(const VectorsView& positions, const ScalarsView& reach,
                             std::vector<CellAddress>& owner_cells)
{
    const auto asked = [&](const Slots& slots, double margin, double off) {
        std::vector<Question> questions;
        for (const std::size_t slot : slots) {
            const auto column = static_cast<Eigen::Index>(slot);
            questions.push_back({slot, margin * reach[column], {}});
            set(questions.back().position, positions.col(column) + off * reach[column] * beside);
        }
        return questions;
    };
    beyond_edge_ = 0;
    Slots lost = walk_from_last_owners(positions, owner_cells);
    for (const double off : {0.0, round_off}) {
        if (!comm_.any(!lost.empty())) return;
        lost = search_everywhere(asked(lost, 0, off), owner_cells);
    }
    if (comm_.any(!lost.empty())) find_nearest(asked(lost, 1, 0), owner_cells);
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

template <class Answer, class Reply>
std::vector<OwnerCellSearch::Offered<Answer>> OwnerCellSearch::offer(const std::vector<Question>& questions,
                                                                     const Reply& reply)
{
    std::vector<int> counts;
    std::vector<Question> asked;
    std::vector<Offered<Answer>> all;
    for (int rank = 0; rank < comm_.size(); ++rank) {
        const std::size_t before = asked.size();
        for (const Question& question : questions) {
            Box around = bounds_[static_cast<std::size_t>(rank)];
            around.col(0).array() -= question.reach;
            around.col(1).array() += question.reach;
            if (!contains(around, to_vector(question.position))) continue;
            asked.push_back(question);
            all.push_back({question.slot, rank, {}});
        }
        counts.push_back(static_cast<int>(asked.size() - before));
    }
    ExchangePlan exchange(comm_);
    exchange.plan(counts);
    std::vector<Answer> answers;
    for (const Question& question : exchange.forward(std::move(asked)))
        answers.push_back(reply(question));
    const std::vector<Answer> returned = exchange.backward(std::move(answers));
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i].answer = returned[i];
    bytes_sent_ += exchange.bytes_sent();
    return all;
}

OwnerCellSearch::Slots OwnerCellSearch::search_everywhere(const std::vector<Question>& questions,
                                                          std::vector<CellAddress>& owner_cells)
{
    for (const Question& question : questions)
        owner_cells[question.slot] = CellAddress{};
    const auto search = [&](const Question& question) { return locator_.search(to_vector(question.position)); };
    for (const auto& offered : offer<CellAddress>(questions, search)) {  // of several, the lowest rank's cell
        CellAddress& owner = owner_cells[offered.slot];
        if (!owner.known()) owner = offered.answer;
    }
    Slots lost;
    for (const Question& question : questions)
        if (!owner_cells[question.slot].known()) lost.push_back(question.slot);
    return lost;
}

void OwnerCellSearch::find_nearest(const std::vector<Question>& questions, std::vector<CellAddress>& owner_cells)
{
    const auto nearest = [&](const Question& question) {
        return locator_.nearest(to_vector(question.position), question.reach);
    };
    std::map<std::size_t, double> distance;  // of each slot that somebody has a cell for
    for (const auto& offered : offer<NearCell>(questions, nearest)) {
        const NearCell& found = offered.answer;
        if (found.cell < 0) continue;
        const auto [known, is_first] = distance.try_emplace(offered.slot, found.distance);
        if (!is_first && known->second <= found.distance) continue;
        known->second = found.distance;
        owner_cells[offered.slot] = {offered.rank, found.cell};
    }
    for (const Question& question : questions)
        if (const auto known = distance.find(question.slot); known != distance.end())
            beyond_edge_ += known->second > round_off * question.reach;
}

}  // namespace interphase
