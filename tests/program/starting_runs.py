# SPDX-License-Identifier: GPL-3.0-or-later
"""A small bed of cases/sscp1 that tools/run prepares and runs, also with the bed of another run."""

import json
import os
import shutil
import subprocess

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


def plain(folder, out, *words, program=None):
    """tools/run with words of its command line: a CompletedProcess."""
    return subprocess.run(
        [os.path.join(support.TOOLS, "run"), folder, "--out", out, "--no-picture", *words],
        env=support.environment(INTERPHASE_BIN=program or support.PROGRAM), stdin=subprocess.DEVNULL, capture_output=True, text=True,
        timeout=support.LONGEST)


def run(folder, out, *words, program=None, **changes):
    """The same with the small bed's numbers but for `changes`."""
    settings = [word for key, value in {**SETTINGS, **changes}.items() for word in ("--set", f"{key}={value}")]
    return plain(folder, out, *words, *settings, program=program)


def snapshots(out):
    """[(time, {name: rows by id})]."""
    return [(each.time, each.arrays()) for each in Run(out).snapshots]


def series(out, name):
    return Run(out).series[name].values


def record(out):
    with open(os.path.join(out, "run.json"), encoding="utf-8") as stream:
        return json.load(stream)
