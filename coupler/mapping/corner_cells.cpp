// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/corner_cells.hpp"

#include <cmath>

namespace interphase {

namespace {

constexpr CornerCells::Cells uneven{{-1, -1, -1, -1, -1, -1, -1, -1}, {}};

/// Cells as far apart in size as the rounding of their corners makes them are alike.
constexpr double rounding = 1e-9;

CornerCells::Cells cells_around(const CellSubdivision::Corner& corner, const Joints& joints)
{
    CornerCells::Cells cells = uneven;
    cells.cell[0] = corner[0];
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (corner[1u << axis] < 0) return uneven;
        cells.open[axis] = joints.shares(corner[1u << axis]).size() > 1 ? 1.0 : 0.0;
    }
    for (const unsigned bits : {1u, 2u, 4u, 3u, 5u, 6u, 7u}) {
        std::size_t count = 1;
        bool is_there = true;
        for (unsigned axis = 0; axis < 3; ++axis) {
            if (!(bits >> axis & 1)) continue;
            if (cells.open[axis] > 0)
                count *= 2;
            else
                is_there = false;
        }
        const Joints::Shares shares = joints.shares(corner[bits]);
        if (shares.size() != count) return uneven;
        for (const Joints::Share& share : shares) {
            if (std::abs(share.part * static_cast<double>(count) - 1) > rounding) return uneven;
            bool is_known = false;
            for (unsigned some = 0; some < bits; ++some)
                is_known |= (some & bits) == some && cells.cell[some] == share.cell;
            if (!is_known && is_there) cells.cell[bits] = share.cell;
        }
        if (is_there && cells.cell[bits] < 0) return uneven;
    }
    return cells;
}

}  // namespace

CornerCells::CornerCells(const CellSubdivision& subdivision, const Joints& joints)
{
    for (std::size_t n = 0; n < subdivision.corners(); ++n) {
        const CellSubdivision::Corner& corner = subdivision.corner(n);
        cells_.push_back(joints.place_in_shared(corner[7]) >= 0 ? uneven : cells_around(corner, joints));
    }
}

}  // namespace interphase
