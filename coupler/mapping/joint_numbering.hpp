// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/communicator.hpp"
#include "mapping/mesh_view.hpp"

namespace interphase {

/// Which faces, edges and corners of cells are one and the same when cells that share a face are glued together: labels
/// that agree on all ranks.
///
/// Every cell has its own copy of its faces, edges and corners at first. Each face between two cells glues the copies on
/// its two sides; the lowest label spreads, first on the rank, then across the faces that have their other half
/// elsewhere, until nothing changes.
class JointNumbering {
public:
    /// Collective.
    JointNumbering(const Communicator& comm, const MeshView& mesh);

    /// Labels of each face; and of its edges and corners, [faces, corners of each]. Edge k leads from corner k to the
    /// next.
    std::vector<std::int64_t> of_face, of_edge, of_corner;

    /// Labels from first_of_rank[r] to below first_of_rank[r + 1] began on rank r.
    std::vector<std::int64_t> first_of_rank;

private:
    using Copies = std::vector<std::size_t>;

    /// The copies of one side of a face: itself, its corners, its edges, in the turn of its points.
    void number_copies(const MeshView& mesh);
    void glue(std::size_t a, std::size_t b);
    std::size_t root(std::size_t copy);
    void spread_across_ranks(const Communicator& comm, const MeshView& mesh);

    std::vector<Copies> owner_side_, neighbour_side_;  ///< of each face
    std::vector<std::size_t> parent_;                  ///< of each copy
    std::vector<std::int64_t> label_;                  ///< of each root
};

}  // namespace interphase
