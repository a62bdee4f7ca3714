#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A poured bed of hard spheres comes to rest and stays at its height, at steps as long as a collision of soft ones lasts."""

import math
import unittest

import numpy

import bed
import support

SECONDS = 1.9  # [s]: the spheres lie after 0.4
# The fall ends at 0.5 m/s or so: a speed of 0.15 mm/s, a twentieth of what gravity gives and takes in every step. Eight
# other starts were at 4e-11 to 9e-9.
UNREST = 1e-7


class StaticBed(support.ProgramTest):
    def lies_still(self, poured, step, unrest=UNREST, **options):
        diameter = poured.diameters.min()
        lying = poured.pour(self.root, SECONDS, step, **options)
        self.assertEqual(lying.count[-1], len(poured.centres), "spheres are lost")
        self.assertLess(lying.unrest(), unrest, "kinetic energy, over that of the impact")
        self.assertLess(abs(lying.drift()), 0.005 * diameter, "the height drifts [m/s]")
        overlaps = lying.overlaps()
        self.assertGreater(len(overlaps), len(poured.centres), "a bed that stands has contacts")
        self.assertLess(numpy.percentile(overlaps, 97), 0.01, "percentile 97 of the overlaps, over a diameter")
        return lying

    def test_equal_spheres(self):
        d = bed.DIAMETER
        lying = self.lies_still(bed.Bed(10 * d, 10 * d).equal(1500, d), bed.collision_time(d))
        packing = len(lying.centres) * math.pi / 6 * d**3 / (100 * d**2 * 2 * lying.height[-1])
        self.assertGreater(packing, 0.52, "looser than any pour")
        self.assertLess(packing, 0.64, "denser than random packings are")

    def test_parcels_of_eight(self):
        d = 2 * bed.DIAMETER
        step = math.sqrt(8) * bed.collision_time(bed.DIAMETER)
        self.assertAlmostEqual(step, bed.collision_time(d))
        self.lies_still(bed.Bed(10 * d, 10 * d).equal(1500, d), step)

    def test_sizes_one_to_four(self):
        d = bed.DIAMETER
        # A large sphere has 64 times a small one's mass: impulses need more passes, and large ones go on shaking with
        # about 1 mm/s. A quarter of the step brings them to rest like the others.
        poured = bed.Bed(14 * d, 14 * d).mixed(1536, d, 4)
        self.lies_still(poured, bed.collision_time(d), unrest=1e-5, words="passes 6")


if __name__ == "__main__":
    unittest.main()
