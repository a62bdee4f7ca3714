// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace interphase {

/// [m3] of a radius [m].
inline double sphere_volume(double radius) { return 4.0 / 3.0 * M_PI * radius * radius * radius; }

}  // namespace interphase
