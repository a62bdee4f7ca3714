// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/joint_numbering.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "exchange/exchange_plan.hpp"

namespace interphase {

namespace {

/// A label on its way to the other half of a face: which face there, and which of its copies.
struct Told {
    std::int64_t label;
    int face;
    int copy;
};

/// The copies of a face in order: itself, n corners, n edges. Seen from the other half, whose corners run the other way
/// round from the same first, corner k is n - k, and edge k, which leads to the next corner, n - 1 - k.
std::size_t as_seen_from_other_half(std::size_t copy, std::size_t corners)
{
    if (copy == 0) return 0;
    if (copy <= corners) return 1 + (corners - (copy - 1)) % corners;
    return 1 + corners + (corners - 1 - (copy - 1 - corners));
}

}  // namespace

JointNumbering::JointNumbering(const Communicator& comm, const MeshView& mesh)
{
    number_copies(mesh);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        for (std::size_t k = 0; k < neighbour_side_[f].size(); ++k)
            glue(owner_side_[f][k], neighbour_side_[f][k]);

    const std::vector<std::int64_t> counts = comm.all_gather(static_cast<std::int64_t>(parent_.size()));
    first_of_rank_.assign(1, 0);
    for (const std::int64_t count : counts)
        first_of_rank_.push_back(first_of_rank_.back() + count);
    label_.resize(parent_.size());
    std::iota(label_.begin(), label_.end(), first_of_rank_[static_cast<std::size_t>(comm.rank())]);
    spread_across_ranks(comm, mesh);
    number_joints(mesh);
}

int JointNumbering::home(std::int64_t label) const
{
    const auto next = std::upper_bound(first_of_rank_.begin(), first_of_rank_.end(), label);
    return static_cast<int>(next - first_of_rank_.begin()) - 1;
}

void JointNumbering::number_joints(const MeshView& mesh)
{
    label_of_joint_.assign(mesh.size(), -1);  // cells' centres have none
    at_other_half_.assign(mesh.size(), false);
    std::unordered_map<std::int64_t, int> number_of;
    first_corner_.assign(1, 0);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const auto joint = [&](std::size_t copy) {
            const std::int64_t label = label_[root(owner_side_[f][copy])];
            const auto [at, is_new] = number_of.emplace(label, static_cast<int>(label_of_joint_.size()));
            if (is_new) {
                label_of_joint_.push_back(label);
                at_other_half_.push_back(false);
            }
            if (mesh.faces[f].partner >= 0) at_other_half_[static_cast<std::size_t>(at->second)] = true;
            return at->second;
        };
        const std::size_t n = mesh.faces[f].points.size();
        of_face_.push_back(joint(0));
        for (std::size_t k = 0; k < n; ++k) {
            of_corner_.push_back(joint(1 + k));
            of_edge_.push_back(joint(1 + n + k));
        }
        first_corner_.push_back(of_corner_.size());
    }
}

void JointNumbering::number_copies(const MeshView& mesh)
{
    owner_side_.resize(mesh.faces.size());
    neighbour_side_.resize(mesh.faces.size());
    std::size_t next = 0;
    std::unordered_map<std::int64_t, std::size_t> found;  // of one cell: corners by point, edges by both
    const auto copy_of = [&](int a, int b) {
        const std::int64_t key = static_cast<std::int64_t>(std::min(a, b)) << 32 | std::max(a, b);
        const auto [at, is_new] = found.emplace(key, next);
        next += is_new;
        return at->second;
    };
    const std::vector<std::vector<int>> faces_of_cells = mesh.faces_of_cells();
    for (std::size_t c = 0; c < mesh.size(); ++c) {
        found.clear();
        for (const int face : faces_of_cells[c]) {
            const auto f = static_cast<std::size_t>(face);
            const std::vector<int>& points = mesh.faces[f].points;
            Copies& copies = (static_cast<std::size_t>(mesh.faces[f].owner) == c ? owner_side_ : neighbour_side_)[f];
            copies.push_back(next++);
            for (const int p : points)
                copies.push_back(copy_of(p, p));
            for (std::size_t k = 0; k < points.size(); ++k)
                copies.push_back(copy_of(points[k], points[(k + 1) % points.size()]));
        }
    }
    parent_.resize(next);
    std::iota(parent_.begin(), parent_.end(), 0);
}

std::size_t JointNumbering::root(std::size_t copy)
{
    while (parent_[copy] != copy)
        copy = parent_[copy] = parent_[parent_[copy]];
    return copy;
}

void JointNumbering::glue(std::size_t a, std::size_t b)
{
    const std::size_t low = std::min(root(a), root(b)), high = std::max(root(a), root(b));
    parent_[high] = low;
}

void JointNumbering::spread_across_ranks(const Communicator& comm, const MeshView& mesh)
{
    const std::vector<std::vector<std::size_t>> halves = mesh.halves_by_rank(comm.size());
    ExchangePlan plan(comm);
    std::vector<int> counts;
    for (const auto& faces : halves) {
        counts.push_back(0);
        for (const std::size_t f : faces)
            counts.back() += static_cast<int>(owner_side_[f].size());
    }
    plan.plan(counts);

    for (bool changed = true; comm.any(changed);) {
        changed = false;
        std::vector<Told> out;
        for (const auto& faces : halves)
            for (const std::size_t f : faces)
                for (std::size_t k = 0; k < owner_side_[f].size(); ++k)
                    out.push_back({label_[root(owner_side_[f][k])], mesh.faces[f].partner,
                                   static_cast<int>(as_seen_from_other_half(k, mesh.faces[f].points.size()))});
        for (const Told& told : plan.forward(std::move(out))) {
            const Copies& copies = owner_side_[static_cast<std::size_t>(told.face)];
            std::int64_t& own = label_[root(copies[static_cast<std::size_t>(told.copy)])];
            if (told.label >= own) continue;
            own = told.label;
            changed = true;
        }
    }
}

}  // namespace interphase
