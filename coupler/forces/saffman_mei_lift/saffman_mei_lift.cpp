// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/saffman_mei_lift/saffman_mei_lift.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace interphase {

namespace {

/// Above these the fit is not backed by its source; below Re = 0.1 and b = 0.005 it goes over into Saffman's limit, or
/// the lift is small.
constexpr double highest_reynolds = 100, highest_shear = 0.4;

double correction(double reynolds, double shear)
{
    constexpr double branch = 40;
    const double root = std::sqrt(shear);
    if (reynolds > branch) return 0.0524 * std::sqrt(shear * reynolds);
    return (1 - 0.3314 * root) * std::exp(-0.1 * reynolds) + 0.3314 * root;
}

}  // namespace

void SaffmanMeiLift::act(const ParticleInGas& at, Response& response)
{
    const Eigen::Matrix3d& g = at.velocity_gradient;
    const Vector curl(g(1, 2) - g(2, 1), g(2, 0) - g(0, 2), g(0, 1) - g(1, 0));
    const Vector slip = at.slip();
    const double rotation = curl.norm(), speed = slip.norm();
    if (!(rotation > 0 && speed > 0)) return;
    const double reynolds = at.slip_reynolds(), shear = 0.5 * rotation * at.diameter / speed;
    beyond_range_ += reynolds > highest_reynolds || shear > highest_shear;
    const double per_velocity = 1.615 * at.diameter * at.diameter * std::sqrt(at.density * at.viscosity / rotation);
    response.force += at.real_particles() * per_velocity * correction(reynolds, shear) * slip.cross(curl);
}

}  // namespace interphase
