# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 600
"""tools/study with the program itself: beds are developed, the runs start from them, the page is there, and the same command does nothing twice."""

import json
import os

import support

STUDY = """case "cases/periodic-duct"; until 0.012; from 0.002;
developed { time 0.006; }
rows { TDHS { methods (TDHS); } parcels { methods (CGHS MPPIC); weights (2); } }
"""


class Study(support.ProgramTest):
    def study(self, *given, code=0):
        path = os.path.join(self.root, "study")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(STUDY)
        done = support.tool("study", path, "--out", os.path.join(self.root, "runs"), *given)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout

    def test_runs_start_from_one_bed_and_are_made_once(self):
        kept = os.path.join(self.root, "kept")
        said = self.study("--store", kept)
        self.assertIn("2 to make", said)
        self.assertIn("3 to make", said)
        for name, bed in (("TDHS", "developed-w1"), ("parcels_CGHS-w2", "developed-w2"), ("parcels_MPPIC-w2", "developed-w2")):
            with open(os.path.join(self.root, "runs", name, "run.json"), encoding="utf-8") as stream:
                record = json.load(stream)
            self.assertEqual((os.path.basename(record["from"]["run"]), record["from"]["time"]), (bed, 0.006))
            self.assertGreater(record["cpu_time"], 0)
        with open(os.path.join(self.root, "runs", "report.html"), encoding="utf-8") as stream:
            page = stream.read()
        self.assertIn("CPU time", page)
        self.assertEqual(len(os.listdir(kept)), 3)
        again = self.study("--html", os.path.join(self.root, "again.html"))
        self.assertIn("2 there", again)
        self.assertIn("3 there", again)
        self.study("--from-stored", kept, "--html", os.path.join(self.root, "stored.html"))
