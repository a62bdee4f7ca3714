// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "support/whole_mesh.hpp"

namespace interphase::test {

/// Planes of boxes of side 1: `n` cells along each axis.
std::array<Scalars, 3> unit_planes(const std::array<int, 3>& n);

/// Boxes of side 1 whose inner corners are moved at random by up to `by` along each axis: their faces are not plane.
WholeMesh shaken_boxes(const std::array<int, 3>& n, double by, unsigned seed = 1);

/// Boxes of side 2, eight of side 1 in their place where `is_fine(i, j, k)`: a coarse cell has four faces towards fine
/// ones, and faces have corners in the middle of their sides where finer cells end.
WholeMesh refined_boxes(const std::array<int, 3>& n, const std::function<bool(int, int, int)>& is_fine);

/// Six tetrahedra in place of each box of side 1, about one of its diagonals (Kuhn, IBM J. Res. Dev. 4 (1960) 518).
WholeMesh tetrahedra(const std::array<int, 3>& n);

/// Two triangular prisms in place of each box of side 1.
WholeMesh prisms(const std::array<int, 3>& n);

/// Six pyramids in place of each box of side 1, on its sides, that meet at its centre.
WholeMesh pyramids(const std::array<int, 3>& n);

/// Prisms on regular hexagons of side 0.6, in rows.
WholeMesh hexagonal_prisms(const std::array<int, 3>& n);

/// Truncated octahedra about the points of a body-centred lattice of constant 1, `n` times two of them: fourteen faces
/// each.
WholeMesh truncated_octahedra(const std::array<int, 3>& n);

/// Blocks of 2 x 2 x 1 of which three quarters are one cell, shaped like an L: not convex.
WholeMesh l_shaped_cells(const std::array<int, 3>& n);

/// A baffle of no thickness where `is_baffle(centre)` of a face between two cells: two boundary faces with the same
/// corners.
WholeMesh with_baffle(WholeMesh mesh, const std::function<bool(const Vector&)>& is_baffle);

}  // namespace interphase::test
