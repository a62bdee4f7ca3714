# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 900
"""cases/cohesive-bed: gas that speeds up lifts a bed without cohesion when it carries the weight; one with cohesion when it carries the
bonds to the floor, too."""

import os
import runpy
import types
import unittest

import numpy

import measured
import support

CASE = os.path.join(support.SOURCE, "cases", "cohesive-bed")
MEASURES = runpy.run_path(os.path.join(CASE, "agglomerates.py"))


class Bed(support.ProgramTest):
    def lifted(self, bond):
        """Pressure drop that lifts a bed between sides without friction, and the bonds to the floor, both over the weight."""
        done = self.run_case(self.prepared("cohesive-bed", f"bond{bond}", method="CGHS", weight=8, bondNumber=bond, wallFriction=0, until=0.6))
        self.assert_books_close(done, ("momentum", "volume"))  # of the gas nothing has come in at first
        p = MEASURES["numbers_of"](done.run)
        resting = [each for each in done.run.snapshots if each.time < p["rampStart"] + 1e-9][-1]
        floor, sides = MEASURES["holds"](resting, p)
        self.assertEqual(sides, 0)
        drop, _, lifted = MEASURES["lift"](done.run, p)
        self.assertTrue(lifted)
        return drop, floor

    def test_what_lifts_the_bed(self):
        """The weight, and with cohesion the bonds of all that touch the floor; within a tenth of the weight, as bonds do not tear all at once and a bed is
        set going in passing."""
        free, _ = self.lifted(0)
        measured.within(self, "bed without cohesion, parcels of 8: pressure drop that lifts it over its weight", free, 1, 0.1, "", "weight")
        peak, floor = self.lifted(5)
        self.assertGreater(floor, 0.25)  # more than what the law is held to
        measured.within(self, "cohesive bed, Bo 5, parcels of 8: the same", peak, 1 + floor, 0.1, "", "weight and pull-off force of all that touch the floor")

    def test_on_ranks(self):
        for method, weight in (("TDHS", 1), ("CGHS", 8)):
            done = self.run_case(self.prepared("cohesive-bed", method, 2, method=method, weight=weight, until=0.01), 2)
            self.assert_books_close(done, ("momentum", "volume"))


class Measures(unittest.TestCase):
    def snapshot(self, positions):
        return types.SimpleNamespace(ids=numpy.array([7, 3, 5, 9, 4]), positions=numpy.array(positions))

    def test_agglomerates_reach_across_the_sides_that_repeat(self):
        p = {"diameter": 1e-3, "weight": 1, "depth": 6e-3}
        first = [[5e-3, 5.9e-3, 1e-3], [5e-3, 0.9e-3, 1e-3], [5e-3, 1.9e-3, 1e-3], [5e-3, 3e-3, 3e-3], [6e-3, 3e-3, 3e-3]]
        then = [*first[:2], [5e-3, 2.1e-3, 1e-3], *first[3:]]  # the third has left the second one
        before, after = self.snapshot(first), self.snapshot(then)
        for snapshots, expected in (((before, before), [3, 3, 3, 2, 2]), ((before, after), [2, 2, 1, 2, 2])):
            pairs = MEASURES["lasting"](snapshots, p)
            numpy.testing.assert_array_equal(MEASURES["sizes"](before.ids, pairs), expected)
