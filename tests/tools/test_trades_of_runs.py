# SPDX-License-Identifier: GPL-3.0-or-later
"""Evidence made of measured runs: shares of the reference with errors, what is not trusted left out, and read again as it was written."""

import contextlib
import dataclasses
import io
import math
import os
import unittest

import numpy

from interphase import evidence, run_sheet, trades_of_runs
from interphase.commands import report as tools_report
from interphase.evidence import Trade
from interphase.input_error import InputError
from interphase.run_report import FREQUENCY, Quantity, RunReport
from interphase.tree import CASES
from scratch import InFolder
from test_trade import mean

SSCP1 = os.path.join(CASES, "sscp1", "study")
SLICE = os.path.join(CASES, "sscp1-slice", "study")
STUDY = os.path.join(SSCP1, "2.19")
# What the tables in the tree are made of, by their folders.
SOURCES = {folder: [folder] for folder in (*(os.path.join(SSCP1, velocity) for velocity in ("2.19", "3.28", "4.38")), SLICE, os.path.join(CASES, "van-wachem", "study", "methods"))}
SOURCES.update({os.path.join(SLICE, name): [os.path.join(SLICE, "slice-DEM.sheet.json"), os.path.join(SLICE, name)] for name in ("weights", "steps")})


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

    def test_those_of_the_tree_are_what_the_stored_runs_say(self):
        self.assertEqual({os.path.dirname(path) for path in evidence.tables() if path != evidence.COMMON}, set(SOURCES))
        for folder, stored in SOURCES.items():
            with self.subTest(os.path.relpath(folder, CASES)), contextlib.redirect_stdout(io.StringIO()):
                path = os.path.join(self.root, "again.csv")
                self.assertEqual(tools_report.main([*stored, "--trades", path]), 0)
                with open(path) as again, open(os.path.join(folder, "trades.csv")) as kept:
                    self.assertEqual(again.read(), kept.read())


class Likeness(unittest.TestCase):
    def setUp(self):
        self.sheets = [run_sheet.read(path) for path in run_sheet.stored_in(STUDY)[:2]]

    def test_a_sheet_without_it_is_refused(self):
        first, second = self.sheets
        with self.assertRaisesRegex(InputError, rf"--trades: {second.name} was stored by a version .*; store it again: tools/report RUN --store DIR"):
            trades_of_runs.trades_of([first, dataclasses.replace(second, likeness={})], "full_depth")

    def test_a_scene_without_gas_is_no_evidence(self):
        first, second = self.sheets
        for name in evidence.NEAR:
            without = dataclasses.replace(second, likeness={**second.likeness, name: None})
            self.assertEqual(trades_of_runs.trades_of([first, without], "full_depth"), [])
        self.assertTrue(trades_of_runs.trades_of([first, second], "full_depth"))


if __name__ == "__main__":
    unittest.main()
