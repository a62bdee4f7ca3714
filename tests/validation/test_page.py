#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""tests/VALIDATION.md is what its stored tables give, their values lie within the limits that tests assert, and what is recorded gets there. (tests/tools/test_pages.py tries its commands.)"""

import csv
import math
import os
import tempfile
import unittest
from unittest import mock

import measured
import page


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = {name: page.read(name) for name in page.names()}

    def test_is_what_the_stored_tables_give(self):
        with open(page.PAGE, encoding="utf-8") as file:
            self.assertEqual(file.read(), page.text(), "python/tool tests/validation/page.py --write")

    def test_shows_every_table_once(self):
        stored = sorted(file for file in os.listdir(page.HERE) if file.endswith(".csv"))
        self.assertEqual(sorted(os.path.basename(page.path(name)) for name in page.names()), stored)

    def test_values_lie_within_the_limits(self):
        for name, (head, rows) in self.rows.items():
            self.assertEqual(len(head), 3, f"{name}: date, program, machine")
            self.assertRegex(head[0], r"^20\d\d-\d\d-\d\d$")
            self.assertTrue(rows, name)
            for row in rows:
                with self.subTest(name, quantity=row["quantity"]):
                    self.assertEqual(tuple(row), page.COLUMNS)
                    self.assertTrue(math.isfinite(float(row["value"])))
                    self.assertTrue(page.within(row), row)
                    self.assertTrue(row["limit"] or name.startswith("earlier."), "a test has a limit")


class Store(unittest.TestCase):
    def test_keeps_what_the_page_names_and_shows_it(self):
        with tempfile.TemporaryDirectory() as kept, tempfile.TemporaryDirectory() as folder, mock.patch.multiple(
            page, HERE=kept, PAGE=os.path.join(kept, "VALIDATION.md")
        ):
            for path, text in ((os.path.join(kept, "page.md"), "# Title\n\n{{ some/test_what step/other_mpi_test.np2 }}\n"),
                               (os.path.join(folder, "some.test_what.csv"), "drop,0.1,0.01,Pa,0.3,Ergun,+-0.25\n"),
                               (os.path.join(folder, "step.other_mpi_test.np2.csv"), '"order, |x|",0.95,,,,,>0.9\n'),
                               (os.path.join(folder, "unnamed.csv"), "a,1,,,,,<2\n")):  # fmt: skip
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
            page.store(folder)
            self.assertEqual(sorted(os.listdir(kept)), ["VALIDATION.md", "page.md", "some.test_what.csv", "step.other_mpi_test.np2.csv"])
            with open(page.PAGE, encoding="utf-8") as file:
                lines = file.read().splitlines()
        self.assertEqual(lines[0], "# Title")
        self.assertEqual(lines[4:6], ["| drop | 0.1 +- 0.01 Pa | 0.3 Pa | +- 0.25 Pa | Ergun | `tools/test --filter test_what` |",
                                      "| order, \\|x\\| | 0.95 | | > 0.9 | | `tools/test --filter other` |"])  # fmt: skip
        self.assertRegex(lines[7], r"^\*20\d\d-\d\d-\d\d; interphase \S+, commit \w+.*; \S+( with \S+)?, \d+ cores\.\*")


class Measured(unittest.TestCase):
    def test_is_recorded_with_the_limit_it_is_asserted_by(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.dict(os.environ, INTERPHASE_MEASURED=folder, INTERPHASE_TEST="some/test_what"):
            measured.within(self, 'drop, "hot"', 0.1, 0.3, 0.25, "Pa", "Ergun", error=0.01)
            measured.below(self, "error", 1e-300, 2)
            for outside in (lambda: measured.above(self, "order", 0.5, 0.9), lambda: measured.within(self, "speed", math.nan, 1, 0.5)):
                with self.assertRaises(AssertionError):
                    outside()
            with open(os.path.join(folder, "some.test_what.csv"), encoding="utf-8", newline="") as file:
                rows = list(csv.reader(file))
        self.assertEqual(rows[:3], [['drop, "hot"', "0.1", "0.01", "Pa", "0.3", "Ergun", "+-0.25"], ["error", "1e-300", "", "", "", "", "<2.0"],
                                    ["order", "0.5", "", "", "", "", ">0.9"]])  # fmt: skip
        kept = [page.within(dict(zip(measured.COLUMNS, row))) for row in rows]
        self.assertEqual(kept, [True, True, False, False])

    def test_is_not_recorded_unasked(self):
        with mock.patch.dict(os.environ):
            os.environ.pop("INTERPHASE_MEASURED", None)
            measured.below(self, "error", 1, 2)


if __name__ == "__main__":
    unittest.main()
