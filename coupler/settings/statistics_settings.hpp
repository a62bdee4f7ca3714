// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/vector.hpp"

namespace interphase {

/// What the block `statistics` of system/couplingDict asks for. What is not given is chosen by the scene
/// (statistics/statistics_scene.hpp). x goes across, y is the depth from the front wall on, z is up.
struct StatisticsSettings {
    double interval = 0;      ///< between two rows of /statistics [s]; 0: none
    double tap_interval = 0;  ///< between two rows of /taps [s]; 0: none

    struct Windows {
        bool wanted = true;
        double count = 0;                          ///< 0: by the scene
        std::optional<double> left, right;         ///< ends, x [m]
        std::optional<double> centre, height;      ///< middle, z, and height [m]
        std::optional<double> front, front_depth;  ///< wall, y, and depth of the slice behind it [m]
    } windows;

    struct Overlaps {
        bool wanted = true;
        Scalars shares{0.001, 0.01, 0.05};  ///< of the smaller diameter
    } overlaps;

    struct Voidage {
        bool wanted = true;
        double lowest = 0.3, highest = 1, bins = 70;  ///< of the histogram
        Scalars limits{0.4, 0.5, 0.8, 0.95};
    } voidage;

    struct Surface {
        bool wanted = true;
        double columns = 0;  ///< 0: by the scene
        double share = 0.99;
    } surface;

    struct Bubbles {
        bool wanted = true;
        double voidage = 0.8;
    } bubbles;

    struct Fields {
        bool wanted = false;
        std::optional<double> from;  ///< samples before it are left out [s]
    } fields;
};

}  // namespace interphase
