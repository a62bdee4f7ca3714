# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances of runs to a reference: what noise alone makes is 0 on average, a difference is found with its error, and who is beaten by whom."""

import math
import unittest

import numpy

from interphase import trade
from interphase.run_account import Cost
from interphase.run_report import Quantity, RunReport
from interphase.time_statistics import Mean


def mean(value, error, reason="", freedom=30.0):
    return Mean(float(value), float(error), 1.0, 100, 50.0, freedom, 1.0, reason)


def report(*values, name="pressure drop"):
    """A `RunReport` with one series for each (value, error)."""
    return RunReport(0, 0.0, 1.0, series=[Quantity(f"{name} {at}" if at else name, "Pa", mean(*each)) for at, each in enumerate(values)])


class Distances(unittest.TestCase):
    def test_a_difference_is_relative_to_the_reference(self):
        found, = trade.distances(report((100, 0.001)), report((110, 0.001)), "full_depth")
        self.assertAlmostEqual(found.value, 0.1, delta=1e-5)
        self.assertTrue(found.told_apart)
        # d(D) = d(x)/r = sqrt(2) 0.001/100; that of D^2 is 2 D times it
        self.assertAlmostEqual(found.square_error, 2 * 0.1 * math.sqrt(2) * 1e-5, delta=1e-9)

    def test_equal_runs_are_at_0_on_average_and_seldom_told_apart(self):
        random, count, parts = numpy.random.default_rng(3), 4000, 5
        reference = 1 + 0.05 * random.standard_normal((count, parts))
        other = 1 + 0.05 * random.standard_normal((count, parts))
        found = [trade._distance("q", [mean(x, 0.05, freedom=1e9) for x in a], [mean(x, 0.05, freedom=1e9) for x in b],
                                 [mean(x, 0.05) for x in a], "q") for a, b in zip(reference, other)]  # fmt: skip
        squares = numpy.array([each.square for each in found])
        # The mean of 4,000 squares scatters by their deviation / sqrt(4,000): four of them
        self.assertLess(abs(squares.mean()), 4 * squares.std() / math.sqrt(count))
        # Var(sum d^2) = 2 n v^2 where nothing differs; ours adds 4 d^2 v, whose mean is 4 n v^2: the error is on the safe side by sqrt(3)
        self.assertAlmostEqual(numpy.mean([each.square_error for each in found]) / squares.std(), math.sqrt(3), delta=0.25)
        apart = numpy.mean([each.told_apart for each in found])
        # Bonferroni's bound is 5 %; 4,000 trials scatter by 0.35 %
        self.assertLess(apart, 0.05 + 4 * 0.0035)
        self.assertGreater(apart, 0.03)

    def test_what_has_no_error_or_is_not_trusted_is_not_judged(self):
        for other in ((110, math.nan, "few"), (110, 1, "drifts")):
            found, = trade.distances(report((100, 1)), report(other), "full_depth")
            self.assertTrue(math.isnan(found.chance))
            self.assertIn(other[2], found.reason)
            self.assertFalse(found.told_apart)

    def test_a_mean_without_degrees_of_freedom_tells_nothing_apart(self):
        ours = RunReport(0, 0.0, 1.0, series=[Quantity("pressure drop", "Pa", mean(110, 1, freedom=0.0))])
        found, = trade.distances(report((100, 1)), ours, "full_depth")
        self.assertFalse(found.told_apart)

    def test_overall_is_the_root_mean_square(self):
        found = trade.distances(report((100, 1e-6), (10, 1e-6)), report((103, 1e-6), (10.4, 1e-6)), "full_depth")
        self.assertAlmostEqual(trade.overall(found).value, math.sqrt((0.03**2 + 0.04**2) / 2), delta=1e-6)
        self.assertIsNone(trade.overall([]))

    def test_quantities_can_be_chosen(self):
        found = trade.distances(report((100, 1), (10, 1)), report((100, 1), (10, 1)), "full_depth", ["pressure drop"])
        self.assertEqual([each.quantity for each in found], ["pressure drop"])

    def test_who_costs_more_and_is_farther_is_beaten(self):
        def point(name, cost, square):
            far = None if square is None else trade.Distance("overall", square, 0.0, 0.0, 0.0, "")
            return trade.Point(name, Cost(cost, math.nan, "CPU time"), far)

        points = [point("DEM", 100, None), point("CGHS", 2, 0.01), point("MPPIC", 3, 0.2), point("CGPM", 5, 0.005)]
        self.assertEqual(trade.best(points), ["DEM", "CGHS", "CGPM"])


class Means(unittest.TestCase):
    def test_the_mean_of_independent_means(self):
        found = trade.as_mean([mean(1, 0.3), None, mean(3, 0.4)])
        self.assertEqual((found.value, found.error), (2.0, 0.25))
        self.assertIsNone(trade.as_mean([None]))
        # Welch and Satterthwaite: (0.0625)^2 / ((0.0225^2 + 0.04^2) / 30)
        self.assertAlmostEqual(found.freedom, 0.0625**2 / ((0.0225**2 + 0.04**2) / 30))


if __name__ == "__main__":
    unittest.main()
