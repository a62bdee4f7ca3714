# SPDX-License-Identifier: GPL-3.0-or-later
"""cases/sscp1/study/replicates/pairs: differences of pairs by the pairs' scatter alone, what they share left out."""

import dataclasses
import os
import re
import subprocess
import tempfile
import unittest

from interphase import run_sheet
from interphase.tree import CASES

HERE = os.path.join(CASES, "sscp1", "study", "replicates")
PERCENT = re.compile(r"kinetic energy +\S+ +\S+ \+- \S+ +\(([+-][\d.]+) \+- ([\d.]+) %\)(  told apart)?")


class Pairs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name

    def said(self, folder):
        return subprocess.run([os.path.join(HERE, "pairs"), folder], capture_output=True, text=True)

    def with_energies(self, *pairs):
        """A folder of pairs with these kinetic energies (TDHS, DEM) [J]."""
        sheet = run_sheet.read(os.path.join(HERE, "TDHS_at-4.sheet.json"))
        for bed, both in enumerate(pairs):
            for name, energy in zip((f"TDHS_at-{bed}", f"DEM_from-{bed}"), both):
                series = [dataclasses.replace(each, mean=dataclasses.replace(each.mean, value=energy)) if each.name == "kinetic energy" else each for each in sheet.report.series]
                run_sheet.store(self.root, [dataclasses.replace(sheet, name=name, report=dataclasses.replace(sheet.report, series=series))])
        return self.root

    def test_what_pairs_share_is_in_no_error(self):
        """Beds three times as lively as others, each pair apart by 0.02 of 0.2 J on average: 0.019, 0.020 and 0.021 scatter by 0.001/sqrt(3)."""
        match = PERCENT.search(self.said(self.with_energies((0.1, 0.119), (0.2, 0.22), (0.3, 0.321))).stdout)
        self.assertEqual(match.groups(), ("+10.0", "0.3", "  told apart"))

    def test_pairs_that_differ_otherwise_each_are_not_told_apart(self):
        match = PERCENT.search(self.said(self.with_energies((0.2, 0.21), (0.2, 0.19), (0.2, 0.23))).stdout)
        self.assertEqual(match.groups(), ("+5.0", "5.8", None))  # +5, -5, +15 %: 10/sqrt(3)

    def test_one_pair_is_refused(self):
        done = self.said(self.with_energies((0.2, 0.21)))
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"pairs: error: {self.root}: 1 pairs of DEM_from-K.sheet.json and TDHS_at-K.sheet.json, two are needed at least", done.stderr)

    def test_what_is_stored_tells_overlaps_only_and_a_class_of_voidage_apart(self):
        """As cases/sscp1/README.md says."""
        apart = {line[:34].strip() for line in self.said(HERE).stdout.splitlines() if line.endswith("told apart")}
        self.assertEqual(apart, {"mapped voidage, 3 of 5", "overlaps, 1 of 3", "overlaps, 2 of 3"})


if __name__ == "__main__":
    unittest.main()
