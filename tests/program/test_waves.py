# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 300
"""A column fluidized by a viscous liquid in steps that waves of its solid fraction outrun: told once, counted, and with adjustTimeStep the
step gives way. Other spheres, liquid, cells and law than those that the limit was found with."""

import os
import re

import support

TOLD = "waves of the solid fraction run"
SCENE = {
    "mode": "fluidized", "solidFraction": 0.35, "startFraction": 0.36, "bedHeight": 0.03, "width": 0.006, "depth": 0.006, "height": 0.05,
    "cells": "(1 1 16)", "diameter": 1.5e-3, "particleDensity": 2500, "gasDensity": 1200, "gasViscosity": 0.01, "dragLaw": "Ergun",
}  # fmt: skip


class Waves(support.ProgramTest):
    def column(self, name, step, adjusted):
        """(what the run said, its ledger's count of outrun steps)."""
        out = os.path.join(self.root, name)
        settings = {**SCENE, "gasStep": step, "recordInterval": step, "system/controlDict:adjustTimeStep": "yes" if adjusted else "no"}
        done = support.Finished(self.ran("suspension", out, until=8 * step, **settings))
        return support.read(out, "log.interphase"), done.column("ledger/steps_outrun_by_waves")[-1]

    def test_are_told_and_obeyed(self):
        said, outrun = self.column("long", 0.1, False)
        self.assertEqual(said.count(TOLD), 1, said)
        self.assertEqual(outrun, 8)
        limit = float(re.search(r"a gas step below ([0-9.e-]+) s", said)[1])
        self.assertLess(limit, 0.1)

        _, outrun = self.column("short", 0.2 * limit, False)
        self.assertEqual(outrun, 0)

        said, outrun = self.column("adjusted", 0.1, True)
        cells = float(re.search(TOLD + r" ([0-9.]+) gas cells", said)[1]) if TOLD in said else 0.0
        self.assertLess(cells, 1)  # the limit is 0.5, and answers to the step before
