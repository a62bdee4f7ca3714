// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/term.hpp"

namespace interphase {

inline constexpr CountKind beyond_lift_range{
    "beyond_lift_range",
    "particles beyond the lift law's range",
    Whole::particle_steps,
    "A particle's Reynolds number or its shear was beyond the range of Mei's correction (0.1 <= Re <= 100, 0.005 <= b "
    "<= 0.4). The formula was taken as it stands.",
    Worry::share,
    "How far the lift is off there is not known: its own size is taken.",
    "where the lift matters, look at how much the run changes without it (`forces ()`)"};

/// Lift on a sphere that moves against a gas in shear,
///     F = 1.615 d^2 sqrt(rho mu / |w|) C (u - v) x w,   w = curl u,
/// by P. G. Saffman, J. Fluid Mech. 22 (1965) 385, corrected in 31 (1968) 624, for small Re. C is the correction of
/// R. Mei, Int. J. Multiphase Flow 18 (1992) 145, a fit for 0.1 <= Re <= 100 and 0.005 <= b <= 0.4: with
/// Re = rho |u - v| d / mu and b = |w| d / (2 |u - v|),
///     C = (1 - 0.3314 sqrt b) exp(-Re/10) + 0.3314 sqrt b   up to Re = 40,   0.0524 sqrt(b Re) above.
/// Of a sphere alone: the voidage does not enter. A parcel takes that of its real particles.
class SaffmanMeiLift : public Term {
public:
    Needs needs() const override
    {
        Needs needs;
        needs.velocity_gradient = true;
        return needs;
    }

    void act(const ParticleInGas& at, Response& response) override;

    std::vector<Count> counts() const override { return {{beyond_lift_range, beyond_range_}}; }

    void keep(Archive& archive) override { archive.keep_share("beyond_range", beyond_range_); }

private:
    long beyond_range_ = 0;
};

}  // namespace interphase
