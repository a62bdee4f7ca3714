#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
# label: slow
# timeout: 7200
"""The bed of cases/sscp1, 95,000 hard spheres, lies still for ten seconds at steps as long as a collision of soft ones lasts.

LIGGGHTS's own DEM of this bed, dropped from a lattice, comes to rest at a mean height of 0.083 m, 97 % of its overlaps below 0.72 % of a
diameter.
"""

import os
import sys
import unittest

import numpy

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import bed  # noqa: E402
import support  # noqa: E402

WIDTH, DEPTH, COUNT = 0.2286, 0.0762, 95000
SECONDS = 10
HEIGHT = 0.083  # mean, of the DEM [m]


class BedOfSscp1(support.ProgramTest):
    def test_ten_seconds(self):
        d = bed.DIAMETER
        poured = bed.Bed(WIDTH, DEPTH).equal(COUNT, d)
        lying = poured.pour(self.root, SECONDS, bed.collision_time(d), timeout=7000)
        self.assertEqual(lying.count[-1], COUNT, "spheres are lost")
        self.assertLess(lying.unrest(), 1e-8, "kinetic energy, over that of the impact")
        self.assertLess(abs(lying.drift()), 0.005 * d, "the height drifts [m/s]")
        self.assertLess(abs(lying.height[-1] / HEIGHT - 1), 0.03, "mean height, over that of the DEM")
        after_pour = numpy.searchsorted(lying.time, 1.0)
        self.assertLess(abs(lying.height[-1] - lying.height[after_pour]), 0.05 * d, "the bed sinks")
        self.assertLess(numpy.percentile(lying.overlaps(), 97), 0.01, "percentile 97 of the overlaps, over a diameter")


if __name__ == "__main__":
    unittest.main()
