#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 900
"""A run that is stopped and goes on from its last checkpoint is the run that was not stopped, to the last bit: all methods, one and two ranks,
for 20 gas steps. And what a resumed run refuses or tells."""

import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import support  # noqa: E402
from resumed_run import ResumedRun  # noqa: E402


class Resume(ResumedRun, support.ProgramTest):
    stop, end = 0.02, 0.04

    def test_dem(self):
        self.check("DEM")

    def test_parcels_with_springs(self):
        self.check("CGPM", ranks=2)

    def test_hard_spheres(self):
        self.check("TDHS")

    def test_hard_parcels(self):
        self.check("CGHS", ranks=2)

    def test_mp_pic(self):
        self.check("MPPIC")


if __name__ == "__main__":
    unittest.main()
