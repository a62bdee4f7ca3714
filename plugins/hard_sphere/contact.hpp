// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vector.hpp"
#include "hard_sphere/bodies.hpp"
#include "hard_sphere/material.hpp"
#include "hard_sphere/pair_search.hpp"

namespace interphase::hard_sphere {

/// Two bodies that may touch within this step.
struct Contact {
    int i, j;           ///< places in Bodies; j may be a wall's
    Vector normal;      ///< from i to j, where they touch or are nearest on their paths without contact
    double gap;         ///< between the surfaces at the start of the step, below 0: overlap [m]
    double closing;     ///< they touch within this step if they approach each other faster than this [m/s]
    bool touch;         ///< within the step, or all but so
    bool impact;        ///< they will touch, and fast enough for restitution
    double touch_time;  ///< of an impact: when within the step [s]
    double parting;     ///< of an impact: the normal velocity to part with [m/s]
    const ContactLaw* law;
    int key;  ///< of a wall's contact, below 0: what its impulse is remembered under; 0 between two spheres
};

/// Speeds that the forces of so many steps give a contact are none to bounce with.
constexpr double resting_pushes = 2;

struct StepLimits {
    double step;           ///< [s]
    double margin;         ///< bodies that pass each other by more than this are no contact [m]
    double touching;       ///< those nearer than this are in touch, the others may be pushed so by their neighbours [m]
    double tolerated;      ///< overlap that may stay [m]
    double relief;         ///< share of the overlap beyond that which a step takes away
    double resting_speed;  ///< approach below which restitution does not apply [m/s]
    double farthest;       ///< no sphere moves by more than this in the step [m]
};

/// Whether, when and where two spheres meet is solved for exactly, along their straight paths within the step; for
/// those that do not meet, the contact is linearised about the point where they are nearest, so that none is braked by
/// another that it passes.
Contact contact_of_spheres(const Bodies& bodies, const Pair& pair, const Materials& materials,
                           const StepLimits& limits);

/// Contact::closing of an overlap: below 0 where the bodies have to part, to take away what of it is not tolerated
/// [m/s].
double relieving_speed(double gap, const StepLimits& limits);

/// `meeting`: relative velocity with which the bodies move in this step [m/s], forces included; `push`: what forces
/// added to it. Makes the contact an impact if they are fast enough at the moment of touching, which `contact` has:
/// above `resting_speed`, and above twice what the forces of one step add. Slower ones come to rest: restitution would
/// let a sphere on the ground bounce for ever on what gravity gives it in each step.
void judge_impact(Contact& contact, const Vector& meeting, const Vector& push, const StepLimits& limits);

}  // namespace interphase::hard_sphere
