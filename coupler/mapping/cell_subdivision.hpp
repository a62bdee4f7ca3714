// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mapping/joint_numbering.hpp"
#include "mapping/mesh_view.hpp"

namespace interphase {

/// The barycentric subdivision of a rank's cells, and functions on it that sum to one and are continuous over the mesh,
/// one for each joint.
///
/// A cell's tetrahedra stand between its centre, the centre of one of its faces, the middle of one of that face's
/// edges, and one end of the edge. Three coordinates, 1 >= A >= B >= C >= 0, tell where in one of them a point lies: A
/// is 0 at the cell's centre and 1 on its face; B/A is 0 at the centre of the face and 1 on its edge; C/B is 0 in the
/// middle of the edge and 1 at its end. A, B and C are what three coordinates along the axes are to a box. With the
/// smoothed a = s(A) and so on, s(t) = t^2 (3 - t)/2, the functions are products: (1-a)(1-b)(1-c) of the cell's centre,
/// a(1-b)(1-c) of the face, (1-a)b(1-c) and (1-a)(1-b)c of the other two faces that meet at the corner, ab(1-c) of the
/// edge, and so on to abc of the corner. Where more than three faces meet at some corner of a cell the products would
/// not match, and the cell's functions run straight from its centre to those on its faces.
///
/// On a uniform grid of boxes a cell then holds products of functions like (1 + cos(pi x/h))/2: a hat of that width
/// without its kinks, whose spectrum falls off with the third power of the wave number, so that regular packings leave
/// less of their own pattern in the cells than with hats (README.md).
///
/// Faces are taken as planes through their centres; cells should be star-shaped about their centre, and faces about
/// theirs. What is not so (a face that its cell's centre does not see) takes no part.
class CellSubdivision {
public:
    CellSubdivision(const MeshView& mesh, const JointNumbering& joints);

    /// A face as its cell's centre sees it.
    struct Side {
        Vector gauge =
            Vector::Zero();  ///< gauge . (x - centre of the cell) is 1 on the plane of the face, or 0: not seen
        Vector to_face;      ///< from the centre of the cell to that of the face [m]
        int face = 0;
        std::size_t first_wedge = 0;  ///< one for each edge
    };
    const Vector& centre(std::size_t cell) const { return centre_[cell]; }
    std::size_t sides_begin(std::size_t cell) const { return first_side_[cell]; }
    std::size_t sides_end(std::size_t cell) const { return first_side_[cell + 1]; }
    const Side& side(std::size_t n) const { return sides_[n]; }
    /// How far from the centre of its face a point in the face's plane lies: 0 at the centre, 1 on an edge. `y` [m]
    /// from the centre of the face.
    double aside(std::size_t side, const Vector& y) const;

    /// A corner of a cell, or of one of its faces where more than three meet at some corner. Joints by the bits of
    /// their number: 1, 2, 4 are three faces there, 3, 5, 6 the edges between two of them, 7 the corner; 0 the cell's
    /// centre. Those not needed are -1.
    using Corner = std::array<int, 8>;
    const Corner& corner(std::size_t n) const { return corners_[n]; }
    std::size_t corners() const { return corners_.size(); }

    /// Where a point of a cell lies: near which of the cell's corners, and its smoothed coordinates towards the three
    /// faces there, by bit; in a cell of cones, towards the face and along its two edges.
    struct Place {
        std::size_t corner;
        bool products;
        std::array<double, 3> smoothed;

        /// Values of the functions of the corner's joints. All others are 0 there.
        std::array<double, 8> functions() const;
    };
    Place place(const Vector& point, std::size_t cell) const
    {
        return box_of_cell_[cell] >= 0
                   ? place_in_box(point - centre_[cell], static_cast<std::size_t>(box_of_cell_[cell]))
                   : place_in_tetrahedron(point - centre_[cell], cell);
    }

    /// Integrals of the functions over a cell [m3], which sum to its volume: `visit(joint, integral)`.
    template <class Visit>
    void for_each_integral(std::size_t cell, Visit&& visit) const
    {
        double seen = 0;
        for_each_tetrahedron(cell, [&](std::size_t, double volume) { seen += volume; });
        // Planes instead of warped faces give a volume that is a little off.
        const double scale = seen > volume_[cell] ? volume_[cell] / seen : 1.0;
        const std::array<double, 8>& means = has_simple_corners_[cell] ? means_of_products() : means_of_cones();
        for_each_tetrahedron(cell, [&](std::size_t edge, double volume) {
            const Wedge& wedge = wedges_[edge / 2];
            std::array<double, 8> of_corner{};
            for (std::size_t m = 0; m < 8; ++m)
                of_corner[in_order_of(wedge.order[edge % 2], m)] = means[m];
            const Corner& corner = corners_[wedge.corner[edge % 2]];
            for (std::size_t m = 0; m < 8; ++m)
                if (corner[m] >= 0) visit(corner[m], scale * volume * of_corner[m]);
        });
        if (seen < volume_[cell]) visit(static_cast<int>(cell), volume_[cell] - seen);
    }

private:
    /// An edge as the centre of its face sees it.
    struct Edge {
        Vector gauge = Vector::Zero();  ///< gauge . (x - centre of the face) is 1 on the edge, or 0: not seen
        Vector along = Vector::Zero();  ///< along . (x - centre of the face) - middle runs from -1 to 1 on the edge
        double middle = 0;
        double area = 0;  ///< of the triangle between it and the centre of the face [m2]
    };
    /// The two tetrahedra of a side at an edge: the corner at its beginning, and at its end; and which of the corner's
    /// bits A, B and C belong to.
    struct Wedge {
        std::array<std::size_t, 2> corner{};
        std::array<std::array<unsigned char, 3>, 2> order{};
    };
    /// A side and an edge of its face, and what the point has reached.
    struct OnFace {
        std::size_t side, edge;
        double out, aside, along;
    };
    class CornerFinder;

    /// A cell between three pairs of parallel planes, as every box is: its coordinates need no search.
    struct BoxCell {
        std::array<Vector, 3> gauge;        ///< from -1 to 1 between two opposite faces
        std::array<std::size_t, 8> corner;  ///< by the bits of positive coordinates; its own bits are the axes
    };

    /// Without slope at 0, without curvature at 1, where two of them meet.
    static double smoothed(double t) { return 0.5 * t * t * (3 - t); }

    Place place_in_box(const Vector& x, std::size_t box) const
    {
        const BoxCell& at = boxes_[box];
        Place place{0, true, {}};
        unsigned octant = 0;
        for (unsigned axis = 0; axis < 3; ++axis) {
            const double t = at.gauge[axis].dot(x);
            octant |= (t > 0 ? 1u : 0u) << axis;
            place.smoothed[axis] = smoothed(std::min(std::abs(t), 1.0));
        }
        place.corner = at.corner[octant];
        return place;
    }
    Place place_in_tetrahedron(const Vector& x, std::size_t cell) const;

    static const std::array<double, 8>& means_of_products();  ///< over a tetrahedron
    static const std::array<double, 8>& means_of_cones();

    /// Bits that belong to A, B and C, as bits of a corner's joints.
    static std::size_t in_order_of(const std::array<unsigned char, 3>& order, std::size_t bits)
    {
        return (bits & 1 ? 1u << order[0] : 0u) | (bits & 2 ? 1u << order[1] : 0u) | (bits & 4 ? 1u << order[2] : 0u);
    }

    template <class Visit>
    void for_each_tetrahedron(std::size_t cell, Visit&& visit) const;

    std::size_t edges_of(std::size_t face) const { return first_edge_[face + 1] - first_edge_[face]; }
    void look_at_faces(const MeshView& mesh);
    void look_at_cells(const MeshView& mesh, const JointNumbering& joints);
    OnFace seen_from_cell(const Vector& x, std::size_t side) const;

    Vectors centre_;
    Scalars volume_;
    std::vector<char> has_simple_corners_;  ///< of each cell: three faces at each
    std::vector<std::size_t> first_side_;   ///< of each cell
    std::vector<Side> sides_;
    std::vector<Wedge> wedges_;
    std::vector<Corner> corners_;
    std::vector<int> box_of_cell_;  ///< its place in boxes_, or -1
    std::vector<BoxCell> boxes_;
    std::vector<std::size_t> first_edge_;  ///< of each face
    std::vector<Edge> edges_;
};

template <class Visit>
void CellSubdivision::for_each_tetrahedron(std::size_t cell, Visit&& visit) const
{
    for (std::size_t s = first_side_[cell]; s < first_side_[cell + 1]; ++s) {
        const double per_height = sides_[s].gauge.norm();
        if (!(per_height > 0)) continue;
        const auto face = static_cast<std::size_t>(sides_[s].face);
        for (std::size_t k = 0; k < edges_of(face); ++k)
            for (const std::size_t end : {0, 1})
                visit(2 * (sides_[s].first_wedge + k) + end, edges_[first_edge_[face] + k].area / (6 * per_height));
    }
}

}  // namespace interphase
