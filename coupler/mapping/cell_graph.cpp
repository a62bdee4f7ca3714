// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/cell_graph.hpp"

namespace interphase {

namespace {

/// What the half of a face elsewhere has to know of this one.
struct OtherHalf {
    int face;           ///< there
    int cell;           ///< here
    double volume;      ///< of that cell [m3]
    double to_cell[3];  ///< from the centre of the face to that of the cell [m]
    double area[3];     ///< out of that cell [m2]
};

CellGraph::Link link_across(int to, const Vector& area, const Vector& between)
{
    const double distance = between.norm();
    return {to, distance, distance > 0 ? std::abs(area.dot(between)) / (distance * distance) : 0.0};
}

}  // namespace

CellGraph::CellGraph(const Communicator& comm, const MeshView& mesh)
    : comm_(comm), own_count_(mesh.size()), centre_(mesh.centre), volume_(mesh.volume), exchange_(comm)
{
    std::vector<std::vector<Link>> of_cell(own_count_);
    const auto centre_of = [&](int cell) { return mesh.centre[static_cast<std::size_t>(cell)]; };
    const auto links_of = [&](int cell) -> std::vector<Link>& { return of_cell[static_cast<std::size_t>(cell)]; };

    for (const MeshView::Face& face : mesh.faces) {
        if (face.neighbour < 0) continue;
        const Link link = link_across(face.neighbour, face.area, centre_of(face.neighbour) - centre_of(face.owner));
        links_of(face.owner).push_back(link);
        links_of(face.neighbour).push_back({face.owner, link.distance, link.openness});
    }

    ExchangePlan plan(comm);
    std::vector<int> counts, wanted_of;
    std::vector<OtherHalf> out;
    for (const auto& faces : mesh.halves_by_rank(comm.size())) {
        counts.push_back(static_cast<int>(faces.size()));
        for (const std::size_t f : faces) {
            const MeshView::Face& face = mesh.faces[f];
            OtherHalf half{face.partner, face.owner, volume_[static_cast<std::size_t>(face.owner)], {}, {}};
            set(half.to_cell, centre_of(face.owner) - face.centre);
            set(half.area, face.area);
            out.push_back(half);
        }
    }
    plan.plan(counts);

    wanted_of.assign(counts.size(), 0);
    std::vector<int> wanted;
    for (const OtherHalf& half : plan.forward(std::move(out))) {  // these come ordered by rank
        const MeshView::Face& face = mesh.faces[static_cast<std::size_t>(half.face)];
        int to = half.cell;
        if (face.partner_rank != comm.rank()) {
            to = static_cast<int>(volume_.size());
            volume_.push_back(half.volume);
            ++wanted_of[static_cast<std::size_t>(face.partner_rank)];
            wanted.push_back(half.cell);
        }
        const Vector between = face.centre - centre_of(face.owner) + to_vector(half.to_cell);
        // Halves from a file have the same area in as many digits as it has. Contents stay whole and the way back is
        // the transpose only where both sides take the same.
        const Vector area = 0.5 * (face.area - to_vector(half.area));
        links_of(face.owner).push_back(link_across(to, area, between));
    }
    exchange_.plan(wanted_of);  // those who want ask the owners: values flow backward along this plan
    for (const int cell : exchange_.forward(std::move(wanted)))
        served_.push_back(static_cast<std::size_t>(cell));

    first_.assign(1, 0);
    for (const auto& links : of_cell) {
        links_.insert(links_.end(), links.begin(), links.end());
        first_.push_back(links_.size());
    }
}

}  // namespace interphase
