# SPDX-License-Identifier: GPL-3.0-or-later
"""What a law of contacts costs: beds with each law in turn, and the time of each over that of the built-in one in the same turn."""

import math
import os
import statistics

from interphase import tables
from interphase.launch import build_folder
from interphase.settled_bed import DENSITY, DIAMETER, Law, spans

FALL, SETTLE, REST = 200, 600, 200  # steps
BUILT_IN = "tdhs"
WEIGHT = DENSITY * math.pi / 6 * DIAMETER**3 * 9.81  # N
ROLLING = {"coefficientRollingFriction": 0.1}
# two of them part at five times their weight, over a hundredth of a diameter
COHESION = {"workOfAdhesion": 5 * WEIGHT / (2 * math.pi * DIAMETER / 4), "cohesionRange": 0.01 * DIAMETER}
LAWS = {
    BUILT_IN: Law(),
    "tdhs/viscoelastic": Law("laws", "tdhs/viscoelastic", {"contactModulus": 1e7, "dissipativeTime": 6e-6}),
    "tdhs/rolling": Law("laws", "tdhs/rolling", ROLLING),
    "tdhs/cohesive": Law("laws", "tdhs/cohesive", COHESION),
    "tdhs/cohesive_rolling": Law("laws", "tdhs/cohesive_rolling", ROLLING | COHESION),
}
LANES = "INTERPHASE_LANES"  # plugins/hard_sphere/lanes.hpp


def laws(against=None):
    """{name: Law}: those of this tree, the built-in one as a plug-in of its own where the tests are built, and that of the build folder `against`."""
    found = dict(LAWS)
    as_plugin = os.path.join(build_folder(), "tests", "plugins", "libconstant_law.so")
    if os.path.exists(as_plugin):
        found["built-in, as a plug-in"] = Law(as_plugin, "tdhs/constant_law")
    if against:
        found[f"tdhs of {against}"] = Law(environment={"INTERPHASE_BIN": os.path.join(against, "interphase"), "INTERPHASE_PLUGIN_PATH": os.path.join(against, "plugins")})
    return found


def measure(count, rounds, wanted, lanes, say):
    """{name: [(falling, at rest)]}, seconds per step, a pair each round. `lanes`: contacts at once; 0: what the processor has."""
    seconds = {name: [] for name in wanted}
    for turn in range(rounds):
        names = list(wanted)
        for name in names if turn % 2 == 0 else reversed(names):  # what slows the machine down hits each as often first
            law = wanted[name]
            if lanes:
                law = Law(law.plugin, law.style, law.properties, law.environment | {LANES: str(lanes)})
            falling, _, rest = spans(count, (FALL, SETTLE, REST), law)
            seconds[name].append((falling.seconds, rest.seconds))
        say(f"round {turn + 1}, us per step falling / at rest: " + ", ".join(f"{name} {1e6 * s[-1][0]:.0f} / {1e6 * s[-1][1]:.0f}" for name, s in seconds.items()))
    return seconds


def report(seconds):
    """Lines: medians over the rounds of the time over the built-in law's of the same round, least to most."""
    rows = [("law", "falling", "", "at rest", "")]
    for name, each in seconds.items():
        row = [name]
        for state in (0, 1):
            ratios = [own[state] / base[state] for own, base in zip(each, seconds[BUILT_IN])]
            row += [f"{statistics.median(ratios):.2f}", f"{min(ratios):.2f} to {max(ratios):.2f}"]
        rows.append(row)
    return tables.columns(rows, right=(1, 3))
