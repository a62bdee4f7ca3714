# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 600
# processors: 1
"""Dense suspensions and beds at gas steps below, at and above the relaxation time: none is wrong without a word (tools/envelope --quick),
and the books close."""

import csv
import os

import measured
import support


class Envelope(support.ProgramTest):
    def test_nothing_fails(self):
        out = os.path.join(self.root, "envelope")
        done = support.tool("envelope", "--quick", "--out", out, timeout=500)
        print(done.stdout)
        with open(os.path.join(out, "map.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertGreater(len(rows), 5)
        failed = [row for row in rows if row["verdict"] == "failed"]
        measured.within(self, f"dense suspensions and beds, {len(rows)} runs at gas steps about the relaxation time: wrong without a word", len(failed), 0, 0, "",
                        "hindered velocity, equilibrium, bed's weight")  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        measured.below(self, "the same: largest imbalance of momentum or volume", max(float(row["books"]) for row in rows if row["books"]), 1e-12, "",
                       "conservation")
        self.assertTrue(os.path.isfile(os.path.join(out, "map.png")))
