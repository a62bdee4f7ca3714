// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vector.hpp"

namespace interphase {

// How a particle of mass m [kg] with drag rate k [kg/s] answers the gas over a step dt [s]. With the gas velocity u
// held, dv/dt = (k/m)(u - v) + a has the solution v(dt) = v + (1 - e^-x)(u + a m/k - v), x = k dt / m, and the impulse
// of drag is
//     J = m (1 - e^-x)(u - v) - m a (dt - (1 - e^-x) m/k).
// A particle that its contacts hold in place takes k dt (u - v) instead. Both are J = kappa dt (u - v) - carried, with
// kappa between m/dt (1 - e^-x) and k: that is what the gas solve treats implicitly, whatever x is. With a = g + F_p/m,
// F_p the pressure force of the same step, the impulse of drag and pressure together is
//     kappa dt (u - v) + (1 - y) dt F_p - y m dt g,   y the share 1 - (1 - e^-x)/x of a free particle, 0 of a held one:
// drag gives back the share y of what pressure and gravity do. Over the step the free particle moves at
//     v + y (u - v + (g + F_p/m) m/k)
// on average, so y is also how far its motion follows the gas. Both are linear in u and grad p, and both belong into
// the gas solve: where continuity fixes the flux, a pressure force or a motion of the last step makes suspensions
// diverge from a gas step of about one relaxation time on.
//
// Gas that moves with the particle (an added mass m') takes its share of every force: x = k dt/(m + m'), a force
// changes the velocity by m/(m + m') of what it would, and y = 1 - m/(m + m') (1 - e^-x)/x. Its motion follows the gas
// by 1 - (1 - e^-x)/x as before.

/// Of a constant force: what changes the velocity of a particle with drag, (1 - e^-x)/x, and the rest, which drag gives
/// to the gas. Each is accurate at any x.
struct Shares {
    double relaxed, withheld;
};
Shares shares(double x);

double relaxed_share(double x);
double withheld_share(double x);

/// The same with an added mass [kg], of what changes m v: the gas gets the rest of every force.
Shares answered(double mass, double added_mass, double drag_rate, double dt);

/// The same, of the shares by which the motion answers: shares(k dt/(m + m')).
inline Shares answered(double mass, double added_mass, const Shares& of_motion)
{
    if (added_mass == 0) return of_motion;
    const double inertia = mass + added_mass, own = mass / inertia;
    return {own * of_motion.relaxed, own * of_motion.withheld + added_mass / inertia};
}

/// What the gas solve assumes of a particle's drag impulse over a step: J = kappa dt (u - v) - carried.
struct AssumedDrag {
    double kappa;      ///< [kg/s]
    Vector carried;    ///< what other forces take over from drag [kg m/s]
    double following;  ///< y above, 0 to 1: the share of other forces that drag gives back

    Vector impulse(const Vector& gas_velocity, const Vector& velocity, double dt) const
    {
        return kappa * dt * (gas_velocity - velocity) - carried;
    }
};

/// `held` in [0, 1]: how far contacts hold the particle (see Hold); `acceleration` a [m/s2]: that of other
/// forces, as far as they are known before the gas solve.
AssumedDrag assume_drag(double mass, double drag_rate, double held, const Vector& acceleration, double dt,
                        double added_mass = 0);

/// The same, of answered().
inline AssumedDrag assume_drag(double mass, double drag_rate, double held, const Vector& acceleration, double dt,
                               const Shares& answered)
{
    const double following = (1.0 - held) * answered.withheld;
    return {drag_rate * (answered.relaxed + held * answered.withheld), following * mass * dt * acceleration, following};
}

/// By which a constant acceleration changes the velocity of a particle with drag in a step of dt [s].
double response_time(double mass, double drag_rate, double dt, double added_mass = 0);

/// The change of velocity of a particle without contacts in a step with this response time [m/s].
Vector free_change(double mass, double drag_rate, const Vector& slip, const Vector& acceleration, double response_time);

/// What is known of how contacts hold the solids of a cell.
///
/// Solids count as free until contacts have kept them at rest for some steps: a gas solve that takes held solids for
/// free converges with its lagged correction at any step (the pressure at phi/(phi + eps), the velocity as `stiffening`
/// says). One that takes free solids for held, or for half held, diverges in dense beds from a gas step of a third of
/// the relaxation time on (1 - e^-x = 2 eps^2 for one half), and a judgement that changes from step to step kicks the
/// bed: so it is made slowly, and of solids that rest.
struct Hold {
    double held = 0;   ///< 1 where contacts take up all that other forces do, 0 where solids are free
    double doubt = 0;  ///< 0 to 1: how far 0 is a guess
    long steps = -1;   ///< on end that they were held, up to `enough`; below 0: nothing was seen yet

    static constexpr long enough = 10;

    /// By what the last step did: the sums over the cell's particles of m times the velocity change by contacts and of
    /// m times the change without contacts [kg m/s]. Contacts inside the cell cancel in the first, so collisions say
    /// nothing. `weight` [kg m/s]: what gravity alone would have given. Where the second is well below it, forces
    /// balance, which tells nothing of contacts. Where there is nothing at all, the answer is held: too little is given
    /// to what comes there, once.
    void judge(const Vector& by_contacts, const Vector& without_contacts, double weight);
};

/// Rate [kg/s] that the gas solve adds to kappa where there is `doubt`, on the change of the gas velocity from the last
/// step: half of what is between the free particle's rate and the held one's. The lagged correction of what the
/// particles took converges then whichever of the two they are, at (1 + 2/x)^-1/2 a step.
double stiffening(double drag_rate, double mass, double doubt, double dt, double added_mass = 0);

}  // namespace interphase
