# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 600
"""A count that is to be looked at is told in the course of the run, once: other counts, steps, ranks and fluids than those of test_held, without gas, and over a resume."""

import re
import tempfile
import unittest

import support
import vessel
from resumed_run import ResumedRun

TOLD = re.compile(r'^t = (\S+) s: look at "([^"]+)": ([\d,]+|[\d.]+ d)(?:, ([\d.]+) %)?, in the last 100 gas steps \(interphase -help counts\)$', re.M)
DRAG, OVERLAP = "particles beyond the drag law's range", "deepest overlap of spheres"
# few particles in much gas, where Ergun's law does not claim to hold
LOOSE = [("system/couplingDict", r"law     BVK;", "law Ergun;")]
WATER = {"gasDensity": 1000, "gasViscosity": 1e-3, "inletVelocity": 0.01}


class CountNews(ResumedRun, support.ProgramTest):
    stop, end = 0.015, 0.03

    def bed(self, method):
        lines, _ = vessel.bed(2, 20, spacing=2)
        return vessel.case(tempfile.mkdtemp(dir=self.root), lines, edits=LOOSE)

    def ended(self, case, method="TDHS", ranks=1, until=0.03, **settings):
        return self.run_case(vessel.prepared(self, case, method, ranks, until, **settings), ranks)

    def test_a_range_that_is_left(self):
        for name, method, ranks, step, settings in (
            ("DEM", "DEM", 1, 2e-4, {}), ("two ranks", "TDHS", 2, 2e-4, {}), ("MP-PIC", "MPPIC", 1, 2e-4, {}), ("shorter steps", "TDHS", 1, 1e-4, {}), ("water", "TDHS", 1, 1e-4, WATER),
        ):
            with self.subTest(name):
                done = self.ended(self.bed(method), method, ranks, **{"system/controlDict:deltaT": step, **settings})
                (time, what, _, share), *more = TOLD.findall(done.out)
                self.assertEqual((float(time), what, more), (round(100 * step, 9), DRAG, []))
                self.assertGreater(float(share), 1)

    def test_not_where_steps_are_too_few(self):
        done = self.ended(self.bed("TDHS"), until=0.018, **{"system/controlDict:deltaT": 2e-4})
        self.assertEqual(TOLD.findall(done.out), [])
        self.assertRegex(done.out, DRAG + r" +[\d,]+ .*look at it")

    def test_without_gas(self):
        """Spheres that were put 0.3 of a diameter into each other."""
        lines, _ = vessel.bed(3, spacing=0.7)
        case = vessel.case(tempfile.mkdtemp(dir=self.root), lines, edits=[("system/couplingDict", r"model       pimple;\s+coupling    twoWay;", "model none;")])
        (time, what, deepest, _), *more = TOLD.findall(self.ended(case, **{"system/controlDict:deltaT": 1e-4}).out)
        self.assertEqual((float(time), what, more), (0.01, OVERLAP, []))
        self.assertGreater(float(deepest.split()[0]), 0.2)

    def test_over_a_resume(self):
        """Trouble that goes on is told again by the part of the run that goes on, a hundred steps after it began."""
        _, stopped = self.ready("TDHS", **{"system/controlDict:deltaT": 1e-4})
        done = self.resumed(stopped)
        self.assertEqual([(time, what) for time, what, *_ in TOLD.findall(done.out)], [("0.025", DRAG)])


if __name__ == "__main__":
    unittest.main()
