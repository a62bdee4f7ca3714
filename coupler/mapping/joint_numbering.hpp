// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/communicator.hpp"
#include "mapping/mesh_view.hpp"

namespace interphase {

/// Which faces, edges and corners of cells are one and the same when cells that share a face are glued together: the
/// joints of the mesh, with each cell's own centre beside them.
///
/// Every cell has its own copy of its faces, edges and corners at first. Each face between two cells glues the copies
/// on its two sides; the lowest label spreads, first on the rank, then across the faces that have their other half
/// elsewhere, until nothing changes. So a wall or a baffle parts the cells on its sides, and faces of processor and
/// cyclic patches join them.
class JointNumbering {
public:
    /// Collective.
    JointNumbering(const Communicator& comm, const MeshView& mesh);

    /// Joints of this rank. Cell c's centre is joint c.
    std::size_t count() const { return label_of_joint_.size(); }
    int of_face(int face) const { return of_face_[static_cast<std::size_t>(face)]; }
    /// Edge k of a face leads from its corner k to the next.
    int of_edge(int face, int k) const { return of_edge_[slot(face, k)]; }
    int of_corner(int face, int k) const { return of_corner_[slot(face, k)]; }

    /// Whether the joint lies on a face whose other half is elsewhere, so that other ranks may know it.
    bool is_at_other_half(int joint) const { return at_other_half_[static_cast<std::size_t>(joint)]; }
    /// The same on all ranks that know the joint.
    std::int64_t label(int joint) const { return label_of_joint_[static_cast<std::size_t>(joint)]; }
    /// The rank on which a label began, which knows its joint.
    int home(std::int64_t label) const;

private:
    using Copies = std::vector<std::size_t>;

    std::size_t slot(int face, int k) const
    {
        return first_corner_[static_cast<std::size_t>(face)] + static_cast<std::size_t>(k);
    }
    /// The copies of one side of a face: itself, its corners, its edges, in the turn of its points.
    void number_copies(const MeshView& mesh);
    void glue(std::size_t a, std::size_t b);
    std::size_t root(std::size_t copy);
    void spread_across_ranks(const Communicator& comm, const MeshView& mesh);
    void number_joints(const MeshView& mesh);

    std::vector<Copies> owner_side_, neighbour_side_;  ///< of each face
    std::vector<std::size_t> parent_;                  ///< of each copy
    std::vector<std::int64_t> label_;                  ///< of each root
    std::vector<std::int64_t> first_of_rank_;          ///< label of each rank, and one past the last

    std::vector<std::size_t> first_corner_;  ///< of each face
    std::vector<int> of_face_, of_edge_, of_corner_;
    std::vector<std::int64_t> label_of_joint_;
    std::vector<bool> at_other_half_;
};

}  // namespace interphase
