// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/gas_step_choice.hpp"

#include <algorithm>

namespace interphase {

double adjusted_gas_step(const GasStepLimits& limits)
{
    if (limits.courant <= 0) return std::min(limits.last, limits.largest);
    const double grown = std::max(1.2 * limits.last, limits.last + limits.solid_step);
    return std::min({limits.last * limits.largest_courant / limits.courant, grown, limits.largest});
}

}  // namespace interphase
