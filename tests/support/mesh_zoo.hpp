// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <ostream>
#include <string>

#include "support/mesh_shapes.hpp"

namespace interphase::test {

/// A mesh that properties of the mapping are shown on.
struct NamedMesh {
    std::string name;
    WholeMesh mesh;
    bool plane = true;   ///< whether its faces are
    bool convex = true;  ///< whether its cells are
};

inline void PrintTo(const NamedMesh& named, std::ostream* out) { *out << named.name; }

/// Blocks of "lShaped", the one mesh of cells that are not convex.
constexpr std::array<int, 3> l_shaped_blocks{4, 3, 4};

/// One mesh of each kind, about a hundred cells of about unit size each.
std::vector<NamedMesh> mesh_zoo();

/// Those with plane faces.
std::vector<NamedMesh> plane_meshes();

}  // namespace interphase::test
