// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fvMesh.H"
#include "step/gas.hpp"

namespace interphase {

/// Gives fields of the registry these values: made where they are not there yet, and written with the case's own. On
/// patches a field has the values of the cells at them. Collective.
void set_in_registry(const Foam::fvMesh& mesh, const std::vector<CellField>& fields);

}  // namespace interphase
