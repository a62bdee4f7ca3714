// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/lockstep_clock.hpp"

#include <algorithm>
#include <cmath>

namespace interphase {

namespace {

/// Relative slack for ratios of steps that are whole numbers but for round-off.
constexpr double slack = 1e-6;

}  // namespace

GasStep LockstepClock::next(double wanted, double remaining) const
{
    const double fitting = std::floor(wanted / solid_step_ + slack);
    const double left = std::ceil(remaining / solid_step_ - slack);
    const int substeps = static_cast<int>(std::max(1.0, std::min(fitting, left)));
    return {substeps, substeps * solid_step_};
}

double dividing_step(double gas_step, double most)
{
    return gas_step / std::max(1.0, std::ceil(gas_step / most - slack));
}

}  // namespace interphase
