# SPDX-License-Identifier: GPL-3.0-or-later
# label: slow
# processors: 2
# timeout: 3600
"""test_survival.py with more kills."""

import test_survival


class Kills(test_survival.Bed):
    def test_of_the_only_rank(self):
        self.check_kills(1, False, 100)

    def test_of_one_rank_of_two(self):
        self.check_kills(2, False, 100)

    def test_of_mpirun(self):
        self.check_kills(2, True, 20)
