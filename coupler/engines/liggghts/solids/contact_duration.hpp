// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "engines/liggghts/solids/insertions.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// The shortest collision t_c [s] between the particles that exist and those `to_come`, sqrt(m/k (pi^2 + ln^2 e)), eq.
/// 23 of the paper, m the effective mass. The numbers come from the script's property/global fixes. With a pair style:
/// for the model hooke/stiffness (kn and gamman_abs or gamman: t_c = pi / sqrt(k/m - (gamma/2m)^2), which is the same);
/// empty for others, whose collision time depends on the impact speed. Without one (hard spheres): of DEM with the
/// stiffness kn and the restitution coefficientRestitution (or those dampings), whose overlaps the hard spheres are to
/// have. Collective.
std::optional<double> shortest_contact(LAMMPS_NS::LAMMPS& lmp, const std::vector<SpheresToCome>& to_come);

}  // namespace interphase
