// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase {

/// Which gas cells a particle belongs to: those that its kernel reaches, or the one that holds its centre.
enum class MappingType { kernel, cell_centre };

/// How particles are mapped to cells.
struct MappingRules {
    MappingType type = MappingType::kernel;
    /// Width at half height of a kernel [diameter of the tracked sphere], where cells are narrower than `wide_enough`
    /// of it.
    double width_in_diameters = 2.5;
    static constexpr double wide_enough = 0.8;
    double width = 0;               ///< above 0: that least width for all, whatever their size [m]
    double maximum_packing = 0.74;  ///< solid fraction above which a cell hands its excess to its neighbours
};

}  // namespace interphase
