# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/paraview: the script that it leaves in a run, and what it refuses; tests/program/test_paraview.py lets ParaView run it."""

import ast
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

from interphase.stl import write_stl

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))


class Script(unittest.TestCase):
    def setUp(self):
        self.run_folder = tempfile.mkdtemp(prefix="interphase-paraview-")
        self.addCleanup(shutil.rmtree, self.run_folder)
        with h5py.File(os.path.join(self.run_folder, "particles.h5"), "w") as file:
            group = file.create_group("snapshots/000000")
            group.attrs["time"] = 0.0
            group["id"], group["diameter"] = np.arange(1, 31), np.full(30, 0.01)
            group["position"], group["velocity"] = np.random.default_rng(1).uniform(0, 0.1, (30, 3)), np.full((30, 3), 0.4)
        self.write("particles.xdmf", "")

    def write(self, name, text):
        os.makedirs(os.path.dirname(os.path.join(self.run_folder, name)), exist_ok=True)
        with open(os.path.join(self.run_folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def call(self, *given, code=0):
        done = subprocess.run([os.path.join(REPOSITORY, "tools/paraview"), self.run_folder, *given], capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done

    def known(self):
        """The dict of numbers at its head."""
        with open(os.path.join(self.run_folder, "show-in-paraview.py"), encoding="utf-8") as file:
            tree = ast.parse(file.read())
        (value,) = [each.value for each in tree.body if isinstance(each, ast.Assign) and getattr(each.targets[0], "id", None) == "RUN"]
        return ast.literal_eval(value)

    def test_it_knows_spheres_surfaces_and_that_there_is_no_gas(self):
        self.write("dem/log.liggghts", "fix blade all mesh/surface file dem/blade.stl type 2 move 0 0 0.5\n"
                   "fix turn all move/mesh mesh blade rotate origin 0 0 0 axis 0 0 1 period 1\n")  # fmt: skip
        write_stl(os.path.join(self.run_folder, "dem/blade.stl"), {"blade": [[(0, 0, 0), (0.1, 0, 0), (0.1, 0, 0.1)]]})
        done = self.call()
        self.assertIn("blade moves: ParaView shows it where it starts", done.stderr)
        self.assertIn("paraview --script=", done.stdout)
        known = self.known()
        self.assertEqual((known["surfaces"], known["gas"]), ([("dem/blade.stl", 1.0, [0.0, 0.0, 0.5])], None))
        self.assertEqual(known["range"], [-0.5, 0.5])
        self.call("--range=-3,4")
        self.assertEqual(self.known()["range"], [-3.0, 4.0])

    def test_what_it_cannot_do(self):
        self.assertRegex(self.call("--screenshot", "a.jpg", code=1).stderr, "a.jpg: the name of a picture ends in .png")
        os.remove(os.path.join(self.run_folder, "particles.xdmf"))
        self.assertRegex(self.call(code=1).stderr, "holds no particles.xdmf")


if __name__ == "__main__":
    sys.exit(unittest.main())
