// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/cell_surfaces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace interphase {

namespace {

/// Of a cell's extent: a face whose corners lie as near to its plane as that is plane.
constexpr double plane_within = 1e-9;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// On which side of the plane through the cell's centre and two points: computed in one way wherever it is asked, so
/// that the two triangles that meet in the plane see opposite signs to the last bit. `forward` is true for one of them.
[[gnu::noinline]] bool is_on_side(const Vector& to_first, const Vector& to_second, const Vector& x, bool forward)
{
    const double value = to_first.cross(to_second).dot(x);
    return forward ? value >= 0 : value < 0;
}

/// Likewise the two cells at a triangle of a face.
[[gnu::noinline]] bool is_below(const Vector& to_a, const Vector& to_b, const Vector& from_face)
{
    return to_a.cross(to_b).dot(from_face) <= 0;
}

}  // namespace

CellSurfaces::CellSurfaces(const MeshView& mesh) : mesh_(mesh), first_{0}
{
    const std::vector<std::vector<int>> faces_of_cells = mesh.faces_of_cells();
    for (std::size_t c = 0; c < mesh.size(); ++c) {
        add_sides(c, faces_of_cells[c]);
        is_plane_.push_back(is_convex(c));
    }
}

void CellSurfaces::add_sides(std::size_t cell, const std::vector<int>& faces)
{
    for (const int f : faces) {
        const MeshView::Face& face = mesh_.faces[at(f)];
        const Vector outward = (at(face.owner) == cell ? 1 : -1) * face.area.normalized();
        Side side{outward, outward.dot(face.centre), f};
        for (const int p : face.points)
            side.warp = std::max(side.warp, std::abs(side.distance(mesh_.points[at(p)])));
        sides_.push_back(side);
    }
    first_.push_back(sides_.size());
}

bool CellSurfaces::is_convex(std::size_t cell) const
{
    const double tie = plane_within * mesh_.extent[cell].maxCoeff();
    for (const Side* side = begin(cell); side != end(cell); ++side)
        for (const Side* other = begin(cell); other != end(cell); ++other)
            for (const int p : mesh_.faces[at(other->face)].points)
                if (side->warp > tie || side->distance(mesh_.points[at(p)]) > tie) return false;
    return true;
}

bool CellSurfaces::holds(const Vector& point, std::size_t cell) const
{
    // deep inside it needs no look at the triangles
    return is_inside_planes(point, cell) || (!is_plane_[cell] && winding(point, cell) > 0);
}

bool CellSurfaces::is_inside_planes(const Vector& point, std::size_t cell) const
{
    const bool plane = is_plane_[cell];
    return std::all_of(begin(cell), end(cell),
                       [&](const Side& side) { return side.distance(point) <= (plane ? 0.0 : -side.warp); });
}

int CellSurfaces::winding(const Vector& point, std::size_t cell) const
{
    const Vector& centre = mesh_.centre[cell];
    const Vector x = point - centre;
    int winding = 0;
    for (const Side* side = begin(cell); side != end(cell); ++side) {
        const MeshView::Face& face = mesh_.faces[at(side->face)];
        const bool owned = at(face.owner) == cell;
        const Vector to_face = face.centre - centre;
        const std::size_t n = face.points.size();
        for (std::size_t k = 0; k < n; ++k) {
            const int p = face.points[k], q = face.points[(k + 1) % n];
            const Vector &a = mesh_.points[at(p)], &b = mesh_.points[at(q)];
            const Vector to_a = a - centre, to_b = b - centre;
            // the triangle turns right-handedly about the owner's outward normal
            const Vector from_face_to_a = a - face.centre, from_face_to_b = b - face.centre;
            const bool below = is_below(from_face_to_a, from_face_to_b, point - face.centre) == owned;
            const bool beside_a = is_on_side(to_face, to_a, x, owned);
            const bool beside_b = is_on_side(to_face, to_b, x, !owned);
            const bool on_edge = is_on_side(p < q ? to_a : to_b, p < q ? to_b : to_a, x, (p < q) == owned);
            const bool seen = (from_face_to_a.cross(from_face_to_b).dot(to_face) > 0) == owned;
            if (seen)
                winding += below && beside_a && beside_b && on_edge;
            else
                winding -= !below && !beside_a && !beside_b && !on_edge;
        }
    }
    return winding;
}

}  // namespace interphase
