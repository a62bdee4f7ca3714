// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/drag/dalla_valle.hpp"

#include <cmath>

namespace interphase {

double dalla_valle_over_stokes(double reynolds)
{
    const double root = 0.63 * std::sqrt(reynolds) + 4.8;
    return root * root / 24.0;
}

}  // namespace interphase
