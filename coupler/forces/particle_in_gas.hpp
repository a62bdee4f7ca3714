// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "base/vector.hpp"
#include "mapping/kernel_volume.hpp"

namespace interphase {

/// A particle and the gas around it at the start of a gas step: what interphase terms look at. All in SI units.
struct ParticleInGas {
    // the particle
    Vector velocity = Vector::Zero();     ///< with which it begins the step
    double diameter = 0;                  ///< of the real particle
    double volume = 0;                    ///< of solids in the tracked one
    double mass = 0;                      ///< of the tracked one
    double held = 0;                      ///< how far contacts hold it, 0 to 1 (momentum/drag_response.hpp)
    Vector cell_extent = Vector::Zero();  ///< of the gas cell that holds its centre
    double cell_volume = 0;               ///< of that cell
    double cell_size = 0;                 ///< its cube root
    KernelVolume kernel_volume;           ///< over which the gas feels it
    double mean_diameter = 0;             ///< Sauter mean of the real particles around; if asked for

    // the gas where it is, before it is solved
    double voidage = 1;
    Vector gas_velocity = Vector::Zero();
    double density = 0, viscosity = 0;          ///< dynamic viscosity
    Vector pressure_gradient = Vector::Zero();  ///< of the last solve; 0 in steps too short to feel it
    /// d u_j / d x_i in row i, column j; if asked for.
    Eigen::Matrix3d velocity_gradient = Eigen::Matrix3d::Zero();
    Vector viscous_force = Vector::Zero();  ///< div tau [N/m3]; if asked for

    // the step
    Vector gravity = Vector::Zero();
    double duration = 0;

    Vector slip() const { return gas_velocity - velocity; }
    /// Of the real particle and the interstitial slip.
    double slip_reynolds() const { return density * slip().norm() * diameter / viscosity; }
    /// Real ones in the tracked one.
    double real_particles() const { return volume / (M_PI / 6 * diameter * diameter * diameter); }
};

}  // namespace interphase
