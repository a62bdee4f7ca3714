// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mapping/mesh_view.hpp"

namespace interphase {

/// The barycentric subdivision of a rank's cells: tetrahedra between a cell's centre, the centre of one of its faces,
/// the middle of one of that face's edges, and one end of the edge. Functions that are linear in each of them are
/// continuous over the mesh, whatever the shape of its cells.
///
/// Faces are taken as planes through their centres; cells should be star-shaped about their centre, and faces about
/// theirs. What is not so (a face that its cell's centre does not see) takes no part.
class CellSubdivision {
public:
    explicit CellSubdivision(const MeshView& mesh);

    /// Where in its cell a point lies: on which side of the cell, at which edge of that face (`edge` leads from corner
    /// `edge` of the face to the next), near which of its two ends; and the barycentric coordinates of its tetrahedron,
    /// which are at least 0 and sum to 1.
    struct Place {
        int face, edge, corner;
        double in_cell, on_face, on_edge, on_corner;
    };
    Place place(const Vector& point, std::size_t cell) const;

    /// The vertices of a cell's tetrahedra: `visit(face, edge, corner, volume)` for each of them [m3]; `face` -1 for
    /// the rest of the cell's volume, if any, which belongs to its centre. The volumes sum to the cell's.
    template <class Visit>
    void for_each_tetrahedron(std::size_t cell, Visit&& visit) const;

    /// Faces of a cell.
    const int* faces_begin(std::size_t cell) const { return face_of_side_.data() + first_side_[cell]; }
    const int* faces_end(std::size_t cell) const { return face_of_side_.data() + first_side_[cell + 1]; }

    std::size_t corners(std::size_t face) const { return first_edge_[face + 1] - first_edge_[face]; }

private:
    /// A face as its cell's centre sees it.
    struct Side {
        Vector gauge =
            Vector::Zero();  ///< gauge . (x - centre of the cell) is 1 on the plane of the face, or 0: not seen
        Vector to_face;      ///< from the centre of the cell to that of the face [m]
    };
    /// An edge as the centre of its face sees it.
    struct Edge {
        Vector gauge = Vector::Zero();  ///< gauge . (x - centre of the face) is 1 on the edge, or 0: not seen
        Vector along = Vector::Zero();  ///< along . (x - centre of the face) - middle runs from -1 to 1 on the edge
        double middle = 0;
        double area = 0;  ///< of the triangle between it and the centre of the face [m2]
    };

    /// Where the ray from a cell's centre through a point meets the plane of a face.
    struct OnFace {
        std::size_t side, edge;
        double out;    ///< of the point on the way: 0 at the centre, 1 on the face
        double aside;  ///< 0 at the centre of the face, 1 on its edges
        double along;  ///< -1 and 1 at the ends of the edge
    };
    OnFace seen_from_cell(const Vector& x, std::size_t side) const;

    void look_at_faces(const MeshView& mesh);
    void look_at_cells(const MeshView& mesh);

    Vectors centre_;
    Scalars volume_;
    std::vector<std::size_t> first_side_;  ///< of each cell
    std::vector<Side> sides_;
    std::vector<int> face_of_side_;
    std::vector<std::size_t> first_edge_;  ///< of each face
    std::vector<Edge> edges_;
};

template <class Visit>
void CellSubdivision::for_each_tetrahedron(std::size_t cell, Visit&& visit) const
{
    const auto for_each = [&](auto&& see) {
        for (std::size_t s = first_side_[cell]; s < first_side_[cell + 1]; ++s) {
            const double per_height = sides_[s].gauge.norm();
            if (!(per_height > 0)) continue;
            const auto face = static_cast<std::size_t>(face_of_side_[s]);
            for (std::size_t e = first_edge_[face]; e < first_edge_[face + 1]; ++e)
                see(static_cast<int>(face), static_cast<int>(e - first_edge_[face]), edges_[e].area / (6 * per_height));
        }
    };
    double seen = 0;
    for_each([&](int, int, double half) { seen += 2 * half; });
    // Planes instead of warped faces give a volume that is a little off.
    const double scale = seen > volume_[cell] ? volume_[cell] / seen : 1.0;
    for_each([&](int face, int edge, double half) {
        const auto next = (static_cast<std::size_t>(edge) + 1) % corners(static_cast<std::size_t>(face));
        visit(face, edge, edge, scale * half);
        visit(face, edge, static_cast<int>(next), scale * half);
    });
    if (seen < volume_[cell]) visit(-1, -1, -1, volume_[cell] - seen);
}

}  // namespace interphase
