// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vector.hpp"
#include "hard_sphere/response.hpp"

namespace interphase::hard_sphere {

/// A sphere at the moment of a collision, SI units. A wall is one with `inverse_mass` and `inverse_inertia` 0.
struct Sphere {
    Vector velocity;
    Vector spin;             ///< angular velocity [rad/s]
    double radius;           ///< [m]
    double inverse_mass;     ///< [1/kg]
    double inverse_inertia;  ///< 1/I with I = m d^2/10 [1/(kg m2)]
};

/// Velocity of b's surface relative to a's at the point of contact [m/s]. `normal`: unit vector from a to b.
Vector contact_velocity(const Sphere& a, const Sphere& b, const Vector& normal);

/// The impulse [kg m/s] on b, and its opposite on a, with which the two part at `parting` [m/s] along the normal,
/// unless they do so anyway, and with -e_t times their tangential velocity, unless friction's limit mu J_n is below
/// that.
Vector contact_impulse(const Sphere& a, const Sphere& b, const Vector& normal, double parting,
                       double tangential_restitution, double friction);

/// The impulse [kg m/s] on b, and its opposite on a, of a collision (eqs. 10 and 11 of the paper, Lu et al. 2017, after
/// Hoomans et al., Chem. Eng. Sci. 51 (1996) 99). Normal: -m_e (1 + e_n) v_n. Tangential, against v_t: the smaller of
/// the sticking impulse m_t (1 + e_t) |v_t| and the Coulomb limit mu m_e (1 + e_n) |v_n|; m_t = 2/7 m_e for solid
/// spheres. (Eq. 11 prints `max`; with it friction would exceed its limit.) Zero for bodies that part.
Vector collision_impulse(const Sphere& a, const Sphere& b, const Vector& normal, const Response& response);

/// Gives the couple against rolling that goes with an `impulse` which both have got. What does not bounce may both
/// stick and not roll: friction and couple are sought in turn then, each within its limit.
void resist_rolling(Sphere& a, Sphere& b, const Vector& normal, const Vector& impulse, const Response& response,
                    bool impact);

/// Gives the impulse to both (eqs. 12 to 15).
void apply_impulse(Sphere& a, Sphere& b, const Vector& normal, const Vector& impulse);

}  // namespace interphase::hard_sphere
