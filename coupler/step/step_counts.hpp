// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/count.hpp"

namespace interphase {

inline constexpr CountKind cells_relieved{
    "cells_relieved",
    "cells relieved at the packing limit",
    Whole::cell_steps,
    "A cell had more solids than `mapping { maximumPacking }`. What was above went on to its neighbours, with its "
    "share of all that particles and gas exchange: volume and momentum are kept.",
    Worry::share,
    "The solid fraction of such a cell is off by less than its own size. Spheres of one size do not pack above 0.74, "
    "so they overlap, or the kernel is narrower than they are.",
    "wider cells, a wider kernel (`mapping { widthInDiameters }`) or a lower weight; stiffer contacts where particles "
    "overlap"};

inline constexpr CountKind particles_outside_mesh{"particles_outside_mesh",
                                                  "particles without a gas cell",
                                                  Whole::particle_steps,
                                                  "A particle was outside the gas mesh, and moved on without gas.",
                                                  Worry::never,
                                                  "`outsideMesh ignore;` asks for it; without that the run stops.",
                                                  ""};

inline constexpr CountKind centres_beyond_edge{
    "centres_beyond_edge",
    "centres beyond a facet, in the nearest cell",
    Whole::particle_steps,
    "A particle's centre was outside the gas mesh by less than its radius, as in a round vessel, whose mesh has "
    "facets. It belongs to the cell there.",
    Worry::never,
    "Its volume stays right to 1e-12 (`tests/program/SCENES.md`).",
    ""};

inline constexpr CountKind cells_pushed{"cells_pushed",
                                        "cells too full for what was inserted",
                                        Whole::cell_steps,
                                        "More was inserted into a cell at once than half of its gas has room for. The "
                                        "rest of the gas was pushed out by the flow, in one step.",
                                        Worry::any,
                                        "That is a burst of pressure: where all of 1,000 spheres came so, a small "
                                        "vessel's drop went from -388 to +330 Pa instead of 6.",
                                        "insert less at once, or in a larger region"};

inline constexpr CountKind held_at_outlet{
    "held_at_outlet",
    "particles held under an outlet by the gas",
    Whole::particle_steps,
    "A particle was packed and at rest in a cell that the gas left upwards through the outer boundary, and the "
    "pressure drop there bore its weight: an outlet that lets gas through and no particles holds a packed slug that "
    "reaches it, as a sieve does. Those behind, in cells below, are not counted.",
    Worry::share,
    "They are missing in the bed below. In `cases/sscp1` at 4.38 m/s, whose bed is thrown up when the gas sets in, a "
    "seventh of the parcels stayed there for good. A packing that nothing moves is counted, too, where it reaches such "
    "an outlet.",
    "a higher vessel, or a gentler start (`--from` a bed that bubbles, an inlet that rises with time)"};

inline constexpr CountKind steps_alternating{
    "steps_alternating",
    "gas steps that alternate",
    Whole::gas_steps,
    "Mean velocity or pressure gradient went up and down from one gas step to the next.",
    Worry::share,
    "That is the time stepping, and no physics. As long as it lasts, what is recorded may be off by its own size.",
    "a shorter gas step (deltaT), or `adjustTimeStep yes;`: the run told when it set in, and where"};

inline constexpr CountKind steps_accelerating{
    "steps_accelerating",
    "gas steps of particles beyond reason",
    Whole::gas_steps,
    "Particles were faster than gravity and gas can make them.",
    Worry::any,
    "A run that is calm has none (`tests/step/stability_silence_test.cpp`), and what follows is of the fault.",
    "a shorter gas step (deltaT), or `adjustTimeStep yes;`: the run told when it set in, and where"};

inline constexpr CountKind steps_across_cells{
    "steps_across_cells",
    "gas steps that cross a cell",
    Whole::gas_steps,
    "Some particle crossed more than a gas cell in the step, so that its drag was of a place that it had left.",
    Worry::share,
    "One particle is enough for a step to count.",
    "a shorter gas step (deltaT), or `adjustTimeStep yes;`"};

inline constexpr CountKind steps_outrun_by_waves{
    "steps_outrun_by_waves",
    "gas steps that waves outrun",
    Whole::gas_steps,
    "Waves of the solid fraction crossed more than half a cell in the step: then they grow, as drag is of the voidage "
    "at the step's start.",
    Worry::share,
    "It takes many steps in a row for a wave to grow (`tests/program/test_waves.py`).",
    "a shorter gas step (deltaT), or `adjustTimeStep yes;`"};

inline constexpr CountKind cells_beyond_close_packing{
    "cells_beyond_close_packing",
    "cells beyond close packing",
    Whole::cell_steps,
    "MP-PIC: a cell's solid fraction was above the close packing of the solids' stress, which has no contacts to keep "
    "it below.",
    Worry::share,
    "Where slugs fall back it happens: 0.12 % in sscp1 at 2.19 m/s (`cases/sscp1/README.md`), up to 0.641 where 0.6 is "
    "close packing (`plugins/mp_pic/README.md`). A bed at rest has none.",
    "a shorter gas step, or a stiffer stress (`pressure` of the fix)"};

inline constexpr CountKind step_crosses_cells{
    "step_crosses_cells",
    "steps too long for a particle's cell",
    Whole::particle_steps,
    "MP-PIC: a parcel may have crossed more of its cell in the gas step than eq. 28 of the method's paper allows.",
    Worry::share,
    "A matter of accuracy: the stress that it felt was of a place that it had left.",
    "a shorter gas step, or `adjustTimeStep yes;`"};

inline constexpr CountKind step_beyond_relaxation{
    "step_beyond_relaxation",
    "steps beyond a relaxation time",
    Whole::particle_steps,
    "MP-PIC: the step was longer than the allowed part of a parcel's relaxation time.",
    Worry::share,
    "A matter of accuracy (`plugins/mp_pic/README.md`): the stress is taken as constant over it.",
    "a shorter gas step"};

}  // namespace interphase
