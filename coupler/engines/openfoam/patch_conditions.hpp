// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fvMesh.H"

namespace interphase {

/// A UserError for a boundary condition of U or p_rgh, in the registry of the mesh, that cannot be right for an
/// incompressible gas whose pressure is p_rgh, with what to take in its place.
void refuse_unfit_conditions(const Foam::fvMesh& mesh);

/// Boundary conditions of U with random numbers that a checkpoint does not hold: "turbulentDFSEMInlet of patch inlet".
std::vector<std::string> conditions_not_kept(const Foam::fvMesh& mesh);

/// Where the boundary condition stands that fails with OpenFOAM's `message`, type and patch; empty where it is none or
/// cannot be known. For messages that all ranks have.
std::string failing_condition(const Foam::fvMesh& mesh, const std::string& message);

}  // namespace interphase
