# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs that differ by parcels or steps: which belong together, what they are extrapolated to, with errors that hold, and what does not lie on a line."""

import dataclasses
import math
import re
import unittest

import numpy
from scipy.stats import t as student

from interphase import convergence, page_convergence
from interphase.report_page import distance_words
from interphase.run_account import Account
from interphase.run_report import Quantity, RunReport
from interphase.run_sheet import Sheet
from test_trade import mean

ACCOUNT = Account(folder="", case="bed", method="CGHS", weight=8.0, command="", commit="", versions="", machine="", date="", ranks=1, particles=100.0,
                  gas_step=1e-3, solid_step=1e-3, simulated=1.0, wall=1.0, cpu=1.0)  # fmt: skip


def sheet(value=1.0, error=0.01, reason="", **account):
    of = dataclasses.replace(ACCOUNT, **account)
    report = RunReport(0, 0.0, 1.0, series=[Quantity("pressure drop", "Pa", mean(value, error, reason))])
    return Sheet(f"{of.method}-w{of.weight:g}", of, report, None, 0.0, 1.0, "")


def limit(values, means, to=0.0):
    return convergence.limit_of(values, [[each] for each in means], to, "Pa")


class Families(unittest.TestCase):
    def test_parcels_and_every_particle_as_their_limit(self):
        sheets = [sheet(weight=w, method=m) for w, m in ((8, "CGHS"), (1, "TDHS"), (64, "CGHS"), (27, "CGHS"), (8, "CGPM"), (27, "MPPIC"))]
        family, = convergence.families(sheets)
        self.assertEqual((family.method, family.by, family.limit), ("CGHS", "parcel diameter", 1.0))
        numpy.testing.assert_allclose(family.values, (4, 3, 2, 1))
        self.assertEqual(family.fitted, (True, True, True, False))

    def test_where_a_run_begins_makes_no_difference_other_settings_do(self):
        sheets = [sheet(weight=w, settings=(f"initialPacking=0.{w}", f"seed={w}", "restitution=0.5")) for w in (8, 27, 64)]
        self.assertEqual(len(convergence.families(sheets)), 1)
        sheets[0] = sheet(weight=8, settings=("restitution=0.6",))
        self.assertEqual(convergence.families(sheets), [])

    def test_steps_go_to_zero(self):
        sheets = [sheet(solid_step=s, method="TDHS", weight=1, settings=(f"particles/stepsPerCollision={1e-3 / s:g}",)) for s in (5e-4, 1e-3, 2e-4)]
        family, = convergence.families(sheets)
        self.assertEqual((family.by, family.unit, family.limit, family.values), ("solid step", "s", 0.0, (1e-3, 5e-4, 2e-4)))
        sheets = [sheet(gas_step=s, settings=(f"system/controlDict:deltaT={s:g}",)) for s in (1e-3, 2e-3, 4e-3)]
        self.assertEqual([each.by for each in convergence.families(sheets)], ["gas step"])

    def test_two_runs_are_none(self):
        self.assertEqual(convergence.families([sheet(weight=8), sheet(weight=27), sheet(weight=27)]), [])


class Limits(unittest.TestCase):
    def test_a_line_by_least_squares(self):
        """Equal errors s at x = 1, 2, 3: the value at 0 has the variance s^2 (1/3 + 2^2/2)."""
        found = limit([3, 2, 1], [mean(7 + 2 * x, 0.1) for x in (3, 2, 1)])
        self.assertEqual(found.degree, 1)
        self.assertAlmostEqual(found.means[0].value, 7, delta=1e-12)
        self.assertAlmostEqual(found.means[0].error, 0.1 * math.sqrt(1 / 3 + 2), delta=1e-12)

    def test_a_parabola_where_the_line_is_rejected(self):
        bent = [mean(7 + x * x, 0.01) for x in (4, 3, 2, 1)]
        found = limit([4, 3, 2, 1], bent)
        self.assertEqual(found.degree, 2)
        self.assertAlmostEqual(found.means[0].value, 7, delta=1e-10)
        three = limit([4, 3, 2], bent[:3])
        self.assertIsNone(three.degree)
        self.assertIn("a line", three.reason)
        self.assertIsNone(limit([4, 3, 2, 1], [mean(x**6, 0.01) for x in (4, 3, 2, 1)]).degree)

    def test_bars_of_the_limit_hold_and_lines_are_seldom_rejected(self):
        """1,000 families of four runs on a line, errors known to 30 degrees of freedom: 95 % within 1.5 %, two binomial deviations."""
        random, held, lines = numpy.random.default_rng(1), 0, 0
        x, true = numpy.array([4.0, 3, 2, 1]), numpy.array([0.2, 0.1, 0.1, 0.05])
        for _ in range(1000):
            errors = true * numpy.sqrt(random.chisquare(30, 4) / 30)
            found = limit(list(x), [mean(v, e) for v, e in zip(5 + x + true * random.standard_normal(4), errors)])
            lines += found.degree == 1
            if found.degree == 1:
                at = found.means[0]
                held += abs(at.value - 5) <= student.ppf(0.975, at.freedom) * at.error
        self.assertAlmostEqual(held / lines, 0.95, delta=0.015)
        self.assertAlmostEqual(lines / 1000, 1 - convergence.LEVEL, delta=0.015)

    def test_what_is_not_known_or_not_trusted_stays_so(self):
        self.assertIn("errors are not known", limit([3, 2, 1], [mean(1, 0.1), mean(1, math.nan), mean(1, 0.1)]).reason)
        self.assertEqual(limit([3, 2, 1], [mean(1, 0.1), mean(1, 0.1, "too short"), mean(1, 0.1)]).means[0].reason, "too short")


class Page(unittest.TestCase):
    def section(self, *slope_and_truth):
        slope, truth = slope_and_truth
        sheets = [sheet(truth, 0.01, method="DEM", weight=1)] + [sheet(5 + slope * (w ** (1 / 3) - 1), 0.01, weight=w) for w in (64, 27, 8)]
        return page_convergence.section(sheets, "full_depth", lambda name: name, distance_words)

    def test_it_says_whether_the_limit_is_the_reference(self):
        for truth, words in ((5, "not told apart"), (6, "told apart")):
            text = re.sub('src="[^"]*"', "", self.section(1, truth))
            self.assertIn(f"CGHS at the limit: {words} from DEM-w1 by pressure drop", text)
            self.assertIn("5.000 +- ", text)

    def test_nothing_without_a_family(self):
        self.assertEqual(page_convergence.section([sheet(), sheet(weight=8)], "full_depth", str, distance_words), "")


if __name__ == "__main__":
    unittest.main()
