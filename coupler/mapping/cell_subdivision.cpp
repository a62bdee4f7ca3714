// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/cell_subdivision.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace interphase {

namespace {

/// Of a face's or an edge's extent: as near to its end as that a point is still on it.
constexpr double tie = 1e-9;

}  // namespace

CellSubdivision::CellSubdivision(const MeshView& mesh) : centre_(mesh.centre), volume_(mesh.volume)
{
    look_at_faces(mesh);
    look_at_cells(mesh);
}

void CellSubdivision::look_at_faces(const MeshView& mesh)
{
    first_edge_.assign(1, 0);
    for (const MeshView::Face& face : mesh.faces) {
        const Vector normal = face.area.normalized();
        for (std::size_t k = 0; k < face.points.size(); ++k) {
            const auto point = [&](std::size_t n) -> Vector {
                const Vector x =
                    mesh.points[static_cast<std::size_t>(face.points[n % face.points.size()])] - face.centre;
                return x - normal.dot(x) * normal;
            };
            const Vector middle = 0.5 * (point(k) + point(k + 1)), half = 0.5 * (point(k + 1) - point(k));
            const Vector outward = half.cross(normal);
            Edge edge;
            const double seen = outward.dot(middle);
            if (seen > 0) {
                edge.gauge = outward / seen;
                edge.along = half / half.squaredNorm();
                edge.middle = edge.along.dot(middle);
                edge.area = seen;
            }
            edges_.push_back(edge);
        }
        first_edge_.push_back(edges_.size());
    }
}

void CellSubdivision::look_at_cells(const MeshView& mesh)
{
    std::vector<std::vector<int>> faces_of(mesh.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        faces_of[static_cast<std::size_t>(mesh.faces[f].owner)].push_back(static_cast<int>(f));
        if (mesh.faces[f].neighbour >= 0)
            faces_of[static_cast<std::size_t>(mesh.faces[f].neighbour)].push_back(static_cast<int>(f));
    }
    first_side_.assign(1, 0);
    for (std::size_t c = 0; c < mesh.size(); ++c) {
        for (const int f : faces_of[c]) {
            const MeshView::Face& face = mesh.faces[static_cast<std::size_t>(f)];
            const Vector outward = static_cast<std::size_t>(face.owner) == c ? face.area : Vector(-face.area);
            Side side;
            side.to_face = face.centre - mesh.centre[c];
            const double seen = outward.dot(side.to_face);
            if (seen > 0) side.gauge = outward / seen;
            sides_.push_back(side);
            face_of_side_.push_back(f);
        }
        first_side_.push_back(sides_.size());
    }
}

CellSubdivision::OnFace CellSubdivision::seen_from_cell(const Vector& x, std::size_t side) const
{
    const double out = sides_[side].gauge.dot(x);
    OnFace at{side, 0, out, 0, 0};
    const auto face = static_cast<std::size_t>(face_of_side_[side]);
    const Vector y = x / out - sides_[side].to_face;
    const auto along = [&](std::size_t edge, double aside) {
        return aside > 0 ? edges_[edge].along.dot(y) / aside - edges_[edge].middle : 0.0;
    };
    at.edge = first_edge_[face];
    for (std::size_t e = first_edge_[face]; e < first_edge_[face + 1]; ++e) {
        const double reached = edges_[e].gauge.dot(y);
        if (reached > at.aside) {
            at.aside = reached;
            at.edge = e;
        }
    }
    at.along = along(at.edge, at.aside);
    if (std::abs(at.along) <= 1 + tie) return at;
    // beside the edge: another one in the same line, or a face that is not convex
    for (std::size_t e = first_edge_[face]; e < first_edge_[face + 1]; ++e) {
        const double reached = edges_[e].gauge.dot(y);
        if (!(reached > 0) || !(std::abs(along(e, reached)) < std::abs(at.along))) continue;
        at.edge = e;
        at.aside = reached;
        at.along = along(e, reached);
    }
    return at;
}

CellSubdivision::Place CellSubdivision::place(const Vector& point, std::size_t cell) const
{
    const Vector x = point - centre_[cell];
    double out = 0;
    std::size_t side = first_side_[cell];
    for (std::size_t s = first_side_[cell]; s < first_side_[cell + 1]; ++s) {
        const double reached = sides_[s].gauge.dot(x);
        if (reached > out) {
            out = reached;
            side = s;
        }
    }
    if (!(out > 0)) return {face_of_side_[side], 0, 0, 1, 0, 0, 0};

    OnFace at = seen_from_cell(x, side);
    if (at.aside > 1 + tie)
        // beside the face: another one in the same plane, or a cell that is not convex
        for (std::size_t s = first_side_[cell]; s < first_side_[cell + 1]; ++s) {
            if (!(sides_[s].gauge.dot(x) > 0)) continue;
            const OnFace other = seen_from_cell(x, s);
            if (other.aside < at.aside) at = other;
        }

    const double aside = std::min(at.aside, 1.0), along = std::clamp(at.along, -1.0, 1.0);
    out = std::min(at.out, 1.0);
    const auto face = static_cast<std::size_t>(face_of_side_[at.side]);
    const std::size_t number = at.edge - first_edge_[face];
    Place place{};
    place.face = static_cast<int>(face);
    place.edge = static_cast<int>(number);
    place.corner = static_cast<int>(along > 0 ? (number + 1) % corners(face) : number);
    place.in_cell = 1 - out;
    place.on_face = out * (1 - aside);
    place.on_corner = out * aside * std::abs(along);
    place.on_edge = out * aside - place.on_corner;
    return place;
}

}  // namespace interphase
