# SPDX-License-Identifier: GPL-3.0-or-later
"""`interphase -help keys` tells every key of system/couplingDict, `-help counts` everything that runs count, `-help methods` the methods, in any folder
and without a set-up of OpenFOAM; the pages in the tree are what it prints."""

import os
import subprocess
import tempfile
import unittest

import support

PAGES = {"keys": os.path.join(support.SOURCE, "coupler/settings/KEYS.md"), "counts": os.path.join(support.SOURCE, "tools/COUNTS.md"),
         "methods": os.path.join(support.SOURCE, "coupler/settings/METHODS.md")}


class Pages(unittest.TestCase):
    def test_the_pages_are_what_the_program_prints(self):
        for about, page in PAGES.items():
            with self.subTest(about), tempfile.TemporaryDirectory(prefix="interphase-") as folder:
                done = subprocess.run([support.PROGRAM, "-help", about], cwd=folder, env=support.environment(WM_PROJECT_DIR=None),
                                      capture_output=True, text=True, timeout=60)
                self.assertEqual(os.listdir(folder), [])
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.maxDiff = None
                self.assertEqual(done.stdout, support.read(page), f"write it anew: interphase -help {about} > {page}")
