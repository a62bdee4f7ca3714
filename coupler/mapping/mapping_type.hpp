// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase {

/// Which gas cells a particle belongs to: those that its kernel reaches, or the one that holds its centre.
enum class MappingType { kernel, cell_centre };

}  // namespace interphase
