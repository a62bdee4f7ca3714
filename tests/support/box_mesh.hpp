// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "base/communicator.hpp"
#include "exchange/cell_locator.hpp"
#include "mapping/mesh_view.hpp"

namespace interphase::test {

/// A box of nx x ny x nz cells between planes normal to the axes, cut into slabs along one axis: rank r of the
/// communicator owns slab r. What an engine's mesh is to the coupler, with every answer known in closed form.
class BoxMesh : public CellLocator {
public:
    using Planes = std::array<Scalars, 3>;

    /// `planes`: coordinates along each axis [m], ascending. Needs at least as many layers along `cut` as ranks. Across
    /// a `periodic` axis the sides are a cyclic pair.
    BoxMesh(const Communicator& comm, Planes planes, int cut, const std::array<bool, 3>& periodic = {});

    const MeshView& view() const { return view_; }
    CellAddress walk(const Vector& point, int start) const override;
    CellAddress search(const Vector& point) const override;
    NearCell nearest(const Vector& point, double reach) const override;
    Box bounds() const override { return bounds_; }

    /// The cell that holds a point, on whichever rank; unknown outside the box.
    CellAddress address_of(const Vector& point) const;

    /// Whether the (closed) cell holds the point.
    bool holds(const CellAddress& address, const Vector& point) const;

    /// This rank's cell as counted over all ranks, whatever their number.
    std::size_t global_number(std::size_t own) const;
    std::size_t global_count() const;

    Box whole() const;

    /// In this rank's cells [n x 3], of values [global_count] that are linear between the centres, and at the sides of
    /// the box `at_sides`, or without slope.
    Scalars gradient(const Scalars& of_all_cells, std::optional<double> at_sides = std::nullopt) const;

private:
    using Index = std::array<int, 3>;

    int layers(int axis) const { return static_cast<int>(planes_[static_cast<std::size_t>(axis)].size()) - 1; }
    int first_layer(int rank) const { return layers(cut_) * rank / ranks_; }
    int rank_of_layer(int layer) const;
    Index index_of(const CellAddress& address) const;
    CellAddress address_of(const Index& index) const;

    Planes planes_;
    int cut_;
    int rank_;
    int ranks_;
    MeshView view_;
    Box bounds_ = empty_box();
};

/// `cells` + 1 planes, evenly spaced.
Scalars even_planes(double low, double high, int cells);

/// The same, each layer `ratio` times as thick as the one before.
Scalars graded_planes(double low, double high, int cells, double ratio);

}  // namespace interphase::test
