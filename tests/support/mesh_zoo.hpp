// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// One mesh of each kind, about a hundred cells of about unit size each.
std::vector<NamedMesh> mesh_zoo();

/// Those with plane faces; and of these, those with convex cells.
std::vector<NamedMesh> plane_meshes();
std::vector<NamedMesh> convex_meshes();

}  // namespace interphase::test
