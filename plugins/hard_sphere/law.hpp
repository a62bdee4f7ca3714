// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hard_sphere/lane_numbers.hpp"

/// What a law of contacts is: a class of pure functions that are written once, for one contact (D is `double`) and for
/// several side by side (lane_numbers.hpp has what can be done with such numbers).
///
///     struct Law {
///         /// One number for each of `properties`, in their order: what materials are between the two types.
///         template <class D>
///         struct Materials {
///             D restitution, friction;
///         };
///         static constexpr MaterialProperty properties[] = {{"coefficientRestitution", 0, 1}, {"coefficientFriction",
///         0, 1e30}};
///
///         template <class D>
///         static D restitution(const Materials<D>& materials, const Meeting<D>&) { return materials.restitution; }
///         ...
///     };
///
/// Functions of (materials, meeting); a law has those that it wants, the first one at least:
///
///     restitution             e_n of an impact, 0 to 1; asked of contacts at rest, too, and not heeded there
///     tangential_restitution  e_t of a sticking impact, 0 to 1; without it 0
///     friction                mu, 0 or more; without it 0
///     rolling_friction        mu_r, 0 or more: a couple up to mu_r r_e J_n opposes that the two roll over each other,
///     r_e
///                             the effective radius, J_n the normal impulse (model A of Ai et al., Powder Technol. 206
///                             (2011) 269, of which the couple at rest is whatever holds); without it none
///
/// A contact may have a state of its own, numbers that are 0 where it begins and that its law renews in each step. It
/// lasts as long as the contact passes on an impulse, travels between ranks and stands in checkpoints:
///
///     template <class D> struct State { D age; };       at most most_states numbers
///     next                    of (last, materials, meeting, step): the State in this step, `step` its length [s]
///
/// The functions above then are of (materials, meeting, state). Of an impact of two that touch nothing else there is
/// nothing to keep.
///
/// And of (materials, Separation), for one contact at a time, where bodies draw each other:
///
///     attraction              the force [N], added to the others; above 0 draws the two to each other. Of bodies that
///                             overlap, too
///     range                   of (materials): the gap up to which it acts, at most the smallest diameter [m]
namespace interphase::hard_sphere {

/// A number that a law reads for each pair of types: `fix ID all property/global NAME peratomtypepair ...`.
struct MaterialProperty {
    const char* name;
    double least, most;
};

/// What a law sees of a contact.
template <class D>
struct Meeting {
    D speed;   ///< with which the surfaces approach each other when they touch; 0: no impact [m/s]
    D mass;    ///< effective, m_i m_j/(m_i + m_j), m_i at a wall [kg]
    D radius;  ///< effective, r_i r_j/(r_i + r_j), r_i at a wall [m]
};

/// How many numbers a State may have.
constexpr int most_states = 4;

/// What an attraction sees.
struct Separation {
    double gap;     ///< between the surfaces, below 0: overlap [m]
    double radius;  ///< effective, as in Meeting [m]
};

/// The spheres that there are [m].
struct Sizes {
    double smallest, largest;  ///< radii
};

/// The law of `tdhs`: all of it numbers of the materials (eqs. 10 and 11 of the paper).
struct ConstantRestitution {
    template <class D>
    struct Materials {
        D restitution, tangential_restitution, friction;
    };
    static constexpr MaterialProperty properties[] = {
        {"coefficientRestitution", 0, 1}, {"tangentialRestitution", 0, 1}, {"coefficientFriction", 0, 1e30}};

    template <class D>
    static D restitution(const Materials<D>& materials, const Meeting<D>&)
    {
        return materials.restitution;
    }
    template <class D>
    static D tangential_restitution(const Materials<D>& materials, const Meeting<D>&)
    {
        return materials.tangential_restitution;
    }
    template <class D>
    static D friction(const Materials<D>& materials, const Meeting<D>&)
    {
        return materials.friction;
    }
};

}  // namespace interphase::hard_sphere
