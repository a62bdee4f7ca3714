// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vector.hpp"
#include "hard_sphere/bodies.hpp"
#include "hard_sphere/material.hpp"

namespace interphase::hard_sphere {

/// Two bodies that may touch within this step.
struct Contact {
    int i, j;           ///< places in Bodies; j may be a wall's
    Vector normal;      ///< from i to j; of an impact: at the moment of touching
    double gap;         ///< between the surfaces at the start of the step, below 0: overlap [m]
    bool impact;        ///< they will touch, and fast enough for restitution
    double touch_time;  ///< of an impact: when within the step [s]
    double parting;     ///< of an impact: the normal velocity to part with [m/s]
    const ContactLaw* law;
    int key;  ///< of a wall's contact, below 0: what its impulse is remembered under; 0 between two spheres
};

struct StepLimits {
    double step;           ///< [s]
    double margin;         ///< bodies that pass each other by more than this are no contact [m]
    double resting_speed;  ///< approach below which restitution does not apply [m/s]
};

/// Whether and when two spheres meet is solved for exactly, along their straight paths within the step.
Contact contact_of_spheres(const Bodies& bodies, int i, int j, const Materials& materials, const StepLimits& limits);

/// `meeting`: relative velocity with which the bodies move in this step [m/s], forces included; `push`: what forces
/// added to it. Makes the contact an impact if they are fast enough at the moment of touching, which `contact` has:
/// above `resting_speed`, and above twice what the forces of one step add. Slower ones come to rest: restitution would
/// let a sphere on the ground bounce for ever on what gravity gives it in each step.
void judge_impact(Contact& contact, const Vector& meeting, const Vector& push, const StepLimits& limits);

}  // namespace interphase::hard_sphere
