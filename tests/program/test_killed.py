# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 600
"""A few kills of every kind; test_killed_long.py does a hundred, of all methods."""

import support
from killed_run import KilledRun


class Killed(KilledRun, support.ProgramTest):
    def test_dem(self):
        self.check_killed("DEM", 1, 3)

    def test_hard_parcels(self):
        self.check_killed("CGHS", 2, 3)

    def test_mpirun(self):
        self.check_killed("TDHS", 2, 2, launcher=True)
