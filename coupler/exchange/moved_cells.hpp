// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "exchange/cell_locator.hpp"

namespace interphase {

/// Addresses of cells among the ranks that a state was taken in by become those of the same cells now, by the
/// archive's moved_cells(), which there must be; unknown ones stay unknown. Throws a std::runtime_error where a cell is
/// nowhere. Collective.
void move_addresses(const Communicator& comm, const Archive& archive, std::vector<CellAddress>& addresses);

}  // namespace interphase
