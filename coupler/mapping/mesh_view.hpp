// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vector.hpp"

namespace interphase {

/// What the mapping needs to know of a rank's gas cells: [n] centres [m], extents (the sides of the box around the
/// cell) [m] and volumes [m3], and the faces that bound them.
struct MeshView {
    Vectors centre;
    Vectors extent;
    Scalars volume;

    Vectors points;  ///< corners of faces [m]

    /// A face between two cells of this rank, one half of a face whose other half lies elsewhere (on another rank, or
    /// across a cyclic pair), or a boundary.
    struct Face {
        Vector centre;            ///< [m]
        Vector area;              ///< normal vector that points out of `owner` [m2]
        std::vector<int> points;  ///< its corners, in a right-handed turn about `area`
        int owner;                ///< cell
        int neighbour = -1;       ///< cell of this rank behind it, or none
        /// The other half: its rank, and its number among the faces there. Its corners are this one's, turned the other
        /// way, from the same first.
        int partner_rank = -1;
        int partner = -1;
    };
    std::vector<Face> faces;

    std::size_t size() const { return volume.size(); }

    /// Numbers of the faces of each cell, ascending.
    std::vector<std::vector<int>> faces_of_cells() const;
    /// Numbers of the faces whose other half is on each of `ranks` ranks (this one's where a cyclic pair is on it).
    std::vector<std::vector<std::size_t>> halves_by_rank(int ranks) const;
};

}  // namespace interphase
