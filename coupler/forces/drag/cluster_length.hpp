// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase {

/// The velocity at which a sphere alone falls or rises in a gas at rest [m/s], by the drag of Schiller and Naumann.
double terminal_velocity(double diameter, double density, double gas_density, double gas_viscosity, double gravity);

/// The length [m] by which cells are compared with the clusters that they do not resolve:
/// L = v_t^2/g Fr^(-2/3), Fr = v_t^2/(g d), v_t the terminal velocity of a particle alone.
///
/// Source: S. Radl, S. Sundaresan, A drag model for filtered Euler-Lagrange simulations of clustered gas-particle
/// suspensions, Chem. Eng. Sci. 117 (2014) 416. Without gravity, or in a gas as heavy as the particle, it is infinite:
/// nothing clusters.
double cluster_length(double diameter, double density, double gas_density, double gas_viscosity, double gravity);

}  // namespace interphase
