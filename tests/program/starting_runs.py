# SPDX-License-Identifier: GPL-3.0-or-later
"""A small bed of cases/sscp1 that tools/run prepares and runs, also with the bed of another run."""

import os
import shutil

import support
from interphase.run import Run

WIDTH, DEPTH, HEIGHT = 0.0384, 0.0192, 0.096  # [m]
DIAMETER, DENSITY = 2e-3, 1131.0
COUNT = 1600  # real particles
CELLS = "(8 4 16)"
SETTINGS = {"width": WIDTH, "depth": DEPTH, "height": HEIGHT, "diameter": DIAMETER, "particleCount": COUNT, "initialPacking": 0.35, "inletVelocity": 0.4,
            "system/controlDict:writeInterval": 0.02, "system/controlDict:deltaT": 1e-3}


def case(root, name="bed", cells=CELLS):
    """sscp1 in a smaller vessel, with fewer cells, more snapshots and taps that lie in it."""
    folder = os.path.join(root, name)
    shutil.copytree(os.path.join(support.SOURCE, "cases", "sscp1"), folder, ignore=shutil.ignore_patterns("*.png", "README.md"))
    edit = support.ProgramTest.edit
    edit(folder, "system/blockMeshDict", r"\(16 4 85\)", cells)
    low, high = (f"({WIDTH / 2} {DEPTH / 2} {z})" for z in (0.003, 0.093))
    edit(folder, "system/couplingDict", r"^    pressureTaps .*$", f"    pressureTaps ({low} {high});")
    edit(folder, "system/couplingDict", r"interval            0.05;", "interval 1e-3;")
    edit(folder, "system/couplingDict", r"snapshotInterval    0.05;", "snapshotInterval 0.01;")
    return folder


def plain(folder, out, *words, program=support.PROGRAM):
    """tools/run with words of its command line: a CompletedProcess."""
    return support.tool("run", folder, "--out", out, "--no-picture", *words, program=program)


def run(folder, out, *words, program=support.PROGRAM, **changes):
    """The same with the small bed's numbers but for `changes`."""
    return plain(folder, out, *words, *support.settings_of({**SETTINGS, **changes}), program=program)


def snapshots(out):
    """[(time, {name: rows by id})]."""
    return [(each.time, each.arrays()) for each in Run(out).snapshots]


def series(out, name):
    return Run(out).series[name].values


def record(out):
    return Run(out).record
