// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/bubbles.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace interphase {

namespace {

constexpr std::int64_t none = -1;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// A label on its way to the other half of a face.
struct Told {
    std::int64_t label;
    std::int64_t face;
};

/// What a rank has of a region.
struct Part {
    std::int64_t label = none;
    double volume = 0, moment = 0;  ///< [m3, m4]
};

std::size_t root(std::vector<std::size_t>& parent, std::size_t cell)
{
    while (parent[cell] != cell)
        cell = parent[cell] = parent[parent[cell]];
    return cell;
}

}  // namespace

Bubbles::Bubbles(const Communicator& comm, const MeshView& mesh) : comm_(comm), mesh_(mesh), to_other_halves_(comm)
{
    std::vector<int> counts;
    for (const std::vector<std::size_t>& of_rank : mesh.halves_by_rank(comm.size())) {
        counts.push_back(static_cast<int>(of_rank.size()));
        halves_.insert(halves_.end(), of_rank.begin(), of_rank.end());
    }
    to_other_halves_.plan(counts);
    first_of_rank_.assign(1, 0);
    for (const std::int64_t cells : comm.all_gather(static_cast<std::int64_t>(mesh.size())))
        first_of_rank_.push_back(first_of_rank_.back() + cells);
}

/// Of each cell the lowest label of its region, the same on all ranks; none outside of all.
std::vector<std::int64_t> Bubbles::labels(const std::vector<char>& inside) const
{
    std::vector<std::size_t> parent(inside.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (const MeshView::Face& face : mesh_.faces) {
        if (face.neighbour < 0 || !inside[index(face.owner)] || !inside[index(face.neighbour)]) continue;
        const std::size_t a = root(parent, index(face.owner)), b = root(parent, index(face.neighbour));
        parent[std::max(a, b)] = std::min(a, b);
    }
    std::vector<std::int64_t> label(inside.size(), none);
    for (std::size_t c = 0; c < inside.size(); ++c)
        if (inside[c]) label[c] = first_of_rank_[index(comm_.rank())] + static_cast<std::int64_t>(c);

    for (bool changed = true; comm_.any(changed);) {
        changed = false;
        std::vector<Told> out;
        for (const std::size_t f : halves_) {
            const std::size_t cell = index(mesh_.faces[f].owner);
            out.push_back({inside[cell] ? label[root(parent, cell)] : none, mesh_.faces[f].partner});
        }
        for (const Told& told : to_other_halves_.forward(std::move(out))) {
            const std::size_t cell = index(mesh_.faces[static_cast<std::size_t>(told.face)].owner);
            if (told.label == none || !inside[cell]) continue;
            std::int64_t& own = label[root(parent, cell)];
            if (told.label >= own) continue;
            own = told.label;
            changed = true;
        }
    }
    for (std::size_t c = 0; c < inside.size(); ++c)
        if (inside[c]) label[c] = label[root(parent, c)];
    return label;
}

BubbleSizes Bubbles::sizes(const std::function<bool(std::size_t)>& inside) const
{
    std::vector<char> chosen(mesh_.size());
    for (std::size_t c = 0; c < chosen.size(); ++c)
        chosen[c] = inside(c);
    const std::vector<std::int64_t> label = labels(chosen);
    std::map<std::int64_t, Part> mine;
    for (std::size_t c = 0; c < chosen.size(); ++c) {
        if (label[c] == none) continue;
        Part& part = mine[label[c]];
        part.label = label[c];
        part.volume += mesh_.volume[c];
        part.moment += mesh_.volume[c] * mesh_.centre[c].z();
    }

    // the rank on which a label began sums its region up; labels rise with ranks
    std::vector<Part> out;
    std::vector<int> counts(index(comm_.size()), 0);
    for (const auto& [name, part] : mine) {
        out.push_back(part);
        const auto next = std::upper_bound(first_of_rank_.begin(), first_of_rank_.end(), name);
        ++counts[static_cast<std::size_t>(next - first_of_rank_.begin()) - 1];
    }
    ExchangePlan home(comm_);
    home.plan(counts);
    std::map<std::int64_t, Part> regions;
    for (const Part& part : home.forward(std::move(out))) {
        Part& region = regions[part.label];
        region.volume += part.volume;
        region.moment += part.moment;
    }

    Scalars sums{static_cast<double>(regions.size()), 0};
    Part largest;
    for (const auto& [name, region] : regions) {
        sums[1] += region.volume;
        if (region.volume > largest.volume) largest = region;
    }
    comm_.sum(sums);
    Part of_all;  // of two alike that of the lower rank, on all ranks
    for (const Part& of_rank : comm_.all_gather(largest))
        if (of_rank.volume > of_all.volume) of_all = of_rank;
    const double height = of_all.volume > 0 ? of_all.moment / of_all.volume : std::numeric_limits<double>::quiet_NaN();
    return {sums[0], sums[1], of_all.volume, height};
}

}  // namespace interphase
