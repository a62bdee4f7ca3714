# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run will cost, by timings that are made up: rates, trends, what is taken from a cheaper method, exponents, the paper's ratios."""

import math
import os
import unittest

import numpy

from interphase import cost_model, cost_study
from interphase.cost_model import Output, Pace
from interphase.input_error import InputError
from scratch import InFolder

TIME = numpy.linspace(0.0, 0.1, 101)
LONG = numpy.linspace(0.0, 1.0, 1001)


def loosening(time, rate, rise=1.5, span=0.1):
    """Seconds spent up to `time` at a rate that goes from `rate` to (1 + rise) times that over `span` [s]."""
    return rate * (time + rise * (time - span * (1 - numpy.exp(-time / span))))


class Paces(unittest.TestCase):
    def test_a_steady_cost_goes_on(self):
        found = cost_model.pace(TIME, 3 + 40 * TIME)
        seconds, error = found.seconds(10.0)
        self.assertAlmostEqual(seconds, 400)
        self.assertAlmostEqual(error, 0, places=6)
        self.assertAlmostEqual(found.seconds(0.05)[0], 2)
        self.assertEqual(found.seconds(0.05)[1], 0)  # it was measured

    def test_noise_is_in_the_error(self):
        """Blocks of four steps scatter by 10 %, the mean of the later twelve by 10 %/sqrt(12); the trend that noise alone makes, the difference of two halves,
        has twice that: together up to 2.2 times."""
        draw = numpy.random.default_rng(3)
        off, claimed = [], []
        for _ in range(200):
            steps = 40 * 1e-3 * (1 + 0.2 * draw.standard_normal(100))
            seconds, error = cost_model.pace(TIME, numpy.concatenate([[0], numpy.cumsum(steps)])).seconds(10.0)
            off.append(seconds - 400)
            claimed.append(error)
        self.assertGreater(numpy.mean(claimed), 0.9 * numpy.std(off))
        self.assertLess(numpy.mean(claimed), 2.3 * numpy.std(off))

    def test_a_trend_is_in_the_error(self):
        seconds, error = cost_model.pace(TIME, loosening(TIME, 40)).seconds(0.3)
        self.assertLess(abs(seconds - loosening(0.3, 40)), 3 * error)
        self.assertGreater(error, 0.02 * seconds)

    def test_too_few_steps_are_refused(self):
        with self.assertRaisesRegex(InputError, "give the calibration more time"):
            cost_model.pace(TIME[:4], TIME[:4])


class Shapes(unittest.TestCase):
    def test_a_costly_method_goes_on_as_a_cheap_one_does(self):
        own = cost_model.pace(TIME[:31], loosening(TIME[:31], 900.0))
        shape = cost_model.pace(LONG, loosening(LONG, 5.0))
        found = cost_model.shaped(own, shape)
        # blocks of the other are 40 ms wide, and its rate within one is not resolved: 3 %
        self.assertAlmostEqual(found.seconds(1.0)[0] / loosening(1.0, 900.0), 1, delta=0.03)
        self.assertAlmostEqual(own.seconds(1.0)[0] / loosening(1.0, 900.0), 0.55, delta=0.1)  # which it was not by itself
        self.assertGreaterEqual(found.seconds(1.0)[1], 0.9 * cost_model.SHAPE_ERROR * found.seconds(1.0)[0])

    def test_what_a_step_costs_in_any_case_does_not_rise(self):
        """3000 spheres that cost 300 s/s at first and 400 parcels that cost 10, and as much for their steps: the rise of both is 2.5 in the end, that of the
        parcels' whole cost 1.75."""
        own = cost_model.pace(TIME[:31], loosening(TIME[:31], 300.0))
        shape = cost_model.pace(LONG, loosening(LONG, 10.0) + 10.0 * LONG)
        right = loosening(1.0, 300.0)
        seconds, error = cost_model.shaped(own, shape, work=30).seconds(1.0)
        low = cost_model.shaped(own, shape).seconds(1.0)[0]
        self.assertLess(low, 0.85 * right)
        self.assertAlmostEqual(seconds, (low + right) / 2, delta=0.03 * right)  # as above
        self.assertLess(abs(seconds - right), 1.1 * error)

    def test_costs_of_steps_do_not_count_where_spheres_are_many(self):
        """All of a cost rises, and spheres of the costly method are dearer, each by itself: the ratio alone counts."""
        own = cost_model.pace(TIME[:31], loosening(TIME[:31], 900.0))
        shape = cost_model.pace(LONG, loosening(LONG, 5.0))
        self.assertEqual(cost_model.shaped(own, shape, work=150).seconds(1.0), cost_model.shaped(own, shape).seconds(1.0))

    def test_one_that_went_no_further_adds_nothing(self):
        own = cost_model.pace(TIME, 40 * TIME)
        self.assertIs(cost_model.shaped(own, cost_model.pace(TIME[:51], TIME[:51])), own)


class Sums(unittest.TestCase):
    def test_phases_output_and_clock(self):
        paces = {phase: Pace(numpy.array([0.5]), numpy.array([rate]), numpy.array([1.0]), numpy.zeros(1)) for phase, rate in (("solids", 10.0), ("gas", 5.0))}
        output = Output(row=0.01, snapshot=0.5, row_bytes=100, snapshot_bytes=1e6, field_bytes=2e5, intervals=(0.1, 0.5, math.inf))
        found = cost_model.cost(paces, output, 1.0, setup=2.0)
        self.assertAlmostEqual(found.seconds["output"], 10 * 0.01 + 3 * 0.5)
        self.assertAlmostEqual(found.total, 10 + 5 + 1.6 + 2)
        self.assertAlmostEqual(found.wall(2), found.total / 2)
        self.assertAlmostEqual(output.bytes(1.0, 1e-3), 1000 * 100 + 3e6)

    def test_the_paper(self):
        """DESIGN: CGPM 1/W^1.5, TDHS 1/S, CGHS 1/(S W^1.5)."""
        self.assertAlmostEqual(cost_model.by_the_paper(8, 20, 20), 1 / 8**1.5)
        self.assertAlmostEqual(cost_model.by_the_paper(1, 20), 1 / 20)
        self.assertAlmostEqual(cost_model.by_the_paper(8, 20), 1 / (20 * 8**1.5))

    def test_exponents(self):
        factor = numpy.array([1, 2, 8, 27.0])
        power, error = cost_model.exponent(factor, 700 * factor**-1.5)
        self.assertAlmostEqual(power, -1.5)
        self.assertAlmostEqual(error, 0)
        # by hand: log-costs (0, 0, 1) at logs (0, 1, 2): slope 1/2, residuals of variance 1/6, over a sum of squares of 2
        power, error = cost_model.exponent(numpy.exp([0, 1, 2]), numpy.exp([0, 0, 1]))
        self.assertAlmostEqual(power, 0.5)
        self.assertAlmostEqual(error, math.sqrt(1 / 6 / 2))
        # logs (-1, 0, 1) about their mean: the middle cost's error does not matter, those of the others 0.3 and 0.4 over a sum of squares of 2
        power, error = cost_model.exponent(numpy.exp([0, 1, 2]), numpy.exp([0, 0.5, 1]), [0.3, 9, 0.4])
        self.assertAlmostEqual(power, 0.5)
        self.assertAlmostEqual(error, 0.5 / 2)


class Study(InFolder):
    def test_the_table_tells_its_exponents(self):
        """Every variant costs 2 s per sphere and second at the case's steps, W^-1.5, S^0.8, and as many times its N."""
        def spent(point):
            own = point.steps / (20 if point.method in ("DEM", "CGPM") else 1) if point.steps else 1
            return {"solids": 2 * cost_study.COUNT * point.depth * point.weight**-1.5 * own**0.8, "gas": 9, "mapping": 4, "exchange": 2}

        def steps(point):
            return 1000.0 * (point.steps or 1)

        path = os.path.join(self.root, "cost-model.csv")
        cost_study.write(path, {point: [(spent(point), steps(point))] * 3 for point in cost_study.POINTS})
        lines = "\n".join(cost_study.report(path))
        for words in (r"W, DEM and CGPM +-1.50 \+- 0.00 +-1.5 +1, 2, 8, 27", r"W, MPPIC +-1.50", r"S, CGPM +0.80 \+- 0.00 +1 +10000, 20000, 40000", r"S, CGHS +0.80", r"N, CGHS +1.00"):
            self.assertRegex(lines, words)

    def test_no_table(self):
        with self.assertRaisesRegex(InputError, "no table of tools/bench cost-model"):
            cost_study.read(os.path.join(self.root, "nowhere.csv"))


if __name__ == "__main__":
    unittest.main()
