// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase::hard_sphere {

struct StepLimits {
    double step;           ///< [s]
    double margin;         ///< bodies that pass each other by more than this are no contact [m]
    double touching;       ///< those nearer than this are in touch, the others may be pushed so by their neighbours [m]
    double tolerated;      ///< overlap that may stay [m]
    double relief;         ///< share of the overlap beyond that which a step takes away
    double resting_speed;  ///< approach below which restitution does not apply [m/s]
    double farthest;       ///< no sphere moves by more than this in the step [m]
};

}  // namespace interphase::hard_sphere
