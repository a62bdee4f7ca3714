// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/count.hpp"

namespace interphase {

inline constexpr CountKind beyond_drag_range{
    "beyond_drag_range",
    "particles beyond the drag law's range",
    Whole::particle_steps,
    "A particle was where the law's source does not claim to hold: in a voidage or at a Reynolds number beyond its "
    "range. The formula was taken as it stands.",
    Worry::share,
    "Each is weighed with how far its drag factor is from Wen and Yu's, whose range is a voidage of 0.4 to 1, in "
    "denser places from Ergun's (from 0.35); where neither claims to hold, with its own size.",
    "take a law whose range holds what the scene has (`coupler/forces/drag/drag_law.cpp` has the ranges)"};

inline constexpr CountKind self_disturbance_limited{
    "self_disturbance_limited",
    "particles that take most of the slip along",
    Whole::particle_steps,
    "A particle drags the gas of its cell along so far that more than 0.9 of its slip is its own doing; the correction "
    "for it ends there (coupler/forces/self_disturbance/README.md).",
    Worry::share,
    "What is left out of the correction is at most the slip itself.",
    "cells wider than the particles, or a wider kernel (`mapping { widthInDiameters }`)"};

}  // namespace interphase
