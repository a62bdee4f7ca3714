// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vector.hpp"
#include "hard_sphere/bodies.hpp"
#include "hard_sphere/law.hpp"
#include "hard_sphere/material.hpp"
#include "hard_sphere/pair_search.hpp"
#include "hard_sphere/response.hpp"
#include "hard_sphere/step_limits.hpp"

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
    double speed;       ///< of an impact: approach at the moment of touching [m/s]
    double later;       ///< of an impact: what forces added to the normal velocity apart from then to mid-step [m/s]
    int materials;      ///< which pair of types, Materials::between
    int key;            ///< of a wall's contact, below 0: what its impulse is remembered under; 0 between two spheres
    std::array<double, most_states> state{};  ///< the contact's own; the law renews it
    Response response{};                      ///< by the law
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
/// added to it. Makes the contact an impact if they are fast enough at the moment of touching, which `contact` has.
void judge_impact(Contact& contact, const Vector& meeting, const Vector& push, const StepLimits& limits);

}  // namespace interphase::hard_sphere
