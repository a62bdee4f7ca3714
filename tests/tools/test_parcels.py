#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The start of MP-PIC's parcels: no planes, even solids, clear of the walls, the same for the same seed; that of other methods is
the lattice that it was."""

import contextlib
import io
import os
import tempfile
import unittest

import numpy

from interphase import preparation

WIDTH, DEPTH, TOP, HEIGHT = 0.12, 0.06, 0.15, 0.4
DIAMETER, COUNT = 6e-3, 3800  # a solid fraction of 0.4
BOX, REGION = (0, WIDTH, 0, DEPTH, 0, HEIGHT), (0, WIDTH, 0, DEPTH, 0, TOP)


def order(places):
    """How far places [n] along a line stand in planes: the largest of |sum exp(ikx)| / n over wave lengths of 0.4 to 3 diameters. 1: in planes;
    1 / sqrt(n), some hundredths: anywhere."""
    waves = numpy.linspace(2 * numpy.pi / (3 * DIAMETER), 2 * numpy.pi / (0.4 * DIAMETER), 300)
    return abs(numpy.exp(1j * numpy.outer(waves, places)).mean(axis=1)).max()


class Parcels(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="interphase-")
        self.addCleanup(folder.cleanup)
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(folder.name)
        os.mkdir("dem")

    def written(self, write):
        with contextlib.redirect_stdout(io.StringIO()):
            write()
        with open("dem/bed.data", encoding="ascii") as stream:
            text = stream.read()
        rows = text.partition("\nAtoms")[2].split("\n", 1)[1].strip().splitlines()
        return text, numpy.array([[float(word) for word in row.split()[4:7]] for row in rows])

    def parcels(self, seed=1):
        return self.written(lambda: preparation.write_parcels(COUNT, DIAMETER, 1000.0, BOX, REGION, seed))

    def test_no_planes_where_a_lattice_has_them(self):
        _, even = self.parcels()
        _, lattice = self.written(lambda: preparation.write_bed(
            "--count", COUNT, "--diameter", DIAMETER, "--density", 1000.0, "--box", *BOX, "--fill", TOP))  # fmt: skip
        self.assertEqual(len(even), COUNT)
        for axis in range(3):
            self.assertGreater(order(lattice[:, axis]), 0.8)
            self.assertLess(order(even[:, axis]), 0.25)  # as the packing keeps its distance from walls ten diameters apart

    def test_solids_are_even(self):
        """Of spheres anywhere, cells of 15 mm, 12.7 spheres, would have 28 % more or less."""
        _, places = self.parcels()
        cells, _ = numpy.histogramdd(places, bins=[numpy.arange(0, end + 1e-9, 0.015) for end in (WIDTH, DEPTH, TOP)])
        self.assertEqual(cells.sum(), COUNT)
        self.assertLess(cells.std() / cells.mean(), 0.2)
        self.assertAlmostEqual(places[:, 2].mean(), TOP / 2, delta=0.01 * TOP)

    def test_clear_of_the_walls(self):
        _, places = self.parcels()
        for axis, end in enumerate((WIDTH, DEPTH, TOP)):
            self.assertGreaterEqual(places[:, axis].min(), DIAMETER / 2 * (1 - 1e-9))
            self.assertLessEqual(places[:, axis].max(), end - DIAMETER / 2 * (1 - 1e-9))

    def test_the_seed_is_all_that_changes_it(self):
        first, _ = self.parcels()
        self.assertEqual(self.parcels()[0], first)
        self.assertNotEqual(self.parcels(seed=2)[0], first)

    def test_a_box_that_is_too_low(self):
        with self.assertRaisesRegex(SystemExit, "not within the box"):
            preparation.write_parcels(COUNT, DIAMETER, 1000.0, BOX, (0, WIDTH, 0, DEPTH, 0, 2 * HEIGHT), 1)


if __name__ == "__main__":
    unittest.main()
