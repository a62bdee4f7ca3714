# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/report --pool: runs that differ in where they begin only, as one record in pieces."""

import os
import shutil
import unittest

import numpy
from scipy.stats import t as student

from interphase import report_output, trade
from test_report import Folder


class Pooled(Folder):
    def numbers(self, *given):
        """{name: Mean} of the first sheet that --store writes."""
        self.report(*given, "--no-write", "--from", "1", "--store", os.path.join(self.root, "stored"))
        sheets = report_output.stored([os.path.join(self.root, "stored")])
        return sheets, {f"{name}, {at}": mean for name, (_, means) in trade.quantities(sheets[0].report, "full_depth").items() for at, mean in enumerate(means)}

    def test_are_one_record(self):
        runs = [self.run_of(f"bed_from-{seed}", 100, seed) for seed in (1, 2, 3)]
        (sheet,), together = self.numbers(*runs, "--pool")
        self.assertEqual((sheet.name, sheet.report.pieces, sheet.report.snapshots, sheet.report.rows[0]), ("bed", 3, 240, 240))
        self.assertEqual((sheet.start, sheet.end), (1, 4.95))
        self.assertIsNone(sheet.report.spectrum)
        for run in runs:
            self.assertIn(os.path.basename(run), sheet.account.folder)
        shutil.rmtree(os.path.join(self.root, "stored"))
        alone = []
        for run in runs:
            alone.append(self.numbers(run)[1])
            shutil.rmtree(os.path.join(self.root, "stored"))
        for name in ("pressure drop, 0", "bed height, 0", "kinetic energy, 0", "voidage, 0", "granular temperature, 1"):
            numpy.testing.assert_allclose(together[name].value, numpy.mean([each[name].value for each in alone]), 1e-6, err_msg=name)  # seven digits are stored
        for name, mean in together.items():  # each knows of the scatter
            scatter = numpy.std([each[name].value for each in alone], ddof=1) / 3**0.5 * student.ppf(0.975, 2)
            self.assertGreaterEqual(mean.error * student.ppf(0.975, mean.freedom), scatter * (1 - 1e-3), name)  # ratios of sums weigh the parts a little otherwise
        # a third of the variance, or so: each error is known to some 8 degrees of freedom
        self.assertLess(together["pressure drop, 0"].error, numpy.mean([each["pressure drop, 0"].error for each in alone]))
        self.assertFalse(together["pressure drop, 0"].reason)

    def test_beside_another_run(self):
        runs = [self.run_of(f"bed-{seed}", 60, seed) for seed in (1, 2)]
        text = self.report(*runs, self.run_of("parcels", 80, 4, weight=8.0), "--pool", "--no-write", "--from", "1")
        self.assertRegex(text, r"A: bed\b")
        self.assertRegex(text, r"B: parcels\b")
        self.assertRegex(text, r"no spectrum of the pressure drop: the record is in pieces")

    def test_nothing_to_pool_is_refused(self):
        runs = self.run_of("one", 60), self.run_of("two", 60, weight=8.0)
        self.assertIn("no two of the runs are alike", self.report(*runs, "--pool", code=2))
        self.assertIn("--pool and --until", self.report(*runs, "--pool", "--until", "2", code=2))


if __name__ == "__main__":
    unittest.main()
