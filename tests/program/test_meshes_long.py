#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
# label: slow
# timeout: 1800
"""As test_meshes.py, on more cells, with more spheres, and on more ranks."""

import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import mesh_zoo  # noqa: E402
import test_meshes  # noqa: E402

REST = set(mesh_zoo.SCENES) - set(test_meshes.SCENES) - {"baffle", "large_sphere", "joined_baffle"}


class MoreMeshes(test_meshes.Meshes):
    def test_every_cell_has_the_packings_solid_fraction(self):
        for name in sorted(REST):
            with self.subTest(name):
                self.assert_even(mesh_zoo.run(name), test_meshes.KINKS)

    def test_ranks_are_alike(self):
        for name in sorted(set(mesh_zoo.SCENES) - {"cells_20d"}):
            alone = mesh_zoo.run(name)
            for ranks in (2, 4):
                with self.subTest(name, ranks=ranks):
                    out = mesh_zoo.run(name, ranks)
                    self.assertLess(abs(out.solids - alone.solids).max(), test_meshes.ROUND_OFF)


if __name__ == "__main__":
    unittest.main()
