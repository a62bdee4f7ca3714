# SPDX-License-Identifier: GPL-3.0-or-later
"""Replicates: which runs are, and that errors which hold are seldom called wrong and wrong ones are."""

import re
import unittest

import numpy

from interphase import page_replicates, replicates
from test_convergence import sheet
from test_trade import mean


class Groups(unittest.TestCase):
    def test_runs_that_differ_in_seed_only(self):
        sheets = [sheet(settings=(f"seed={n}", "restitution=0.5")) for n in range(3)]
        self.assertEqual([len(group) for group in replicates.groups([*sheets, sheet(weight=27), sheet(settings=("restitution=0.6",))])], [3])
        self.assertEqual(replicates.groups(sheets[:2]), [])


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
