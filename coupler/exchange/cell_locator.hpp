// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vector.hpp"

namespace interphase {

/// A gas cell and the rank that owns it.
struct CellAddress {
    int rank = -1;
    int cell = -1;

    bool known() const { return rank >= 0; }
};

/// A cell of this rank at the edge of the mesh, or none (-1), and how far it is [m].
struct NearCell {
    int cell = -1;
    double distance = 0;
};

/// Finds the gas cell that holds a point, on the rank that owns a part of the mesh.
class CellLocator {
public:
    virtual ~CellLocator() = default;

    /// Starts at this rank's cell `start` and walks. Returns this rank's cell, another rank's cell to go on from
    /// (the walk left through a processor boundary), or an unknown address where the point lies in none of this
    /// rank's cells.
    virtual CellAddress walk(const Vector& point, int start) const = 0;

    /// Searches this rank's whole part of the mesh; unknown where the point is not in it. A point of the mesh is found
    /// by one rank, in the cell that walks to it end in.
    virtual CellAddress search(const Vector& point) const = 0;

    /// For a point outside of the mesh: this rank's cell at the nearest place of the mesh's edge, no farther than
    /// `reach` [m].
    virtual NearCell nearest(const Vector& point, double reach) const = 0;

    /// The box around this rank's part of the mesh [m].
    virtual Box bounds() const = 0;
};

}  // namespace interphase
