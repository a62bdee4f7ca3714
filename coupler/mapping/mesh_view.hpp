// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vector.hpp"

namespace interphase {

/// What the mapping needs to know of a rank's gas cells: [n] centres [m], extents (the sides of the box around the
/// cell) [m] and volumes [m3].
struct MeshView {
    Vectors centre;
    Vectors extent;
    Scalars volume;

    std::size_t size() const { return volume.size(); }
};

}  // namespace interphase
