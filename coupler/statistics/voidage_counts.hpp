// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/communicator.hpp"
#include "mapping/mesh_view.hpp"

namespace interphase {

/// Number of cells in each bin between ascending edges, with those below and above [edges + 1]. Collective.
Scalars voidage_counts(const Communicator& comm, const Scalars& voidage, const Scalars& edges);

/// Horizontal layers of a vessel, as thick as its cells are high in the mean, at most 100 and 1 at least.
class Layers {
public:
    /// Collective.
    Layers(const Communicator& comm, const MeshView& mesh, const Box& vessel);

    std::size_t count() const { return edges_.size() - 1; }
    const Scalars& edges() const { return edges_; }  ///< z [m]

    /// Mean voidage of each layer, by the volume that cells have in it; NaN where none has any. Collective.
    Scalars means(const Communicator& comm, const Scalars& voidage) const;

private:
    struct Share {
        std::size_t cell, layer;
        double volume;  ///< [m3]
    };
    Scalars edges_, volume_;
    std::vector<Share> shares_;
};

}  // namespace interphase
