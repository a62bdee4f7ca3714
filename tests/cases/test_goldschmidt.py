# SPDX-License-Identifier: GPL-3.0-or-later
"""cases/goldschmidt starts from the tutorials' particles, and `compare` measures every program's records alike."""

import gzip
import math
import os
import re
import runpy
import unittest

import numpy

import support

CASE = os.path.join(support.SOURCE, "cases", "goldschmidt")
COMPARE = runpy.run_path(os.path.join(CASE, "compare.py"))
POSITIONS = "/usr/share/doc/openfoam-examples/examples/lagrangian/MPPICFoam/Goldschmidt/constant/kinematicCloudPositions.gz"


def centres(folder):
    """Of dem/bed.data: (diameter [n], centres [n, 3])."""
    body = support.read(folder, "dem", "bed.data").split("Atoms\n\n")[1]
    rows = numpy.array([line.split() for line in body.splitlines() if line], dtype=float)
    return rows[:, 2], rows[:, 4:7]


class Start(support.ProgramTest):
    @unittest.skipUnless(os.path.isfile(POSITIONS), "needs the Debian package openfoam-examples")
    def test_particles_stand_where_the_tutorials_put_them(self):
        with gzip.open(POSITIONS, "rt", encoding="ascii") as file:
            rows = re.findall(r"^\((\S+) (\S+) (\S+)\)$", file.read(), re.M)
        # the tutorials' x is our depth y, their y our width x
        x, y, z = numpy.array(rows, dtype=float).T
        expected = numpy.column_stack([y + 0.075, x + 0.0075, z]).round(6)
        _, found = centres(self.prepared("goldschmidt"))
        numpy.testing.assert_array_equal(
            found.round(6)[numpy.lexsort(found.round(6).T)], expected[numpy.lexsort(expected.T)])

    def test_parcels_have_the_volume_of_the_particles_and_fill_their_box(self):
        diameter, found = centres(self.prepared("goldschmidt", method="CGHS", weight=8))
        # 24,750 is no multiple of 8
        self.assertAlmostEqual((diameter**3).sum() / (24750 * 2.5e-3**3), 1, delta=1e-3)
        self.assertLess(found[:, 2].max(), 0.297)
        self.assertAlmostEqual(found[:, 2].mean(), 0.1485, delta=0.003)  # within a third of a layer of parcels

    def test_what_cannot_be_prepared_is_refused(self):
        for key, value, words in (("reach", 1.5, "'reach' in parameters must be between 0 and 1.*, is 1.5"),
                                  ("particleCount", 50000, "0.6 m high, the vessel is 0.45 m"),
                                  ("initialSpacing", 2.4e-3, "overlap")):
            with self.subTest(key=key), self.assertRaisesRegex(AssertionError, words):
                self.prepared("goldschmidt", name=key, **{key: value})


class Measures(support.ProgramTest):
    def fields(self, layers, across):
        """A file `p` that falls from 400 at the bottom by 1000 per m, as OpenFOAM writes it."""
        z = (numpy.arange(layers) + 0.5) * 0.45 / layers
        values = numpy.repeat(400 - 1000 * z, across)
        path = os.path.join(self.root, f"p{layers}")
        body = "\n".join(repr(float(v)) for v in values)
        support.write(path, f"dimensions [0 2 -2 0 0 0 0];\ninternalField   nonuniform List<scalar>\n{len(values)}\n(\n{body}\n)\n;\n")
        return path

    def test_pressure_drop_is_the_same_on_both_meshes(self):
        for layers, across in ((45, 15), (90, 60)):
            drop = COMPARE["pressure_drop"](self.fields(layers, across), layers, 0.45)
            self.assertTrue(math.isclose(drop, 395, rel_tol=1e-12), drop)

    def test_a_tutorial_that_differs_is_refused(self):
        support.write(os.path.join(self.root, "system/controlDict"), "endTime 7;\n")
        with self.assertRaises(SystemExit) as refused:
            COMPARE["changed"](self.root, "system/controlDict", "endTime         5;", "endTime 1;")
        self.assertRegex(str(refused.exception), r"'endTime         5;' does not stand in .*controlDict")
