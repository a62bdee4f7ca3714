# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""Hard spheres that grow while the run goes on (fix adapt) meet, whatever ranks they are on: each rank knows those of the others as far away
as they reach by now, at the size that they have by now."""

import numpy

from hard_spheres import HardSphereTest, Scene, Spheres


class Growing(HardSphereTest):
    def test_over_four_ranks(self):
        """Two spheres of 4 mm, 60 mm apart with one rank of four between them at the start, grow to 68 mm."""
        spheres = Spheres(0.004, [(0.02, 0.05, 0.05), (0.08, 0.05, 0.05)])
        grow = "variable size equal 0.004+0.064*step/2000\nfix grow all adapt 1 atom diameter v_size\n"
        scene = Scene(spheres, (0, 0, 0), (0.1, 0.1, 0.1), before=grow, skin=0.0005)
        ends = [self.run_scene(scene, 1e-5, 2000, every=2000, ranks=ranks).history().position[-1] for ranks in (1, 2, 4)]
        # what is tolerated of an overlap (0.3 % of a diameter), and a share of what the last steps' growth added
        self.assertGreater(ends[0][1, 0] - ends[0][0, 0], 0.995 * 0.068)
        self.assertAlmostEqual(ends[0].sum(axis=0)[0], 0.1, delta=1e-12)  # both give way alike
        for end in ends[1:]:
            numpy.testing.assert_allclose(end, ends[0], rtol=0, atol=1e-9)  # shifts are in single precision
