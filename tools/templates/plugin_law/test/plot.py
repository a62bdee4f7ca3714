#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the law into law.png: e_n over the approach, as spheres of two sizes come back from a plane that they are thrown at."""

import os

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

HERE = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
os.environ.setdefault("RUNNER", "@INTERPHASE_BUILD@/interphase-liggghts")
os.environ.setdefault("PLUGIN", os.path.join(HERE, "build", "lib@NAME@.so"))

from throws import restitutions  # noqa: E402

SPEEDS = [10 ** (-2 + k / 10) for k in range(33)]  # m/s

for diameter in (0.0005, 0.002):
    pyplot.semilogx(SPEEDS, restitutions(SPEEDS, diameter), ".-", label=f"spheres of {1000 * diameter:g} mm at a plane")
pyplot.xlabel("approach [m/s]")
pyplot.ylabel("restitution")
pyplot.ylim(0, 1)
pyplot.legend()
pyplot.savefig(os.path.join(HERE, "law.png"), dpi=120)
print(os.path.join(HERE, "law.png"))
