// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// The time [s] that a Rayleigh wave takes along the surface of a sphere, of the particle where it is shortest:
/// pi r sqrt(density/G)/(0.1631 nu + 0.8766) (Thornton and Randall, in Micromechanics of Granular Materials, Elsevier
/// 1988, 133). Where contacts get their stiffness from youngsModulus and poissonsRatio of the script; none otherwise.
/// Collective.
std::optional<double> rayleigh_time(LAMMPS_NS::LAMMPS& lmp);

/// How long two equal spheres touch [s] that meet at `speed` [m/s], of the particle where it is shortest:
/// 2.868 (m^2/(R E^2 v))^(1/5) with the contact's reduced mass, radius and modulus (Johnson, Contact Mechanics,
/// Cambridge 1985, eq. 11.24), undamped. None where rayleigh_time() is none, or nothing moves. Collective.
std::optional<double> hertz_time(LAMMPS_NS::LAMMPS& lmp, double speed);

/// The largest speed of a particle [m/s]. Collective.
double largest_speed(LAMMPS_NS::LAMMPS& lmp);

}  // namespace interphase
