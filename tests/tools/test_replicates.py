# SPDX-License-Identifier: GPL-3.0-or-later
"""Replicates: which runs are, and that errors which hold are seldom called wrong and wrong ones are."""

import dataclasses
import math
import re
import unittest

import numpy

from interphase import page_replicates, replicates, run_account
from interphase.run_account import Cost
from test_convergence import ACCOUNT, sheet
from test_trade import mean


class Groups(unittest.TestCase):
    def test_runs_that_differ_in_seed_only(self):
        sheets = [sheet(settings=(f"seed={n}", "restitution=0.5")) for n in range(3)]
        self.assertEqual([len(group) for group in replicates.groups([*sheets, sheet(weight=27), sheet(settings=("restitution=0.6",))])], [3])
        self.assertEqual(replicates.groups(sheets[:2]), [])


class Accounts(unittest.TestCase):
    def of(self, simulated, cost, error):
        return dataclasses.replace(ACCOUNT, simulated=simulated, cpu=cost * simulated, cost=Cost(cost, error, "CPU time", {"solids": cost / 2}), start=f"TDHS at {simulated:g} s")

    def test_of_several_as_one(self):
        both = run_account.of_replicates([self.of(1.0, 8.0, 0.3), self.of(3.0, 12.0, 0.4)])
        self.assertEqual((both.simulated, both.cpu, both.start), (4.0, 44.0, "TDHS at 1 s; TDHS at 3 s"))
        self.assertAlmostEqual(both.cost.value, 11.0)
        self.assertAlmostEqual(both.cost.phases["solids"], 5.5)
        # the scatter: 1/4 of 3 and 3/4 of 1 off the mean, squared, summed and doubled; more than (0.3/4, 3 0.4/4)
        self.assertAlmostEqual(both.cost.error, math.sqrt(2 * (0.75**2 + 0.75**2)))
        self.assertEqual(run_account.of_replicates([self.of(1.0, 8.0, 0.3)]), self.of(1.0, 8.0, 0.3))
        self.assertIsNone(run_account.of_replicates([self.of(1.0, 8.0, 0.3), ACCOUNT]).cost)


class Scatters(unittest.TestCase):
    def outside(self, claimed, random):
        """Share of 1,000 groups of eight whose errors are `claimed` times the true ones, known to 16 degrees of freedom."""
        found = []
        for _ in range(1000):
            errors = claimed * numpy.sqrt(random.chisquare(16, 8) / 16)
            found.append(not replicates.scatter_of("q", "", [mean(v, e, freedom=16.0) for v, e in zip(random.standard_normal(8), errors)]).holds)
        return numpy.mean(found)

    def test_bounds_hold(self):
        """5 % outside, two binomial deviations of 1,000 are 1.4 %; F of the least freedom, here the same for all, is too wide by a little."""
        random = numpy.random.default_rng(2)
        self.assertLess(self.outside(1.0, random), 0.064)
        self.assertGreater(self.outside(1.0, random), 0.005)
        self.assertGreater(self.outside(0.5, random), 0.6)

    def test_the_page(self):
        values = (1.0, 1.01, 0.99, 1.5)
        sheets = [sheet(v, 0.01, settings=(f"seed={n}",)) for n, v in enumerate(values)]
        text = page_replicates.section(sheets, "full_depth", str)
        self.assertRegex(text, r"Of 1 means 1 scatter")
        self.assertIn("outside", re.sub("<[^>]*>", " ", text))
        self.assertEqual(page_replicates.section(sheets[:2], "full_depth", str), "")


if __name__ == "__main__":
    unittest.main()
