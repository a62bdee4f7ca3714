#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the stress into stress.png, beside that of Harris and Crighton, which mp_pic has."""

import os

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

HERE = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
os.environ.setdefault("RUNNER", "@INTERPHASE_BUILD@/interphase-liggghts")
os.environ.setdefault("PLUGIN", os.path.join(HERE, "build", "lib@NAME@.so"))

from table import table  # noqa: E402

pyplot.semilogy(*table("stress @NAME@ 0.05 2 5 0.5 close_packing 0.65"), label="@NAME@ 0.05 2 5 0.5")
pyplot.semilogy(*table("stress harris_crighton 100 3 close_packing 0.65", "mp_pic", "mp_pic"), label="harris_crighton 100 3")
pyplot.axvline(0.65, color="0.7", label="close packing")
pyplot.xlabel("solid fraction")
pyplot.ylabel("stress [Pa]")
pyplot.xlim(0, 0.7)
pyplot.ylim(1e-3, 1e6)
pyplot.legend()
pyplot.savefig(os.path.join(HERE, "stress.png"), dpi=120)
print(os.path.join(HERE, "stress.png"))
