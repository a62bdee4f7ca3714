# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 300
"""tools/run --until-error on a real run: it ends once the mean is that certain, goes on to a smaller error, and says so in run.json."""

import json
import os
import re
import signal
import subprocess
import time

import support
from interphase.tree import CASES, TOOLS

END = 5  # [s], simulated; the gas has passed the column long before


class UntilError(support.ProgramTest):
    def tool(self, *words):
        return subprocess.run([os.path.join(TOOLS, "run"), os.path.join(CASES, "packed-bed"), "--no-picture", "--out", self.folder, *words],
                              capture_output=True, text=True, env=support.environment(), timeout=support.LONGEST)  # fmt: skip

    def setUp(self):
        super().setUp()
        self.folder = os.path.join(self.root, "until")

    def state(self):
        with open(os.path.join(self.folder, "run.json"), encoding="utf-8") as file:
            return json.load(file)

    def reached(self):
        return float(support.Finished(self.folder).column("series/time")[-1])

    def test_it_ends_early_goes_on_and_ends_at_its_end(self):
        done = self.tool("--until", str(END), "--until-error", "pressure_drop 1%")
        self.assertEqual(done.returncode, 0, done.stderr)
        early = self.reached()
        self.assertLess(early, END / 2)
        self.assertRegex(done.stdout, r"\nreached: pressure_drop 1%: \d+\.?\d* \+- ")
        self.assertRegex(self.state()["until_error"][0], "^reached: pressure_drop 1%")

        # An error that no run reaches, over a short while: it goes to its end, whatever was reached before.
        done = self.tool("--resume", "--until", f"{early + 0.2:.3f}", "--until-error", "pressure_drop 1e-12 Pa")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertAlmostEqual(self.reached(), early + 0.2, delta=0.011)  # rows are 0.01 s apart
        self.assertRegex(done.stdout, r"\nnot reached: pressure_drop 1e-12 Pa: ")
        self.assertRegex(self.state()["until_error"][0], "^not reached: ")

    def test_a_series_that_the_run_does_not_have_stops_it_and_loses_nothing(self):
        done = self.tool("--until", str(END), "--until-error", "presure_drop 1%")
        self.assertEqual(done.returncode, 2)
        self.assertIn("pressure_drop", done.stderr)
        self.assertIn("--resume", done.stderr)
        self.assertLess(self.reached(), END)

    def test_ctrl_c_is_the_user_s(self):
        program = subprocess.Popen([os.path.join(TOOLS, "run"), os.path.join(CASES, "packed-bed"), "--no-picture", "--out", self.folder,
                                    "--until", str(1000 * END), "--until-error", "pressure_drop 1e-12 Pa"],  # it cannot end before the signal
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=support.environment(), start_new_session=True)  # fmt: skip
        log = os.path.join(self.folder, "log.interphase")
        for _ in range(3000):
            if os.path.exists(log) and re.search(r"^t = (?!0 )", support.read(log), re.M):
                break
            self.assertIsNone(program.poll())
            time.sleep(0.02)
        program.send_signal(signal.SIGINT)
        _, err = program.communicate(timeout=60)
        self.assertEqual(program.returncode, 130)
        self.assertIn("stopped by SIGINT before its end", err)
        self.assertRegex(self.state()["until_error"][0], "^not reached: ")


if __name__ == "__main__":
    support.unittest.main()
