#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts that several programs write: data files of LIGGGHTS come back to the last bit and are read by LIGGGHTS; tables stay in line."""

import os
import shutil
import subprocess
import tempfile
import unittest

import numpy

from interphase import data_file, particle_file, tables

READ = """units si
atom_style granular
atom_modify sort 0 0
boundary f f f
newton off
communicate single vel yes
read_data spheres.data
neighbor 1e-3 bin
pair_style none
fix m1 all property/global youngsModulus peratomtype 5e6 5e6 5e6
fix move all nve/sphere
dump all all custom 1 spheres.dump id type x y z vx vy vz omegax omegay omegaz radius density
dump_modify all format "%d %d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
timestep 1e-9
run 0
"""


class DataFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="interphase-texts-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.path = os.path.join(self.folder, "spheres.data")
        random = numpy.random.default_rng(3)
        self.position, self.velocity, self.spin = random.uniform(0.1, 0.9, (50, 3)), random.normal(size=(50, 3)), random.normal(size=(50, 3))
        self.diameter, self.density = random.uniform(1e-3, 2e-3, 50), random.uniform(1000, 2000, 50)
        self.kind = random.integers(1, 3, 50)
        data_file.write(self.path, "made up \u00e9\nin two lines " + 300 * "x", (0, 0, 0), (1, 1, 1), self.position, self.diameter, self.density, self.kind,
                        self.velocity, self.spin, types=3)  # fmt: skip

    def test_what_is_written_is_read(self):
        found = particle_file.read(self.path)
        self.assertEqual(found.types, 3)
        numpy.testing.assert_array_equal(found.ids, numpy.arange(1, 51))
        numpy.testing.assert_array_equal(found.kind, self.kind)
        numpy.testing.assert_array_equal(found.diameter, self.diameter)
        numpy.testing.assert_array_equal(found.density, self.density)
        numpy.testing.assert_array_equal((found.low, found.high), ((0, 0, 0), (1, 1, 1)))

    @unittest.skipUnless(shutil.which("liggghts"), "needs the liggghts binary")
    def test_liggghts_reads_the_same_doubles(self):
        with open(os.path.join(self.folder, "in.read"), "w", encoding="ascii") as stream:
            stream.write(READ)
        done = subprocess.run(["liggghts", "-in", "in.read"], cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:] + done.stderr)
        rows = numpy.loadtxt(os.path.join(self.folder, "spheres.dump"), skiprows=9)
        rows = rows[numpy.argsort(rows[:, 0])]
        numpy.testing.assert_array_equal(rows[:, 1], self.kind)
        numpy.testing.assert_array_equal(rows[:, 2:11], numpy.hstack([self.position, self.velocity, self.spin]))
        numpy.testing.assert_array_equal(rows[:, 11], self.diameter / 2)
        # LIGGGHTS keeps the mass and gives the density back from it
        numpy.testing.assert_allclose(rows[:, 12], self.density, rtol=1e-15 * 4)

    def test_lists_and_one_value_for_all(self):
        text = data_file.text("two", [0, 0, 0], [1, 1, 1], [(0.25, 0.5, 0.5), (0.75, 0.5, 0.5)], 0.1, 2500)
        self.assertTrue(text.endswith("\n2 atoms\n2 atom types\n\n0.0 1.0 xlo xhi\n0.0 1.0 ylo yhi\n0.0 1.0 zlo zhi\n\nAtoms\n\n"
                                      "1 1 0.1 2500.0 0.25 0.5 0.5\n2 1 0.1 2500.0 0.75 0.5 0.5\n"), text)  # fmt: skip


class Tables(unittest.TestCase):
    def test_columns_are_as_wide_as_what_is_in_them(self):
        self.assertEqual(tables.columns([["a", "b"], ["longer", "1", "x"], ["c"]], right=(1,)), ["a       b", "longer  1  x", "c"])

    def test_markdown(self):
        self.assertEqual(tables.markdown_head(["", "x"]) + "\n" + tables.markdown_row(["a", 1]), "| | x |\n|---|---|\n| a | 1 |")


if __name__ == "__main__":
    unittest.main()
