// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mapping/mesh_view.hpp"

namespace interphase {

/// Tells which cell holds a point, so that every point of the mesh is in one cell, whatever the cells' shapes and
/// whichever rank is asked: the surface between two cells is the same seen from both.
///
/// The surface of a convex cell with plane faces is their planes. Of any other it is made of triangles between the
/// centre of a face and its edges, as warped faces leave gaps and overlaps between their planes; the point is inside
/// where the surface winds round it (sum of signed tetrahedra over the cell's centre).
class CellSurfaces {
public:
    explicit CellSurfaces(const MeshView& mesh);

    /// A face of a cell, as seen from it.
    struct Side {
        Vector outward;  ///< unit normal of its plane
        double offset;   ///< outward . x on the plane
        int face;
        double warp = 0;  ///< how far its corners lie off the plane at most [m]

        double distance(const Vector& point) const { return outward.dot(point) - offset; }
    };
    const Side* begin(std::size_t cell) const { return sides_.data() + first_[cell]; }
    const Side* end(std::size_t cell) const { return sides_.data() + first_[cell + 1]; }

    bool holds(const Vector& point, std::size_t cell) const;

    /// Where a point outside of a cell is passed: the side whose plane it is farthest beyond, among those that
    /// `may_pass(side)`; null where there is none.
    template <class MayPass>
    const Side* way_out(const Vector& point, std::size_t cell, MayPass&& may_pass) const
    {
        const Side* exit = nullptr;
        double farthest = 0;
        for (const Side* side = begin(cell); side != end(cell); ++side) {
            const double distance = side->distance(point);
            if (distance <= farthest || !may_pass(*side)) continue;
            farthest = distance;
            exit = side;
        }
        return exit;
    }

private:
    void add_sides(std::size_t cell, const std::vector<int>& faces);
    bool is_convex(std::size_t cell) const;
    bool is_inside_planes(const Vector& point, std::size_t cell) const;
    int winding(const Vector& point, std::size_t cell) const;

    const MeshView& mesh_;
    std::vector<std::size_t> first_;
    std::vector<Side> sides_;
    std::vector<char> is_plane_;  ///< of each cell: convex, with plane faces
};

}  // namespace interphase
