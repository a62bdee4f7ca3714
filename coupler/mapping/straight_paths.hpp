// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mapping/cell_subdivision.hpp"
#include "mapping/mesh_view.hpp"

namespace interphase {

/// Straight lines through the mesh, from cell to cell, as light goes: walls, baffles and the edge of the mesh throw
/// them back, cyclic pairs and faces to other ranks let them pass.
class StraightPaths {
public:
    StraightPaths(const MeshView& mesh, const CellSubdivision& subdivision);

    /// On the way from `at` to `to`, both from the centre of `cell` [m].
    struct Path {
        int cell;
        Vector at, to;
    };

    /// Follows a path to its end on this rank. Returns the face of this rank through which it leaves for another, or -1
    /// where it has arrived; a path that leaves has `at` and `to` from the centre of that face.
    int follow(Path& path) const;

    /// Continues a path that has come from another rank through `face`, with `at` and `to` from the centre of the face.
    Path enter(int face, const Vector& at, const Vector& to) const;

private:
    static constexpr int wall = -1, other_rank = -2;

    std::size_t exit_of(const Path& path, double& share) const;

    const CellSubdivision& subdivision_;
    std::vector<int> cell_of_side_;
    std::vector<int> beyond_;         ///< of each side: the side of the next cell, wall, or other_rank
    std::vector<int> side_of_owner_;  ///< of each face
};

}  // namespace interphase
