# SPDX-License-Identifier: GPL-3.0-or-later
# label: slow
# timeout: 7200
"""The bed of cases/sscp1, 95,000 hard spheres, lies still for ten seconds at steps as long as a collision of soft ones lasts.

LIGGGHTS's own DEM of this bed, dropped from a lattice, comes to rest at a mean height of 0.083 m, 97 % of its overlaps below 0.72 % of a
diameter.
"""

import numpy

import bed
import support

WIDTH, DEPTH, COUNT = 0.2286, 0.0762, 95000
SECONDS = 10
HEIGHT = 0.083  # mean, of the DEM [m]


class BedOfSscp1(support.ProgramTest):
    def lies_still(self, poured, step, **options):
        diameter = poured.diameters.min()
        lying = poured.pour(self.root, SECONDS, step, timeout=7000, **options)
        print(f"{self.id().split('.')[-1]}: unrest {lying.unrest():.1e}, kinetic energy {lying.kinetic[-1]:.1e} J, mean height "
              f"{lying.height[-1]:.5f} m, drift {lying.drift() / diameter:.1e} d/s, overlaps' percentile 97 "
              f"{100 * numpy.percentile(lying.overlaps(), 97):.2f} % d")  # fmt: skip
        self.assertEqual(lying.count[-1], len(poured.centres), "spheres are lost")
        self.assertLess(lying.unrest(), 1e-7, "kinetic energy, over that of the impact")  # as in test_static_bed
        self.assertLess(abs(lying.drift()), 0.005 * diameter, "the height drifts [m/s]")
        after_pour = numpy.searchsorted(lying.time, 1.0)
        # in parcels 50 layers deep impulses take longest to find their way: they sink by 0.1 in all, ever more slowly
        self.assertLess(abs(lying.height[-1] - lying.height[after_pour]), 0.2 * diameter, "the bed sinks")
        self.assertLess(numpy.percentile(lying.overlaps(), 97), 0.01, "percentile 97 of the overlaps, over a diameter")
        return lying

    def test_equal_spheres(self):
        d = bed.DIAMETER
        lying = self.lies_still(bed.Bed(WIDTH, DEPTH).equal(COUNT, d), bed.collision_time(d))
        self.assertLess(abs(lying.height[-1] / HEIGHT - 1), 0.03, "mean height, over that of the DEM")

    def test_parcels_of_eight(self):
        d = 2 * bed.DIAMETER
        self.lies_still(bed.Bed(2 * WIDTH, 2 * DEPTH).equal(COUNT, d), bed.collision_time(d))

    def test_sizes_one_to_four(self):
        d = bed.DIAMETER
        small = round(COUNT * 64 / 65)  # as much volume of either size
        self.lies_still(bed.Bed(WIDTH, DEPTH).mixed(small, d, 4), bed.collision_time(d), words="passes 6")
