// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace interphase {

/// Spheres that a fix insert/* of the script will still make, by a template of its distribution.
struct SpheresToCome {
    int type;                                ///< of LIGGGHTS, from 1
    double smallest_radius, largest_radius;  ///< [m]
    double lowest_density;                   ///< [kg/m3]
    std::optional<double> weight;            ///< real particles in each, where the fix gives it

    double lightest() const;  ///< mass of the smallest at the lowest density [kg]
};

/// All of them; the same on every rank. LIGGGHTS cuts a Gaussian distribution at three standard deviations.
std::vector<SpheresToCome> spheres_to_come(LAMMPS_NS::LAMMPS& lmp);

}  // namespace interphase
