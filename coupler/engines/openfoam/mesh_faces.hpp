// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fvMesh.H"
#include "mapping/mesh_view.hpp"

namespace interphase {

/// The faces of this rank's part, numbered as mesh.faces(). Halves of a face are found on processor, cyclic and
/// processorCyclic patches; every other patch is a boundary. Throws a UserError where patches are coupled by anything
/// but a translation of equal faces. Collective.
std::vector<MeshView::Face> mesh_faces(const Foam::fvMesh& mesh);

}  // namespace interphase
