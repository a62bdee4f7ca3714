# SPDX-License-Identifier: GPL-3.0-or-later
"""cases/van-wachem holds the 39 g that were measured, and `compare` measures records as its words say."""

import os
import re
import runpy
import unittest

import numpy

import support

CASE = os.path.join(support.SOURCE, "cases", "van-wachem")
COMPARE = runpy.run_path(os.path.join(CASE, "compare.py"))


class Start(support.ProgramTest):
    def spheres(self, folder):
        """(volume of all [m3], z of the highest centre [m], y of the nearest centre to front and back [m]) of dem/bed.data."""
        body = support.read(folder, "dem", "bed.data").split("Atoms\n\n")[1]
        rows = numpy.array([line.split() for line in body.splitlines() if line], dtype=float)
        y = rows[:, 5]
        return numpy.pi / 6 * (rows[:, 2] ** 3).sum(), rows[:, 6].max(), min(y.min(), 0.008 - y.max())

    def test_every_method_starts_with_the_39_grams(self):
        for method, weight in (("TDHS", 1), ("CGHS", 8), ("CGPM", 4), ("MPPIC", 8)):
            with self.subTest(method=method, weight=weight):
                folder = self.prepared("van-wachem", name=f"{method}-{weight}", method=method, weight=weight)
                volume, top, off = self.spheres(folder)
                # 17,562 spheres of 1.545 mm weigh 38.998 g; parcels leave up to half of one out
                self.assertAlmostEqual(1150 * volume, 0.039, delta=1e-3 * 0.039)
                self.assertLess(top, 0.13)  # 0.118 m at a packing of 0.4
                self.assertGreater(off, 0.49 * 1.545e-3)

    def test_what_cannot_be_prepared_is_refused(self):
        for key, value, words in (("reach", 1.5, "'reach' in parameters must be between 0 and 1.*, is 1.5"),
                                  ("plenum", -0.01, "'plenum' in parameters must be 0 or more, is -0.01")):
            with self.subTest(key=key), self.assertRaisesRegex(AssertionError, words):
                self.prepared("van-wachem", name=key, **{key: value})


class Measures(unittest.TestCase):
    def test_surface_of_a_slanted_bed_is_its_mean_height(self):
        # spheres of one size, evenly up to 0.1 m + 0.5 x: the mean over the columns is the height in the middle
        rng = numpy.random.default_rng(1)
        x = rng.random(200000) * 0.09
        position = numpy.column_stack([x, numpy.zeros_like(x), rng.random(len(x)) * (0.1 + 0.5 * x)])
        seen = COMPARE["surface"](position, numpy.full(len(x), 1.5e-3), 0.09)
        # 1 % of each column lies above; of its slant a few per cent of a column's rise of 2.5 mm
        self.assertAlmostEqual(seen, 0.99 * (0.1 + 0.5 * 0.045), delta=3e-4)

    def test_a_few_spheres_above_the_bed_are_not_its_surface(self):
        z = numpy.append(numpy.linspace(0, 0.1, 1000), [0.4] * 5)
        position = numpy.column_stack([numpy.zeros_like(z), numpy.zeros_like(z), z])
        self.assertAlmostEqual(COMPARE["surface"](position, numpy.ones(len(z)), 0.005), 0.0995, delta=2e-4)

    def test_minimum_fluidization_is_that_of_erguns_equation(self):
        # 150 mu phi U/(eps^3 d^2) + 1.75 rho U^2/(eps^3 d) = (rho_p - rho) g, with the numbers of the case
        phi, eps, d, rho, mu = 0.6, 0.4, 1.545e-3, 1.28, 1.7024e-5
        a, b, c = 1.75 * rho / (eps**3 * d), 150 * mu * phi / (eps**3 * d**2), -(1150 - rho) * 9.81
        exact = (-b + (b * b - 4 * a * c) ** 0.5) / (2 * a)
        self.assertAlmostEqual(COMPARE["minimum_fluidization"](phi, "Ergun"), exact, delta=1e-9)

    def test_the_measurement_is_read_as_it_was_printed(self):
        row = COMPARE["of_measurement"]()
        self.assertAlmostEqual(float(row["deviation"]), 82, delta=1)
        self.assertAlmostEqual(float(row["surface"]), 0.125, delta=5e-4)
        self.assertAlmostEqual(float(row["surface_deviation"]), 0.0144, delta=2e-4)


class Stored(unittest.TestCase):
    def test_every_stored_run_says_how_it_was_made(self):
        flowing, resting = COMPARE["stored"]("runs.csv"), COMPARE["stored"]("packings.csv")
        self.assertTrue(flowing and resting)
        for row in flowing + resting:
            self.assertRegex(row["command"], r"^tools/run cases/van-wachem --method \w+ .*--until ")
            self.assertRegex(row["commit"], r"^[0-9a-f]{12}$")

    def test_the_page_has_the_stored_numbers(self):
        page = support.read(CASE, "README.md")
        for row in COMPARE["stored"]("runs.csv"):
            line = re.search(rf"^\| {re.escape(row['run'])} \|.*$", page, re.M)
            self.assertIsNotNone(line, row["run"])
            self.assertIn(f"| {float(row['deviation']):.0f} +- {float(row['error']):.0f}", line[0])
