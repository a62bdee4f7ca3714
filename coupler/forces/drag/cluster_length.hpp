// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

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

/// The same of spheres one after the other: most share what it is made of, and a terminal velocity is dear.
class ClusterLength {
public:
    double operator()(double diameter, double density, double gas_density, double gas_viscosity, double gravity)
    {
        const std::array<double, 5> of{diameter, density, gas_density, gas_viscosity, gravity};
        if (of != of_) {
            of_ = of;
            length_ = cluster_length(diameter, density, gas_density, gas_viscosity, gravity);
        }
        return length_;
    }

private:
    std::array<double, 5> of_{};
    double length_ = 0;
};

}  // namespace interphase
