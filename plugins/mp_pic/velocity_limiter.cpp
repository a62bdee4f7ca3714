// SPDX-License-Identifier: GPL-3.0-or-later
#include "mp_pic/velocity_limiter.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace interphase::mp_pic {

namespace {

/// max(0, x), to the last bit, without a branch: which way a parcel moves is a coin toss that no processor predicts.
double positive_part(double x) { return 0.5 * (x + std::abs(x)); }

}  // namespace

Vector stress_change(const StressState& state, double density, double dt)
{
    if (state.solid_fraction <= 0) return Vector::Zero();
    const double per_slope = -dt / (density * state.solid_fraction * (1 + dt / state.relaxation_time));
    return per_slope * to_vector(state.gradient);
}

double limited_change(double change, double slope, const Approach& approach, double restitution)
{
    const double sense = std::copysign(1.0, -slope);  // of the stress's force
    const double to_stop = sense * approach.to_mean + approach.closing;
    const double most = to_stop + restitution * positive_part(std::min(sense * approach.before, to_stop));
    return sense * positive_part(std::min(sense * change, most));
}

Vector limited_stress_change(const StressState& state, const Vector& before, const Vector& velocity, double density,
                             double restitution, double dt)
{
    Vector change = stress_change(state, density, dt);
    for (int axis = 0; axis < 3; ++axis) {
        const double mean = state.mean_velocity[axis];
        change[axis] =
            limited_change(change[axis], state.gradient[axis],
                           {mean - velocity[axis], mean - before[axis], state.closing_speed[axis]}, restitution);
    }
    return change;
}

LongestStep longest_step(const StressState& state, const Vector& velocity, double courant, double share)
{
    LongestStep longest{DBL_MAX, DBL_MAX};
    for (int axis = 0; axis < 3; ++axis) {
        const double speed = std::abs(velocity[axis]);
        if (state.cell_size[axis] > 0 && speed * 1e100 > state.cell_size[axis])  // no overflow
            longest.crossing = std::min(longest.crossing, courant * state.cell_size[axis] / speed);
    }
    if (state.relaxation_time > 0 && state.relaxation_time < DBL_MAX)
        longest.relaxation = share * state.relaxation_time;
    return longest;
}

}  // namespace interphase::mp_pic
