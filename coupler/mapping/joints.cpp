// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/joints.hpp"

#include <map>
#include <numeric>
#include <unordered_map>

namespace interphase {

Joints::Joints(const Communicator& comm, const JointNumbering& numbering, const CellSubdivision& subdivision,
               std::size_t cells)
    : comm_(comm), first_share_(numbering.count() + 1, 0), place_in_shared_(numbering.count(), -1), to_home_(comm)
{
    if (comm.size() > 1) plan_sums(numbering);
    find_shares(subdivision, cells);
}

void Joints::plan_sums(const JointNumbering& numbering)
{
    for (std::size_t j = 0; j < numbering.count(); ++j)
        if (numbering.is_at_other_half(static_cast<int>(j))) shared_.push_back(static_cast<int>(j));
    // labels rise with the rank they began on: these are ordered by it
    std::sort(shared_.begin(), shared_.end(), [&](int a, int b) { return numbering.label(a) < numbering.label(b); });
    std::vector<int> counts(static_cast<std::size_t>(comm_.size()), 0);
    std::vector<std::int64_t> out;
    for (const int joint : shared_) {
        place_in_shared_[static_cast<std::size_t>(joint)] = static_cast<int>(out.size());
        ++counts[static_cast<std::size_t>(numbering.home(numbering.label(joint)))];
        out.push_back(numbering.label(joint));
    }
    to_home_.plan(counts);
    std::unordered_map<std::int64_t, std::size_t> home_of;
    for (const std::int64_t label : to_home_.forward(std::move(out)))
        home_of_part_.push_back(home_of.emplace(label, home_of.size()).first->second);
    homes_ = home_of.size();
}

void Joints::find_shares(const CellSubdivision& subdivision, std::size_t cells)
{
    struct Integral {
        int joint, cell;
        double volume;
    };
    std::vector<Integral> integrals;  // of the joints' functions over the cells [m3]
    std::map<int, double> over_cell;
    for (std::size_t c = 0; c < cells; ++c) {
        over_cell.clear();
        subdivision.for_each_integral(c, [&](int joint, double volume) { over_cell[joint] += volume; });
        for (const auto& [joint, volume] : over_cell)
            integrals.push_back({joint, static_cast<int>(c), volume});
    }
    std::stable_sort(integrals.begin(), integrals.end(),
                     [](const Integral& a, const Integral& b) { return a.joint < b.joint; });

    Scalars whole(count(), 0.0);
    for (const Integral& integral : integrals)
        whole[static_cast<std::size_t>(integral.joint)] += integral.volume;
    Scalars of_shared;
    for (const int joint : shared_)
        of_shared.push_back(whole[static_cast<std::size_t>(joint)]);
    sum_shared(of_shared);
    for (std::size_t i = 0; i < shared_.size(); ++i)
        whole[static_cast<std::size_t>(shared_[i])] = of_shared[i];

    for (const Integral& integral : integrals) {
        const auto joint = static_cast<std::size_t>(integral.joint);
        if (!(whole[joint] > 0)) continue;
        shares_.push_back({integral.cell, integral.volume / whole[joint]});
        ++first_share_[joint + 1];
    }
    std::partial_sum(first_share_.begin(), first_share_.end(), first_share_.begin());
}

}  // namespace interphase
