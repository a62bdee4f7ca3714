// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "exchange/cell_locator.hpp"
#include "fvMesh.H"
#include "indexedOctree.H"
#include "mapping/cell_surfaces.hpp"
#include "mapping/mesh_view.hpp"
#include "treeDataFace.H"

namespace interphase {

/// This rank's part of a static OpenFOAM mesh, laid out for the coupler.
class MeshPart : public CellLocator {
public:
    /// Throws a UserError for patches that mesh_faces refuses. Collective.
    explicit MeshPart(const Foam::fvMesh& mesh);

    const MeshView& view() const { return view_; }
    /// By how far cyclic pairs move what passes them, each way once [m]; the same on all ranks.
    const Vectors& translations() const { return translations_; }

    CellAddress walk(const Vector& point, int start) const override;
    CellAddress search(const Vector& point) const override;
    NearCell nearest(const Vector& point, double reach) const override;
    Box bounds() const override { return bounds_; }

private:
    void measure_cells();
    void find_ways_on();
    void find_translations();
    void plant_tree_of_edge();
    int cell_that_holds(const Vector& point) const;

    const Foam::fvMesh& mesh_;
    MeshView view_;
    Box bounds_ = empty_box();
    std::optional<CellSurfaces> surfaces_;
    Vectors translations_;
    std::vector<CellAddress> beyond_;  ///< the neighbour of an inner face, what lies across a cut; else unknown
    std::unique_ptr<Foam::indexedOctree<Foam::treeDataFace>> edge_;  ///< faces behind which there is no mesh
};

}  // namespace interphase
