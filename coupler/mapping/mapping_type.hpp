// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase {

/// Which gas cells a particle belongs to: those that its kernel reaches, or the one that holds its centre.
enum class MappingType { kernel, cell_centre };

/// How particles are mapped to cells.
struct MappingRules {
    MappingType type = MappingType::kernel;
    double width_in_diameters = 2;  ///< least width at half height of a kernel [diameter of the tracked sphere]
    double width = 0;               ///< above 0: that width for all, whatever their size [m]
    double maximum_packing = 0.74;  ///< solid fraction above which a cell hands its excess to its neighbours
};

}  // namespace interphase
