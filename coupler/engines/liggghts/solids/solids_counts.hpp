// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/count.hpp"

namespace interphase {

inline constexpr CountKind overlaps_at_start{
    "overlaps_at_start",
    "overlaps at the start",
    Whole::nothing,
    "Pairs of particles, or particles and walls, overlap by more than 5 % of a radius before the first step.",
    Worry::any,
    "Contacts of that depth burst apart; the run told how many, the deepest and where.",
    "smaller or fewer particles, or let them settle first; the numbers of the walls"};

inline constexpr CountKind particles_unmoved{
    "particles_unmoved",
    "particles that no fix moves",
    Whole::particles,
    "No fix of the script integrates them: they stay where they are, whatever acts on them.",
    Worry::any,
    "It is meant only where they are held on purpose, as in `cases/packed-bed`.",
    "an integrator (fix nve/sphere, or the plug-in's) for a group that they are in"};

inline constexpr CountKind fast_contacts{
    "fast_contacts",
    "gas steps with too fast contacts",
    Whole::gas_steps,
    "Two particles that meet at the largest speed touch by Hertz's law for less than ten solid steps.",
    Worry::any,
    "Such collisions gain or lose energy.",
    "a shorter solid step (`particles { solidStep }`), or a lower youngsModulus"};

inline constexpr CountKind seen_late_by_outlets{"seen_late_by_outlets",
                                                "particles that an outlet saw late",
                                                Whole::particles,
                                                "A particle crossed the mesh of a massflow/mesh by more than half a "
                                                "radius in a solid step, and was counted beyond it.",
                                                Worry::never,
                                                "It is counted, and deleted where that is asked for, all the same.",
                                                ""};

}  // namespace interphase
