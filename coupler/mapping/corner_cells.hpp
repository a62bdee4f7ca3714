// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mapping/cell_subdivision.hpp"
#include "mapping/joints.hpp"

namespace interphase {

/// Where the weights of cells are the plain products that they are on a uniform grid of boxes: the corners at which
/// cells of this rank meet that share its joints evenly, eight of them, or four, two or one where walls cut it off. A
/// short cut for what the joints' shares say, no other weights.
class CornerCells {
public:
    CornerCells(const CellSubdivision& subdivision, const Joints& joints);

    /// The cells across the corner's faces by the bits of their number: 1, 2, 4 across one face, 3, 5, 6 across two, 7
    /// across all three, 0 the corner's own; -1 across a wall.
    struct Cells {
        std::array<int, 8> cell;
        std::array<double, 3> open;  ///< 1, or 0 where the face is a wall
        bool is_even() const { return cell[0] >= 0; }
    };
    const Cells& at(std::size_t corner) const { return cells_[corner]; }

private:
    std::vector<Cells> cells_;
};

}  // namespace interphase
