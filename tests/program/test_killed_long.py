# SPDX-License-Identifier: GPL-3.0-or-later
# label: slow
# processors: 2
# timeout: 7200
"""A hundred kills: all methods, one and two ranks, of a rank or of mpirun."""

import support
from killed_run import KilledRun
from resumed_run import WEIGHTS


class Killed(KilledRun, support.ProgramTest):
    def test_one_rank(self):
        for method in WEIGHTS:
            self.check_killed(method, 1, 8)

    def test_a_rank_of_two(self):
        for method in WEIGHTS:
            self.check_killed(method, 2, 8)

    def test_mpirun(self):
        for method in WEIGHTS:
            self.check_killed(method, 2, 4, launcher=True)
