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

/// Finds the gas cell that holds a point, on the rank that owns a part of the mesh.
class CellLocator {
public:
    virtual ~CellLocator() = default;

    /// Starts at this rank's cell `start` and walks. Returns this rank's cell, another rank's cell to go on from
    /// (the walk left through a processor boundary), or an unknown address where the point lies in none of this
    /// rank's cells.
    virtual CellAddress walk(const Vector& point, int start) const = 0;

    /// Searches this rank's whole part of the mesh; unknown where the point is not in it.
    virtual CellAddress search(const Vector& point) const = 0;

    /// The box around this rank's part of the mesh [m].
    virtual Box bounds() const = 0;
};

}  // namespace interphase
