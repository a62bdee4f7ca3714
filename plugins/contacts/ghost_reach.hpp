// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lammps.h"

namespace interphase::contacts {

/// Lets ghosts, the copies of other ranks' spheres, reach as far as contacts do: also where larger spheres come or grow
/// while the run goes on. The fix whose member it is calls begin() in init(), renew() in setup_pre_neighbor() and
/// pre_neighbor() (it needs PRE_NEIGHBOR in its mask), and answers distance() to extend_cut_ghost(). All are collective
/// but distance() and largest_radius().
class GhostReach {
public:
    /// `radii`: the reach, in those of the largest sphere. LIGGGHTS adds its skin.
    GhostReach(LAMMPS_NS::LAMMPS& lmp, double radii) : lmp_(lmp), radii_(radii) {}

    /// Looks at the spheres that there are and at those that fixes will insert.
    void begin();

    /// Where larger ones have come or grown, fetches the ghosts anew.
    void renew();

    double distance() const { return radii_ * largest_radius_; }  ///< [m]
    double largest_radius() const { return largest_radius_; }     ///< that ghosts reach far enough for [m]

    /// Of all ranks' spheres [m]; 0 where there are none.
    double largest_now() const;

private:
    LAMMPS_NS::LAMMPS& lmp_;
    double radii_;
    double largest_radius_ = 0;
};

/// Whether a fix, such as adapt, changes radii or masses while the run goes on. It does so on each rank's own spheres,
/// after their ghosts have been told of them.
bool sizes_change(const LAMMPS_NS::LAMMPS& lmp);

}  // namespace interphase::contacts
