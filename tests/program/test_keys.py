#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`interphase -help keys` tells every key of system/couplingDict, in any folder and without a set-up of OpenFOAM; the page in the
tree is what it prints."""

import os
import subprocess
import tempfile
import unittest

import support

PAGE = os.path.join(support.SOURCE, "coupler/settings/KEYS.md")


class Keys(unittest.TestCase):
    def test_the_page_is_what_the_program_prints(self):
        with tempfile.TemporaryDirectory(prefix="interphase-") as folder:
            done = subprocess.run([support.PROGRAM, "-help", "keys"], cwd=folder, env=support.environment(WM_PROJECT_DIR=None),
                                  capture_output=True, text=True, timeout=60)
            self.assertEqual(os.listdir(folder), [])
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        self.maxDiff = None
        self.assertEqual(done.stdout, support.read(PAGE), f"write it anew: interphase -help keys > {PAGE}")


if __name__ == "__main__":
    unittest.main()
