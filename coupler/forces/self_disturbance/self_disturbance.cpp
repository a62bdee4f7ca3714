// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/self_disturbance/self_disturbance.hpp"

namespace interphase {

namespace {

const double root_pi = std::sqrt(M_PI);

/// Velocity per force in Stokes flow [m/s/N], at a kernel of this volume [m3] on cells of that.
double on_mesh(double kernel_volume, double cell_volume, double viscosity)
{
    return excess_on_mesh(kernel_volume / cell_volume) /
           (6 * M_PI * root_pi * viscosity * kernel_deviation(kernel_volume));
}

/// How much of what changes from place to place in a cell of size h the gas has time for, while a particle passes: it
/// varies as exp(2 pi i x/h), and dies away at the rate of the shortest wave on the mesh, (pi/h)^2 mu/rho.
double followed_by_gas(const ParticleInGas& at, double h)
{
    const double passing = 2 / M_PI * at.density * at.velocity.norm() * h / at.viscosity;
    return 1 / (1 + passing * passing);
}

double long_wave_structure_factor(double solid_fraction)
{
    const double gas = 1 - solid_fraction, crowd = 1 + 2 * solid_fraction;
    return gas * gas * gas * gas / (crowd * crowd);
}

}  // namespace

double share_in_stream(double reynolds)
{
    const double slow = 3 * root_pi / 8, fast = 3 * root_pi / 4;  // 1 - slow Re, fast/Re
    constexpr double between = 0.5381;                            // least squares of the relative error
    const double more = 1 + between * reynolds;
    return more / (more + slow * reynolds + between / fast * reynolds * reynolds);
}

double share_in_packing(double x)
{
    constexpr double a = 0.4872, b = 1.906;  // least squares; the ends are 1 - sqrt(pi) x and 1/(2 x^2)
    const double more = 1 + a * x;
    return more / (more + root_pi * x + b * x * x + 2 * a * x * x * x);
}

double isolation(double solid_fraction)
{
    if (!(solid_fraction < SelfDisturbance::crowded)) return 0;
    static const double at_none = long_wave_structure_factor(SelfDisturbance::crowded);
    return (long_wave_structure_factor(solid_fraction) - at_none) / (1 - at_none);
}

bool SelfDisturbance::may_matter(const ParticleInGas& at)
{
    const double own_fraction = at.volume / at.real_particles() / at.cell_volume;
    const double own = isolation(std::max(0.0, 1 - at.voidage - margin * own_fraction));
    if (own * own_fraction > negligible) return true;
    if (own == 0) return false;
    const double width = at.cell_size / (std::sqrt(4 * M_PI) * at.diameter);  // kernel_deviation() of the cell's volume
    const double reynolds = at.slip_reynolds();
    const double root = std::sqrt(reynolds), above = std::max(1.0, root * std::sqrt(root));  // Re^0.75 for Re^0.687
    const double drag = 3 * M_PI * (1 + 0.15 * above);                                       // of mu d
    constexpr double excess = 2;                                                             // excess_on_mesh(1)
    const double most_on_mesh = excess / (6 * M_PI * root_pi * width);
    return own * drag * most_on_mesh * share_in_stream(reynolds * width) > negligible;
}

SelfDisturbance::SelfDisturbance(const ParticleInGas& at) : at_(at), voidage_(at.voidage)
{
    if (!(at.kernel_volume.here > 0)) return;
    // Of a parcel's real particles, which stand somewhere about it, each has its own part and the rest are others.
    real_particles_ = at.real_particles();
    const double own_fraction = at.volume / real_particles_ / at.kernel_volume.here, seen = 1 - at.voidage;
    const auto others = [&](double own) { return std::max(0.0, seen - margin * own * own_fraction); };
    solids_around_ = others(isolation(others(1.0)));
    own_ = isolation(solids_around_);
    if (own_ == 0) return;
    voidage_ = 1 - solids_around_;

    const Vector slip = at.slip();
    if (slip.squaredNorm() > 0) speed_against_slip_ = -at.velocity.dot(slip) / slip.norm();
    const double along =
        slip.squaredNorm() > 0 ? slip.cwiseAbs().dot(at.cell_extent) / slip.norm() : at.cell_extent.maxCoeff();
    const double crowding = 1 / at.kernel_volume.here, on_its_way = 1 / at.kernel_volume.on_its_way;
    const double volume = 1 / (on_its_way + followed_by_gas(at, along) * (crowding - on_its_way));
    deviation_ = kernel_deviation(volume);
    // Of the force k (u - v) the gas solve takes k u where it is, and k v over the faces, which smooths it along itself
    // by (1, 2, 1)/4 of the neighbours: a variance of half a cell's square, on one of the two sides of the overlap.
    const double smoothed = volume * std::sqrt(1 + 0.25 * along * along / (deviation_ * deviation_));
    in_cells_ = own_ * on_mesh(volume, at.cell_volume, at.viscosity);
    at_faces_ = own_ * on_mesh(smoothed, at.cell_volume, at.viscosity);

    // The gas is pushed aside by the particle and dragged along by it. Of fields without divergence it is two thirds
    // that one sees at the source, of gradients one third: of the way that it makes, and of the pressure.
    widening_ = 1 + own_ * own_fraction / 3;
    pressed_ = 1 - own_ * own_fraction / 3;
}

double SelfDisturbance::velocity_per_force(double slip_speed, double rate) const
{
    const double reynolds = at_.density * voidage_ * slip_speed * deviation_ / at_.viscosity;
    const double drag_around = solids_around_ * rate / at_.volume;  // [kg/(m3 s)]
    const double share = share_in_stream_through_packing(reynolds, deviation_ * std::sqrt(drag_around / at_.viscosity));
    const double fall = slip_speed > 0 ? std::clamp(speed_against_slip_ / slip_speed, 0.0, 1.0) : 0.0;
    return share * (in_cells_ + fall * (at_faces_ - in_cells_));
}

}  // namespace interphase
