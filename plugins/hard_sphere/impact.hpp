// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hard_sphere/lane_numbers.hpp"
#include "hard_sphere/step_limits.hpp"

/// The formulas of contacts between hard spheres, each once for all widths: D is the number of one contact or of
/// several side by side (lane_numbers.hpp). SI units. Everything is pure and goes by the straight paths of the spheres
/// within the step; `apart` and `meeting` are place [m] and velocity [m/s] of the second sphere relative to the first.
namespace interphase::hard_sphere {

constexpr double tiny = 1e-100;  ///< no lane may divide by zero: the gas engine may have made that an error

/// r_e of radii or arms `a` and `b`, of which that of a wall is 0 [m].
template <class D>
INTERPHASE_INLINE D effective_radius(const D& a, const D& b)
{
    return if_positive(b, D(a * b / (a + b + tiny)), a);
}

/// When two spheres touch, or are nearest if they do not.
template <class D>
struct Encounter {
    D gap;           ///< at the start of the step, below 0: overlap [m]
    D time;          ///< within the step [s]
    D touch;         ///< 1: they do, 0: they do not
    Three<D> apart;  ///< at that time [m]
    D distance;      ///< its length [m]
};

/// The quadratic |apart + t meeting| = touching, solved for the first t in [0, step]; for those that miss each other,
/// or meet later, the t in it at which they are nearest. `touching`: the sum of the radii [m].
template <class D>
INTERPHASE_INLINE Encounter<D> encounter(const Three<D>& apart, const Three<D>& meeting, const D& touching, double step)
{
    const D zero{}, one = zero + 1, end = zero + step;
    const D squared = dot(apart, apart), closing = dot(apart, meeting), beyond = squared - touching * touching;
    const D speed2 = dot(meeting, meeting), discriminant = closing * closing - speed2 * beyond;
    const D size = larger(closing, D(-closing)), root = square_root(larger(discriminant, zero));
    const D when = if_negative(discriminant, size, beyond) / (if_negative(discriminant, speed2, D(root + size)) + tiny);
    const D reached = if_negative(D(when - end), if_negative(discriminant, zero, one), zero);
    const D touch = if_negative(closing, if_negative(beyond, one, reached), zero);
    const D time = if_negative(closing, if_negative(beyond, zero, smaller(end, when)), zero);
    const Three<D> then = apart + time * meeting;
    return {square_root(squared) - touching, time, touch, then, square_root(dot(then, then))};
}

/// Below 0 where bodies have to part, to take away what of their overlap is not tolerated [m/s].
template <class D>
INTERPHASE_INLINE D relieving_speed(const D& gap, const Divisor<D>& step, const StepLimits& limits)
{
    const D zero{};
    return smaller(zero, step.part(D(gap + limits.tolerated), D(zero + limits.relief)));
}

/// Bodies touch within the step if they approach each other faster than this [m/s]. `speed`: along the normal at the
/// encounter, below 0: towards each other. Of spheres that do not meet, the contact is linearised about the point where
/// they are nearest.
template <class D>
INTERPHASE_INLINE D closing_speed(const Encounter<D>& met, const D& touching, const D& speed, const Divisor<D>& step,
                                  const StepLimits& limits)
{
    const D zero{};
    const D open = step.part(D(met.distance - touching)) - if_positive(met.time, speed, zero);
    const D meeting = if_positive(met.touch, step.part(D(-speed), met.time), open);
    return if_negative(met.gap, relieving_speed(met.gap, step, limits), meeting);
}

/// Speeds that the forces of so many steps give a contact are none to bounce with.
constexpr double resting_pushes = 2;

/// How fast bodies approach each other when they touch [m/s].
template <class D>
struct Approach {
    D speed;  ///< above 0: towards each other
    D least;  ///< up to this they come to rest: restitution would let a sphere on the ground bounce for ever on what
              ///< gravity gives it in each step
    D later;  ///< what forces add to the velocity apart from the middle of the step to the moment of touching
};

/// `time`: of touching, within the step [s]; `speed`: along the normal with which they move in this step, forces
/// included; `gained`: what forces added to it. Velocities belong to the middle of the step: the one at the moment of
/// touching is looked for.
template <class D>
INTERPHASE_INLINE Approach<D> approach(const D& time, const D& speed, const D& gained, const Divisor<D>& step,
                                       const StepLimits& limits)
{
    const D later = (step.part(time) - 0.5) * gained;
    const D pushed = resting_pushes * larger(gained, D(-gained));
    return {-(speed + later), larger(D(D{} + limits.resting_speed), pushed), later};
}

/// Velocity of b's surface relative to a's where they touch [m/s]. The two bodies have `velocity`, `spin` (angular
/// velocity), `inverse_mass`, `inverse_inertia`; `arm`: from the centre to the point of contact [m]; `normal`: from a
/// to b.
template <class D, class Side>
INTERPHASE_INLINE Three<D> surface_velocity(const Side& a, const Side& b, const D& arm_a, const D& arm_b,
                                            const Three<D>& normal)
{
    const Three<D> turning = arm_a * a.spin + arm_b * b.spin;
    return b.velocity - a.velocity - cross(turning, normal);
}

/// The same in parts.
template <class D>
struct SurfaceVelocity {
    D apart;        ///< along the normal
    Three<D> slip;  ///< across it
};

template <class T>
INTERPHASE_INLINE auto in_parts(const T& velocity, const T& normal)
{
    using D = decltype(dot(velocity, normal));
    const D apart = dot(velocity, normal);
    return SurfaceVelocity<D>{apart, velocity - apart * normal};
}

/// A mass of which the inverse is known.
struct InverseMass {
    double value;  ///< [1/kg]
};
INTERPHASE_INLINE double operator*(const InverseMass& inverse, double speed) { return speed / inverse.value; }

/// The impulse along the normal, `before` and what is to come, that keeps the surfaces from crossing: after it they
/// approach each other by `closing` [m/s] at most. `mass`: effective, m_e of the normal, [kg] or InverseMass.
template <class D, class Mass>
INTERPHASE_INLINE D normal_impulse(const D& before, const Mass& mass, const D& apart, const D& closing)
{
    return before - mass * D(apart + closing);
}

/// The tangential impulse, along `direction`, whose own length is `length`: `sticking` where that is within Coulomb's
/// cone, else its `limit`, mu times the normal impulse (eq. 11 of the paper) [kg m/s].
template <class D>
INTERPHASE_INLINE Three<D> within_cone(const Three<D>& direction, const D& length, const D& sticking, const D& limit)
{
    return D(smaller(sticking, limit) / (length + tiny)) * direction;
}

/// The couple [kg m2/s] on b, `before` and what is to come, that keeps b from rolling over a; `limit` is the largest.
/// What turns about the normal stays. Takes kinetic energy or leaves it.
template <class D, class Side>
INTERPHASE_INLINE Three<D> rolling_couple(const Side& a, const Side& b, const Three<D>& normal, const Three<D>& before,
                                          const D& limit)
{
    const Three<D> turning = b.spin - a.spin, rolling = turning - dot(turning, normal) * normal;
    const Three<D> wanted = before - D(1 / (a.inverse_inertia + b.inverse_inertia + tiny)) * rolling;
    const D size = square_root(dot(wanted, wanted));
    return within_cone(wanted, size, size, limit);
}

/// Gives `couple` [kg m2/s] to b and its opposite to a. `a` and `b` change.
template <class D, class Side>
INTERPHASE_INLINE void exchange_couple(Side& a, Side& b, const Three<D>& couple)
{
    a.spin = a.spin - a.inverse_inertia * couple;
    b.spin = b.spin + b.inverse_inertia * couple;
}

/// Gives `impulse` [kg m/s] to b and its opposite to a (eqs. 12 to 15 of the paper). `a` and `b` change.
template <class D, class Side>
INTERPHASE_INLINE void exchange_impulse(Side& a, Side& b, const D& arm_a, const D& arm_b, const Three<D>& normal,
                                        const Three<D>& impulse)
{
    const Three<D> twist = cross(normal, impulse);
    a.velocity = a.velocity - a.inverse_mass * impulse;
    b.velocity = b.velocity + b.inverse_mass * impulse;
    a.spin = a.spin - (arm_a * a.inverse_inertia) * twist;
    b.spin = b.spin - (arm_b * b.inverse_inertia) * twist;
}

}  // namespace interphase::hard_sphere
