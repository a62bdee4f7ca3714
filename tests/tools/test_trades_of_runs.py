# SPDX-License-Identifier: GPL-3.0-or-later
"""Evidence made of measured runs: shares of the reference with errors, what is not trusted left out, and read again as it was written."""

import dataclasses
import math
import os
import unittest

import numpy

from interphase import evidence, trades_of_runs
from interphase.evidence import Trade
from interphase.run_report import FREQUENCY, Quantity, RunReport
from scratch import InFolder
from test_trade import mean


def report(**values):
    return RunReport(0, 0.0, 1.0, series=[Quantity(name.replace("_", " "), "", value) for name, value in values.items()])


class Deviations(unittest.TestCase):
    def of(self, ours, theirs):
        return trades_of_runs._deviations(theirs, ours, "full_depth")

    def test_shares_of_the_reference(self):
        found = self.of(report(pressure_drop=mean(110, 1)), report(pressure_drop=mean(100, 2)))
        self.assertEqual(list(found), ["pressure_drop"])
        self.assertAlmostEqual(found["pressure_drop"][0], 0.1)
        self.assertAlmostEqual(found["pressure_drop"][1], math.hypot(0.01, 1.1 * 0.02))

    def test_no_evidence_of_what_is_not_known(self):
        for ours in (mean(110, 1, "too short"), mean(110, math.nan)):
            self.assertEqual(self.of(report(pressure_drop=ours), report(pressure_drop=mean(100, 1))), {})
        both = RunReport(0, 0.0, 1.0, series=[Quantity(FREQUENCY, "Hz", mean(2, 0.1))])
        self.assertEqual(self.of(both, both), {})

    def test_the_amplitude_of_a_profile(self):
        """0.8 times the reference, errors by the scatter of 20,000 draws (good to half a per cent; first order is good to 1 % here)."""
        true, error = numpy.array([-0.2, 0.1, 0.35, 0.1, -0.2]), 0.02
        found = trades_of_runs._amplitude([mean(0.8 * x, error) for x in true], [mean(x, error) for x in true])
        self.assertAlmostEqual(found[0], -0.2)
        random = numpy.random.default_rng(1)
        a, b = 0.8 * true + error * random.standard_normal((20000, 5)), true + error * random.standard_normal((20000, 5))
        self.assertAlmostEqual(found[1] / ((a * b).sum(axis=1) / (b * b).sum(axis=1)).std(), 1, delta=0.03)


class Table(InFolder):
    def test_it_is_read_as_it_was_written(self):
        path = os.path.join(self.root, "trades.csv")
        first = Trade("bed", "CGHS", 8.0, 1.0, "pressure_drop", 0.1, 0.02, "DEM", 0.4, 0.08, 2.0, 1.4e6, "tools/run cases/sscp1, with a comma")
        trades = [first, dataclasses.replace(first, method="MPPIC", steps_per_collision=None)]
        trades_of_runs.write(path, trades)
        self.assertEqual(evidence.read(path), trades)


if __name__ == "__main__":
    unittest.main()
