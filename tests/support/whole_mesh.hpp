// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mapping/mesh_view.hpp"

namespace interphase::test {

/// A mesh of polyhedra as a whole, from which any rank can cut its part: what an engine's mesh is to the coupler, for
/// cells of any shape.
struct WholeMesh {
    struct Face {
        std::vector<int> points;  ///< in a right-handed turn about the normal that points out of `owner`
        int owner;
        int neighbour = -1;  ///< none at a boundary
        int twin = -1;       ///< the other face of a cyclic pair, with the same corners in the other turn
    };
    Vectors points;
    std::vector<Face> faces;
    std::size_t cells = 0;

    /// Cells as lists of their faces, each a list of points in a right-handed turn about the outward normal. Faces with
    /// the same points become one.
    static WholeMesh of_cells(Vectors points, const std::vector<std::vector<std::vector<int>>>& cells);

    /// A box of cells between planes normal to the axes, x fastest; across a periodic axis the two sides are a cyclic
    /// pair.
    static WholeMesh of_boxes(const std::array<Scalars, 3>& planes, const std::array<bool, 3>& periodic = {});

    /// Makes boundary faces that are each other's image, moved by `shift`, cyclic pairs.
    void glue_sides(const Vector& shift);

    /// What rank `rank` has of it, if cell c is cell number_on[c] of rank rank_of[c].
    MeshView part(const std::vector<int>& rank_of, const std::vector<int>& number_on, int rank) const;
};

}  // namespace interphase::test
