# SPDX-License-Identifier: GPL-3.0-or-later
"""A poured bed of hard spheres comes to rest and stays at its height, at steps as long as a collision of soft ones lasts."""

import math

import numpy

import bed
import measured
import support

SECONDS = 1.9  # [s]: the spheres lie after 0.4
# The fall ends at 0.5 m/s or so: a speed of 0.15 mm/s, a twentieth of what gravity gives and takes in every step. Eight
# other starts were at 4e-11 to 9e-9.
UNREST = 1e-7


class StaticBed(support.ProgramTest):
    def lies_still(self, name, poured, step, unrest=UNREST, **options):
        diameter = poured.diameters.min()
        lying = poured.pour(self.root, SECONDS, step, **options)
        self.assertEqual(lying.count[-1], len(poured.centres), "spheres are lost")
        name = f"poured bed of 1,500 {name}, step of one collision: "
        measured.below(self, name + "kinetic energy over that of the impact", lying.unrest(), unrest, "", "rest")
        measured.below(self, name + "drift of its height, diameters in a second", abs(lying.drift()) / diameter, 0.005, "1/s", "rest")
        overlaps = lying.overlaps()
        self.assertGreater(len(overlaps), len(poured.centres), "a bed that stands has contacts")
        measured.below(self, name + "percentile 97 of the overlaps, of a diameter", 100 * numpy.percentile(overlaps, 97), 1, "%", "hard spheres have none")
        return lying

    def test_equal_spheres(self):
        d = bed.DIAMETER
        lying = self.lies_still("spheres", bed.Bed(10 * d, 10 * d).equal(1500, d), bed.collision_time(d))
        packing = len(lying.centres) * math.pi / 6 * d**3 / (100 * d**2 * 2 * lying.height[-1])
        # looser than any pour is below 0.52, denser than random packings are above 0.64
        measured.within(self, "the same: solid fraction, walls included", packing, 0.58, 0.06, "", "random packings, 0.52 to 0.64")

    def test_parcels_of_eight(self):
        d = 2 * bed.DIAMETER
        step = math.sqrt(8) * bed.collision_time(bed.DIAMETER)
        self.assertAlmostEqual(step, bed.collision_time(d))
        self.lies_still("parcels of 8", bed.Bed(10 * d, 10 * d).equal(1500, d), step)

    def test_sizes_one_to_four(self):
        d = bed.DIAMETER
        # A large sphere has 64 times a small one's mass: impulses need more passes, and large ones go on shaking with
        # about 1 mm/s. A quarter of the step brings them to rest like the others.
        poured = bed.Bed(14 * d, 14 * d).mixed(1536, d, 4)
        self.lies_still("and more of sizes 1 and 4", poured, bed.collision_time(d), unrest=1e-5, words="passes 6")
