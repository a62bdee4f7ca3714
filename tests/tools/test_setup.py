# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/setup in a tree that is somebody else's: what is built there is used, or the message says whose it is and what to do."""

import os
import shutil
import subprocess
import tempfile
import unittest

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))


class TreeOfSomebodyElse(unittest.TestCase):
    def setUp(self):
        self.tree = tempfile.mkdtemp(prefix="interphase-setup-")
        self.addCleanup(shutil.rmtree, self.tree)
        os.makedirs(os.path.join(self.tree, "tools"))
        os.makedirs(os.path.join(self.tree, "build/release"))
        shutil.copy(os.path.join(REPOSITORY, "tools/setup"), os.path.join(self.tree, "tools/setup"))
        with open(os.path.join(self.tree, "build/.setup.lock"), "w", encoding="utf-8"):
            pass
        os.chmod(os.path.join(self.tree, "build/.setup.lock"), 0o444)
        for folder in ("build/release", "build", "tools", ""):
            os.chmod(os.path.join(self.tree, folder), 0o555)
        self.addCleanup(self.open)

    def open(self):
        for base, _, _ in os.walk(self.tree):
            os.chmod(base, 0o755)

    def setup(self, *given):
        # root may do all: it takes another's place
        place = {"user": 65534, "group": 65534, "extra_groups": []} if os.geteuid() == 0 else {}
        return subprocess.run([os.path.join(self.tree, "tools/setup"), *given], capture_output=True, text=True, timeout=60, **place)

    def test_nothing_is_built(self):
        done = self.setup()
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, "cannot write into .*/build: this tree is .*git clone.*INTERPHASE_BIN")

    def test_the_program_is_built(self):
        self.open()
        program = os.path.join(self.tree, "build/release/interphase")
        with open(program, "w", encoding="utf-8"):
            pass
        os.chmod(program, 0o755)
        os.chmod(os.path.join(self.tree, "build"), 0o555)
        os.chmod(os.path.join(self.tree, "build/release"), 0o555)
        done = self.setup()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("is used as it is", done.stdout)
        self.assertEqual(self.setup("--with-tests").returncode, 1)
