// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/cell_neighbourhood.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace interphase {

struct CellNeighbourhood::Candidates {
    std::vector<int> rank;
    std::vector<int> cell;  ///< the owner's number
};

namespace {

/// A cell that another rank may want in its halo.
struct OfferedCell {
    int rank;    ///< its owner
    int number;  ///< the owner's
    double centre[3], reach[3];
    double volume;
};

Box reach_box(const Vector& centre, const Vector& half)
{
    Box box;
    box.col(0) = centre - half;
    box.col(1) = centre + half;
    return box;
}

/// Boxes sorted into the bins of a regular grid, to find those that overlap another box.
class BoxBins {
public:
    explicit BoxBins(const Vector& bin) : bin_(bin) {}

    void add(int number, const Box& box)
    {
        for_each_bin(box, [&](std::uint64_t key) { bins_[key].push_back(number); });
    }

    template <class Visit>
    void near(const Box& box, Visit&& visit) const
    {
        for_each_bin(box, [&](std::uint64_t key) {
            const auto found = bins_.find(key);
            if (found == bins_.end()) return;
            for (const int number : found->second)
                visit(number);
        });
    }

private:
    template <class Visit>
    void for_each_bin(const Box& box, Visit&& visit) const
    {
        std::array<std::int64_t, 3> low{}, high{};
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = static_cast<std::int64_t>(std::floor(box(axis, 0) / bin_[axis]));
            high[axis] = static_cast<std::int64_t>(std::floor(box(axis, 1) / bin_[axis]));
        }
        constexpr std::uint64_t mask = (1u << 21) - 1;
        for (std::int64_t i = low[0]; i <= high[0]; ++i)
            for (std::int64_t j = low[1]; j <= high[1]; ++j)
                for (std::int64_t k = low[2]; k <= high[2]; ++k)
                    visit((static_cast<std::uint64_t>(i) & mask) << 42 | (static_cast<std::uint64_t>(j) & mask) << 21 |
                          (static_cast<std::uint64_t>(k) & mask));
    }

    Vector bin_;
    std::unordered_map<std::uint64_t, std::vector<int>> bins_;
};

}  // namespace

CellNeighbourhood::CellNeighbourhood(const Communicator& comm, const MeshView& own, double least_reach)
    : comm_(comm), own_count_(own.size()), centre_(own.centre), volume_(own.volume), exchange_(comm)
{
    for (const Vector& extent : own.extent)
        reach_.push_back(extent.cwiseMax(least_reach));
    const Candidates candidates = add_reaching_cells_of_others(own);
    find_neighbours(own);
    drop_unused_halo(candidates);
    sort_into_octants(own);
}

CellNeighbourhood::Candidates CellNeighbourhood::add_reaching_cells_of_others(const MeshView& own)
{
    Box mine = empty_box();
    for (std::size_t c = 0; c < own_count_; ++c) {
        extend(mine, own.centre[c] - 0.5 * own.extent[c]);
        extend(mine, own.centre[c] + 0.5 * own.extent[c]);
    }
    const Scalars boxes = comm_.all_gather(Scalars(mine.data(), mine.data() + mine.size()));

    std::vector<int> counts(static_cast<std::size_t>(comm_.size()), 0);
    std::vector<OfferedCell> offered;
    for (int rank = 0; rank < comm_.size(); ++rank) {
        if (rank == comm_.rank()) continue;
        const Box theirs = Eigen::Map<const Box>(boxes.data() + rank * mine.size());
        for (std::size_t c = 0; c < own_count_; ++c) {
            if (!overlap(reach_box(centre_[c], reach_[c]), theirs)) continue;
            ++counts[static_cast<std::size_t>(rank)];
            OfferedCell cell{comm_.rank(), static_cast<int>(c), {}, {}, volume_[c]};
            set(cell.centre, centre_[c]);
            set(cell.reach, reach_[c]);
            offered.push_back(cell);
        }
    }
    ExchangePlan offer(comm_);
    offer.plan(counts);

    Candidates candidates;
    for (const OfferedCell& cell : offer.forward(std::move(offered))) {
        candidates.rank.push_back(cell.rank);
        candidates.cell.push_back(cell.number);
        centre_.push_back(to_vector(cell.centre));
        reach_.push_back(to_vector(cell.reach));
        volume_.push_back(cell.volume);
    }
    return candidates;
}

void CellNeighbourhood::find_neighbours(const MeshView& own)
{
    Vector bin = Vector::Constant(1e-300);
    for (const Vector& reach : reach_)
        bin = bin.cwiseMax(reach);
    BoxBins bins(bin);
    for (std::size_t c = 0; c < centre_.size(); ++c)
        bins.add(static_cast<int>(c), reach_box(centre_[c], reach_[c]));

    first_.assign(1, 0);
    for (std::size_t c = 0; c < own_count_; ++c) {
        const Box cell = reach_box(own.centre[c], 0.5 * own.extent[c]);
        neighbours_.push_back(static_cast<int>(c));
        bins.near(cell, [&](int other) {
            if (other == static_cast<int>(c)) return;
            const auto o = static_cast<std::size_t>(other);
            if (overlap(cell, reach_box(centre_[o], reach_[o]))) neighbours_.push_back(other);
        });
        const auto begin = neighbours_.begin() + static_cast<std::ptrdiff_t>(first_.back()) + 1;
        std::sort(begin, neighbours_.end());
        neighbours_.erase(std::unique(begin, neighbours_.end()), neighbours_.end());
        first_.push_back(neighbours_.size());
    }
}

void CellNeighbourhood::drop_unused_halo(const Candidates& candidates)
{
    std::vector<int> renumbered(local_count(), -1);
    for (std::size_t c = 0; c < own_count_; ++c)
        renumbered[c] = static_cast<int>(c);
    for (const int neighbour : neighbours_)
        if (renumbered[static_cast<std::size_t>(neighbour)] < 0) renumbered[static_cast<std::size_t>(neighbour)] = 0;

    std::vector<int> wanted_of(static_cast<std::size_t>(comm_.size()), 0);
    std::vector<int> wanted;
    std::size_t next = own_count_;
    for (std::size_t i = 0; i < candidates.cell.size(); ++i) {  // candidates come ordered by rank
        const std::size_t local = own_count_ + i;
        if (renumbered[local] < 0) continue;
        renumbered[local] = static_cast<int>(next);
        centre_[next] = centre_[local];
        reach_[next] = reach_[local];
        volume_[next] = volume_[local];
        ++next;
        ++wanted_of[static_cast<std::size_t>(candidates.rank[i])];
        wanted.push_back(candidates.cell[i]);
    }
    centre_.resize(next);
    reach_.resize(next);
    volume_.resize(next);
    for (int& neighbour : neighbours_)
        neighbour = renumbered[static_cast<std::size_t>(neighbour)];

    exchange_.plan(wanted_of);  // those who want ask the owners: values flow backward along this plan
    for (const int cell : exchange_.forward(std::move(wanted)))
        served_.push_back(static_cast<std::size_t>(cell));
}

void CellNeighbourhood::sort_into_octants(const MeshView& own)
{
    first_of_octants_.assign(1, 0);
    for (std::size_t c = 0; c < own_count_; ++c)
        for (int octant = 0; octant < 8; ++octant) {
            // away from the planes between the eighths by a hair, where a reach that ends there has no weight
            constexpr double hair = 1e-9;
            Box eighth;
            for (int axis = 0; axis < 3; ++axis) {
                const double side = (octant >> axis & 1 ? 1 : -1) * own.extent[c][axis];
                const double inner = own.centre[c][axis] + hair * side, outer = own.centre[c][axis] + (1 - hair) * side;
                eighth(axis, 0) = std::min(inner, outer);
                eighth(axis, 1) = std::max(inner, outer);
            }
            for (const int* n = neighbours_begin(c); n != neighbours_end(c); ++n) {
                const auto other = static_cast<std::size_t>(*n);
                if (overlap(eighth, reach_box(centre_[other], reach_[other]))) of_octants_.push_back(*n);
            }
            first_of_octants_.push_back(of_octants_.size());
        }
}

}  // namespace interphase
