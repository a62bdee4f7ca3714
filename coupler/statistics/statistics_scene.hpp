// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/archive.hpp"
#include "base/communicator.hpp"
#include "base/vector.hpp"
#include "mapping/mesh_view.hpp"
#include "settings/statistics_settings.hpp"
#include "step/solids.hpp"

namespace interphase {

/// `count` windows side by side in x from `left` to `right`, `height` high about z = `centre`, and a slice of
/// `front_depth` behind a front wall at y = `front` [m].
struct SampleWindows {
    double count, left, right, centre, height, front, front_depth;

    double edge(std::size_t n) const
    {
        return n == windows() ? right : left + static_cast<double>(n) * ((right - left) / count);
    }
    std::size_t windows() const { return static_cast<std::size_t>(count); }
    double low() const { return centre - height / 2; }
};

/// The vessel, and the spheres in it.
struct Bed {
    Box vessel = empty_box();         ///< around the gas mesh, else the particles' domain, else around all spheres [m]
    double count = 0;                 ///< spheres
    double largest = 0, mean = 0;     ///< diameter, and that of the mean volume [m]
    double middle = 0;                ///< mean height of their volume, z [m]
    Vector gravity = Vector::Zero();  ///< [m/s2]
};

/// What there is now; `gas_bounds` null: no gas. Where no sphere is there, diameters are those that are to come.
/// Collective.
Bed bed_of(const Communicator& comm, Solids& solids, const Box* gas_bounds);

/// What is sampled, all of it chosen: the windows (none where none are wanted), and the columns of the surface.
struct StatisticsScene {
    std::optional<SampleWindows> windows;
    Box vessel = empty_box();  ///< [m]
    double columns = 0;        ///< across x, of the surface

    void keep(Archive& archive);
};

/// By what is given, and for the rest by the bed. Throws a UserError where a window is empty or has no part in the
/// vessel, where there is no sphere to tell where windows belong, or where what takes z as up is asked for and gravity
/// has its largest part along another axis, or up. `mesh` null: no gas. Collective.
StatisticsScene scene_of(const Communicator& comm, const StatisticsSettings& settings, const Bed& bed,
                         const MeshView* mesh);

/// Of a gas mesh, the mean side of the box around a cell along an axis, by volume [m]. Collective.
double mean_extent(const Communicator& comm, const MeshView& mesh, int axis);

}  // namespace interphase
