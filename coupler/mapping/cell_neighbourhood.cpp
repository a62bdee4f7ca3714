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
    std::vector<std::size_t> cell;  ///< the owner's number
};

namespace {

constexpr int cell_record = 8;  // number, centre, reach, volume

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
    Scalars offered;
    for (int rank = 0; rank < comm_.size(); ++rank) {
        if (rank == comm_.rank()) continue;
        const Box theirs = Eigen::Map<const Box>(boxes.data() + rank * mine.size());
        for (std::size_t c = 0; c < own_count_; ++c) {
            if (!overlap(reach_box(centre_[c], reach_[c]), theirs)) continue;
            ++counts[static_cast<std::size_t>(rank)];
            offered.push_back(static_cast<double>(c));
            offered.insert(offered.end(), centre_[c].data(), centre_[c].data() + 3);
            offered.insert(offered.end(), reach_[c].data(), reach_[c].data() + 3);
            offered.push_back(volume_[c]);
        }
    }
    // the owner of a record is told by a second record: which rank sent it
    SparseExchange offer(comm_);
    offer.plan(counts);
    const Scalars arrived = offer.forward(offered, cell_record);
    const Scalars senders = offer.forward(Scalars(offered.size() / cell_record, comm_.rank()), 1);

    Candidates candidates;
    for (std::size_t i = 0; i < offer.received(); ++i) {
        const double* record = &arrived[i * cell_record];
        candidates.rank.push_back(static_cast<int>(senders[i]));
        candidates.cell.push_back(static_cast<std::size_t>(record[0]));
        centre_.emplace_back(record[1], record[2], record[3]);
        reach_.emplace_back(record[4], record[5], record[6]);
        volume_.push_back(record[7]);
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
    Scalars wanted;
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
        wanted.push_back(static_cast<double>(candidates.cell[i]));
    }
    centre_.resize(next);
    reach_.resize(next);
    volume_.resize(next);
    for (int& neighbour : neighbours_)
        neighbour = renumbered[static_cast<std::size_t>(neighbour)];

    exchange_.plan(wanted_of);  // those who want ask the owners: values flow backward along this plan
    const Scalars asked = exchange_.forward(wanted, 1);
    for (const double cell : asked)
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

void CellNeighbourhood::fill_halo(Scalars& values, int width) const
{
    if (comm_.size() == 1) return;
    const auto w = static_cast<std::size_t>(width);
    Scalars out(served_.size() * w);
    for (std::size_t i = 0; i < served_.size(); ++i)
        std::copy_n(&values[served_[i] * w], w, &out[i * w]);
    const Scalars in = exchange_.backward(out, width);
    std::copy(in.begin(), in.end(), values.begin() + static_cast<std::ptrdiff_t>(own_count_ * w));
}

void CellNeighbourhood::add_halo_to_owners(Scalars& values, int width) const
{
    if (comm_.size() == 1) return;
    const auto w = static_cast<std::size_t>(width);
    const auto halo = values.begin() + static_cast<std::ptrdiff_t>(own_count_ * w);
    const Scalars in = exchange_.forward(Scalars(halo, values.end()), width);
    for (std::size_t i = 0; i < served_.size(); ++i)
        for (std::size_t k = 0; k < w; ++k)
            values[served_[i] * w + k] += in[i * w + k];
    std::fill(halo, values.end(), 0.0);
}

}  // namespace interphase
