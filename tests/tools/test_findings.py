# SPDX-License-Identifier: GPL-3.0-or-later
"""What the paper found is asked of runs however they were measured: of snapshots, or of the rows that they took themselves."""

import types
import unittest

from interphase import findings, trade
from interphase.run_report import Quantity, RunReport
from interphase.time_statistics import Mean

CLAIM = "MP-PIC has more cells of a voidage below 0.40"


def sheet(method, share, what, limit=0.4):
    """Of a run with this share of cells below the limit, known to 0.001."""
    mean = Mean(share, 0.001, 0.01, 400, 100.0, 50.0, 2.0)
    report = RunReport(400, 0.0, 20.0, of_rows=what.startswith("mapped"), voidages=[Quantity(f"{what} below {limit:g}", "% of cells", mean, 100)])
    account = types.SimpleNamespace(method=method, weight=1.0 if method == "DEM" else 8.0, cost=None)
    return types.SimpleNamespace(name=method, report=report, account=account)


def verdicts(*sheets):
    return [each.verdict for each in findings.of(sheets, "full_depth") if each.claim == CLAIM]


class Voidage(unittest.TestCase):
    def test_of_snapshots_and_of_rows(self):
        for what in ("voidage", "mapped voidage"):
            self.assertEqual(verdicts(sheet("DEM", 0.002, what), sheet("MPPIC", 0.024, what)), [findings.FOUND])
            self.assertEqual(verdicts(sheet("DEM", 0.024, what), sheet("MPPIC", 0.002, what)), [findings.NOT_FOUND])
            self.assertEqual(verdicts(sheet("DEM", 0.002, what), sheet("MPPIC", 0.003, what)), [findings.UNDECIDED])

    def test_one_of_snapshots_and_one_of_rows_are_not_compared(self):
        sheets = sheet("DEM", 0.002, "voidage"), sheet("MPPIC", 0.024, "mapped voidage")
        self.assertEqual(verdicts(*sheets), [findings.UNDECIDED])
        self.assertIn("measure both alike", next(each.reason for each in findings.of(sheets, "full_depth") if each.claim == CLAIM))
        self.assertEqual(trade.distances(sheets[0].report, sheets[1].report, "full_depth"), [])

    def test_another_limit_says_nothing_of_it(self):
        self.assertEqual(verdicts(sheet("DEM", 0.2, "mapped voidage", 0.5), sheet("MPPIC", 0.3, "mapped voidage", 0.5)), [])
