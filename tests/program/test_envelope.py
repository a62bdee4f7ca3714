#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 600
# processors: 1
"""Dense suspensions and beds at gas steps below, at and above the relaxation time: none is wrong without a word (tools/envelope --quick),
and the books close."""

import csv
import os
import unittest

import support


class Envelope(support.ProgramTest):
    def test_nothing_fails(self):
        out = os.path.join(self.root, "envelope")
        done = support.tool("envelope", "--quick", "--out", out, timeout=500)
        print(done.stdout)
        with open(os.path.join(out, "map.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertGreater(len(rows), 5)
        self.assertEqual([row for row in rows if row["verdict"] == "failed"], [])
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for row in rows:
            if row["books"]:
                self.assertLess(float(row["books"]), 1e-12, row)
        self.assertTrue(os.path.isfile(os.path.join(out, "map.png")))


if __name__ == "__main__":
    unittest.main()
