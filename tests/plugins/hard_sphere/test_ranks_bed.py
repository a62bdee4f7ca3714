# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 4
"""A poured bed of hard spheres is the same bed on 1, 2 and 4 ranks, but for the chance of each pour: no sphere is lost, it comes
to rest, and its height lies within the scatter of heights that other starts give on one rank.
"""

import os

import numpy

import bed
import measured
import support

COUNT, SECONDS = 1000, 1.2
SEEDS = (1, 2, 3)


class RanksOfABed(support.ProgramTest):
    def pour(self, seed, ranks):
        d = bed.DIAMETER
        folder = os.path.join(self.root, f"{ranks}-{seed}")
        return bed.Bed(14 * d, 7 * d, seed).equal(COUNT, d).pour(folder, SECONDS, bed.collision_time(d), ranks)

    def test_one_two_and_four(self):
        lying = {ranks: [self.pour(seed, ranks) for seed in SEEDS] for ranks in (1, 2, 4)}
        alone = numpy.array([one.height[-1] for one in lying[1]])
        # mean of as many pours, at four standard errors of the difference; the scatter of three is itself uncertain
        tolerance = max(4 * alone.std(ddof=1) * (2 / len(SEEDS)) ** 0.5, 0.02 * bed.DIAMETER)
        for ranks, beds in lying.items():
            with self.subTest(ranks=ranks):
                for one in beds:
                    self.assertEqual(one.count[-1], COUNT, "spheres are lost")
                    self.assertLess(one.unrest(), 1e-6, "kinetic energy, over that of the impact")
                    self.assertLess(abs(one.drift()), 0.005 * bed.DIAMETER, "the height drifts [m/s]")
                    self.assertLess(numpy.percentile(one.overlaps(), 97), 0.01)
                heights = numpy.array([one.height[-1] for one in beds]) / bed.DIAMETER
                measured.within(self, f"poured bed of {COUNT} hard spheres, {len(SEEDS)} pours, ranks: {ranks}: mean height in diameters", heights.mean(),
                                alone.mean() / bed.DIAMETER, tolerance / bed.DIAMETER, "", "one rank", heights.std(ddof=1) / len(SEEDS) ** 0.5)  # fmt: skip
