// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// The shortest collision t_c [s] between the particles that exist, for the pair model hooke/stiffness, whose stiffness
/// and damping are read from the script's property/global fixes: t_c = pi / sqrt(k/m - (gamma/2m)^2), m the effective
/// mass, which is sqrt(m/k (pi^2 + ln^2 e)), eq. 23 of the paper. Empty for other contact models, whose collision time
/// depends on the impact speed. Collective.
std::optional<double> shortest_contact(LAMMPS_NS::LAMMPS& lmp);

}  // namespace interphase
