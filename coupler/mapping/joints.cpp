// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/joints.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

#include "mapping/joint_numbering.hpp"

namespace interphase {

Joints::Joints(const Communicator& comm, const MeshView& mesh, const CellSubdivision& subdivision)
    : comm_(comm), to_home_(comm)
{
    first_corner_.assign(1, 0);
    for (const MeshView::Face& face : mesh.faces)
        first_corner_.push_back(first_corner_.back() + face.points.size());

    const JointNumbering numbering(comm, mesh);
    std::unordered_map<std::int64_t, int> number_of;
    std::vector<std::int64_t> labels(mesh.size(), -1);  // of each joint; cells' centres have none
    const auto joint_of = [&](std::int64_t label) {
        const auto [at, is_new] = number_of.emplace(label, static_cast<int>(labels.size()));
        if (is_new) labels.push_back(label);
        return at->second;
    };
    for (const std::int64_t label : numbering.of_face)
        of_face_.push_back(joint_of(label));
    for (const std::int64_t label : numbering.of_edge)
        of_edge_.push_back(joint_of(label));
    for (const std::int64_t label : numbering.of_corner)
        of_corner_.push_back(joint_of(label));

    std::vector<bool> at_other_half(labels.size(), false);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        if (mesh.faces[f].partner < 0) continue;
        at_other_half[static_cast<std::size_t>(of_face_[f])] = true;
        for (std::size_t k = first_corner_[f]; k < first_corner_[f + 1]; ++k)
            at_other_half[static_cast<std::size_t>(of_edge_[k])] = at_other_half[static_cast<std::size_t>(of_corner_[k])] =
                true;
    }
    for (std::size_t j = 0; j < labels.size(); ++j)
        if (comm.size() > 1 && at_other_half[j]) shared_.push_back(static_cast<int>(j));
    plan_sums(labels, numbering.first_of_rank);
    first_share_.assign(labels.size() + 1, 0);
    find_shares(subdivision, mesh.size());
}

void Joints::plan_sums(const std::vector<std::int64_t>& labels, const std::vector<std::int64_t>& first_of_rank)
{
    const auto label_of = [&](int joint) { return labels[static_cast<std::size_t>(joint)]; };
    std::sort(shared_.begin(), shared_.end(), [&](int a, int b) { return label_of(a) < label_of(b); });
    std::vector<int> counts(static_cast<std::size_t>(comm_.size()), 0);
    std::vector<std::int64_t> out;
    for (const int joint : shared_) {  // labels rise with the rank they began on, so these are ordered by it
        const auto rank = std::upper_bound(first_of_rank.begin(), first_of_rank.end(), label_of(joint));
        ++counts[static_cast<std::size_t>(rank - first_of_rank.begin()) - 1];
        out.push_back(label_of(joint));
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
        over_cell[of_cell(c)] = 0;
        subdivision.for_each_tetrahedron(c, [&](int face, int edge, int corner, double volume) {
            if (face < 0) {
                over_cell[of_cell(c)] += volume;
                return;
            }
            for (const int joint : {of_cell(c), of_face(face), of_edge(face, edge), of_corner(face, corner)})
                over_cell[joint] += volume / 4;
        });
        for (const auto& [joint, volume] : over_cell)
            integrals.push_back({joint, static_cast<int>(c), volume});
    }
    std::stable_sort(integrals.begin(), integrals.end(),
                     [](const Integral& a, const Integral& b) { return a.joint < b.joint; });

    Scalars whole(first_share_.size() - 1, 0.0);
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
