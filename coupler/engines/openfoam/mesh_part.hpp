// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "exchange/cell_locator.hpp"
#include "fvMesh.H"
#include "mapping/mesh_view.hpp"

namespace interphase {

/// This rank's part of a static OpenFOAM mesh, laid out for the coupler.
class MeshPart : public CellLocator {
public:
    /// Throws a UserError for patches that mesh_faces refuses. Collective.
    explicit MeshPart(const Foam::fvMesh& mesh);

    const MeshView& view() const { return view_; }

    CellAddress walk(const Vector& point, int start) const override;
    CellAddress search(const Vector& point) const override;
    Box bounds() const override { return bounds_; }

private:
    /// A face as seen from one of its cells.
    struct Side {
        Vector outward;      ///< unit normal of its plane
        double offset;       ///< outward . x on the plane
        CellAddress beyond;  ///< unknown at a boundary of the mesh

        double distance(const Vector& point) const { return outward.dot(point) - offset; }
    };

    void measure_cells();
    void collect_sides();

    const Foam::fvMesh& mesh_;
    MeshView view_;
    Box bounds_ = empty_box();
    std::vector<std::size_t> first_side_;
    std::vector<Side> sides_;
};

}  // namespace interphase
