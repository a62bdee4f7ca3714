// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "forces/particle_in_gas.hpp"

namespace interphase {

/// Velocity at a force that is spread by a Gaussian of standard deviation sigma, averaged with the same, in units of
/// that in Stokes flow, F/(6 pi^(3/2) mu sigma): by Oseen's equations, in a stream of Reynolds number Re = rho U
/// sigma/mu, along it,
///
///     3/2 int_0^1 (1 - c^2) g(Re c) dc,   g(x) = 1 - sqrt(pi) x exp(x^2) erfc(x).
///
/// A rational function with both ends exact, 1 - 3 sqrt(pi) Re/8 and 3 sqrt(pi)/(4 Re), within 0.1 % between. README.md
/// derives it.
double share_in_stream(double reynolds);

/// The same in a fluid at rest that feels a drag K [kg/(m3 s)] from what stands around, by Brinkman's equation: g(x),
/// x^2 = K sigma^2/mu, by a rational function within 0.4 %.
double share_in_packing(double x);

/// The same in a stream through what stands around: both, as far as one leaves the other something to do. Exact where
/// either is missing or the stream is fast, else at most 15 % too small.
inline double share_in_stream_through_packing(double reynolds, double x)
{
    const double in_packing = share_in_packing(x);
    return in_packing * share_in_stream(in_packing * reynolds);
}

/// What a collocated finite-volume mesh makes of that velocity where the kernel's volume is this many cells: more, as
/// its differences do not see what varies from cell to cell. 1 + n^-0.85, within 6 % of the lattice's own function from
/// 1 cell on (README.md).
inline double excess_on_mesh(double cells) { return 1 + std::pow(cells, -0.85); }

/// How much of the disturbance of a particle is its own where others stand around it: they stand where it is not, and
/// disturb what it sees the other way. By the structure factor of hard spheres at long waves (Percus and Yevick's:
/// Hansen and McDonald, Theory of Simple Liquids, 2006, ch. 4), (1 - phi)^4/(1 + 2 phi)^2, moved to vanish at a solid
/// fraction of 0.4, where it is 0.04, and from there on.
double isolation(double solid_fraction);

/// What a particle sees of itself: its solids in the voidage, its drag in the gas velocity. Drag laws speak of the gas
/// as it would be without the particle, or, in an assembly, of mean voidage and velocity, and so do those who look
/// here.
class SelfDisturbance {
public:
    explicit SelfDisturbance(const ParticleInGas& at);

    /// Whether the particle's own part, of voidage or of slip, may be more than `negligible` [-]: a bound by the least
    /// volume that a kernel has, its cell's, and Schiller and Naumann's drag, to spare the rest of it in beds.
    static bool may_matter(const ParticleInGas& at);
    static constexpr double negligible = 0.005;

    /// Without the particle's own part.
    double voidage() const { return voidage_; }

    struct Rate {
        double of_seen;  ///< k' [kg/s]: k'(u - v) with the velocity that is seen is the drag of the undisturbed one
        bool limited;    ///< as the particle takes so much of the slip along that the answer would be a guess
    };
    /// @param rate_of     k [kg/s] of an undisturbed slip speed [m/s] at voidage()
    /// @param seen_speed  of the slip that the particle sees [m/s]
    template <class RateOf>
    Rate rate(const RateOf& rate_of, double seen_speed) const
    {
        if (own_ == 0) return {rate_of(seen_speed), false};
        // The slip grows with a small negative power of what it is taken for, which the steps allow for.
        constexpr int most_tries = 6;
        constexpr double close_enough = 1e-3, power = 0.3;
        double slip = seen_speed / widening_, rate = 0, taken = 0;
        for (int n = 0; n < most_tries; ++n) {
            rate = pressed_ * rate_of(slip);
            taken = std::min(rate / real_particles_ * velocity_per_force(slip, rate), most_taken);
            const double ratio = seen_speed > 0 ? seen_speed / ((widening_ - taken) * slip) : 1.0;
            if (std::abs(ratio - 1) < close_enough) break;
            slip *= std::pow(ratio, 1 / (1 + power * taken / (widening_ - taken)));
        }
        return {rate / (widening_ - taken), taken >= most_taken};
    }

    /// Gas velocity that the particle sees per force that it gives [m/s/N], at an undisturbed slip speed [m/s] and
    /// where others have the drag rate `rate` [kg/s], as it has.
    double velocity_per_force(double slip_speed, double rate) const;

    /// Part of the slip that a particle may take along.
    static constexpr double most_taken = 0.9;

    /// Solid fraction of others from which on the particle has nothing of its own.
    static constexpr double crowded = 0.4;

private:
    /// The kernel's volume is known within a tenth or two, and others that are not there would take much of the effect.
    static constexpr double margin = 1.2;

    const ParticleInGas& at_;
    double real_particles_ = 1;
    double own_ = 0;            ///< what of the disturbance is its own
    double voidage_;            ///< [-]
    double solids_around_ = 0;  ///< solid fraction of others
    double deviation_ = 0;      ///< of the kernel [m]
    double in_cells_ = 0;       ///< velocity per force in Stokes flow [m/s/N], of a force that the gas takes in cells
    double at_faces_ = 0;       ///< of one that it takes at faces: what is due to the particle's own velocity
    double speed_against_slip_ = 0;  ///< of the particle in the frame of the mesh [m/s]
    double widening_ = 1;            ///< slip seen over undisturbed slip, as the gas makes way for the solids
    double pressed_ = 1;             ///< part of the force that is drag, as its pressure pushes the particle, too
};

}  // namespace interphase
