// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugin/counter.hpp"

namespace interphase::hard_sphere {

/// What fix tdhs counts; Counting::values has their numbers in this order.
enum CounterOf { steps_in_parts, deepest_overlap, impulses_left_out, counter_number };

constexpr double deep = 0.2;  ///< of a diameter: overlaps that are worth a word

constexpr Counter counters[counter_number] = {
    {"steps_in_parts", "solid steps resolved in parts", "", OverRanks::largest, never_worry,
     "A sphere moved so far in a solid step that it might have passed through another: the contacts of the step were "
     "resolved in several parts.",
     "The parts are as good as shorter steps. They cost as much, too: where most steps are in parts, a shorter step "
     "costs "
     "nothing.",
     ""},
    {"deepest_overlap", "deepest overlap of spheres", "d", OverRanks::largest, deep,
     "The deepest that two spheres overlapped so far, in diameters of the smallest sphere.",
     "Hard spheres overlap because the passes over the contacts of a step leave some of their approach. 97 % of the "
     "overlaps of sscp1 are below 0.006 (`plugins/hard_sphere/README.md`); a single deep one may be of spheres that "
     "were "
     "put there so.",
     "more `passes` of fix tdhs, or a shorter solid step, if the bed sinks"},
    {"impulses_left_out", "impulses that a sphere could not take along", "", OverRanks::sum, 0,
     "A sphere that had gained some 200 loaded contacts since spheres last changed ranks, less where a law keeps a "
     "state of each, was saved in a checkpoint: there was no room for more, and the impulses of the others start from "
     "nothing in a run that goes on from there.",
     "The contacts of that sphere carry their load again after some steps; until then what rests on it sags.",
     "a checkpoint at another time"},
};

}  // namespace interphase::hard_sphere
