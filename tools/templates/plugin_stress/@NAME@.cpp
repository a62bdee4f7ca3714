// SPDX-License-Identifier: GPL-3.0-or-later
// Solids that push each other only where they rub: the normal stress of lasting contacts (Johnson and Jackson, J. Fluid Mech. 176 (1987) 67),
//     tau = Fr (phi - phi_min)^n / (phi_cp - phi)^p above phi_min, 0 below; Fr = 0.05 Pa, n = 2, p = 5, phi_min = 0.5 are usual.
#include <interphase/mp_pic/fix_mp_pic_of.hpp>

#include <algorithm>
#include <cmath>

using namespace interphase::mp_pic;

struct @CLASS@ {
    /// What the script gives behind `stress @NAME@`, in the order of `numbers`, and, always the last, its `close_packing`.
    double factor, rise, pole, onset, close_packing;
    static constexpr StressNumber numbers[] = {
        {"Fr", "Pa", above_zero, unbounded}, {"n", "", 1, 10}, {"p", "", 1, 10}, {"phi_min", "", 0, 1}};

    /// tau [Pa] of a solid fraction of 0 to 1: finite, not below 0, and it does not fall. So the gap to close packing stays above 0 here.
    double stress(double solid_fraction) const
    {
        const double beyond = std::max(solid_fraction - onset, 0.0), left = std::max(close_packing - solid_fraction, 1e-3);
        return factor * std::pow(beyond, rise) / std::pow(left, pole);
    }
};

INTERPHASE_STRESS("@NAME@", @CLASS@)
