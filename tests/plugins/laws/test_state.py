# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""A law whose contacts have a state: friction grows with the age of a contact. A sphere that slides on a plane loses g times the sum of mu over
the steps; alone, where it touches a wall, too, and from one rank to the next. A contact that ends forgets its age.
"""

import measured
import numpy

from hard_spheres import HardSphereTest, Spheres
from law_scenes import AGING, GRAVITY, gravity, law_scene

RADIUS = 5e-3
STEP = 1e-4
FRICTION, GROWTH = 0.1, 2.0  # [1], [1/s]
SPEED = 3.0


def aging(spheres, low, high, growth=GROWTH, **more):
    scene = law_scene("aging", spheres, low, high, **more)
    scene.plugin = AGING
    scene.properties = {"frictionGrowth": scene.matrix(growth)}
    return scene


class Age(HardSphereTest):
    def slide(self, ranks=1, beside_a_wall=False, height=0.0, steps=1000):
        """A sphere in the middle of a box that two ranks halve, sliding along x."""
        frictions = numpy.full((3, 3), FRICTION)
        frictions[2] = frictions[:, 2] = 0
        growths = numpy.where(frictions > 0, GROWTH, 0)
        walls = ["primitive type 2 zplane 0.0"]
        if beside_a_wall:
            walls.append(f"primitive type 3 yplane {0.1 - RADIUS!r}")
        scene = aging(Spheres(2 * RADIUS, [[0.9, 0.1, RADIUS + height]], [[SPEED, 0, 0]]), (0, 0, -0.01), (2, 0.2, 0.1), growths, e=0.0, mu=frictions,
                      types=3, walls=walls, before=gravity())  # fmt: skip
        return self.run_scene(scene, STEP, steps, every=10, ranks=ranks).history()

    def test_grows(self):
        for beside in (False, True):
            for ranks in (1, 2):
                history = self.slide(ranks, beside)
                self.assertGreater(history.position[-1, 0, 0], 1.1, "it changes its rank")
                steps = history.time / STEP
                lost = GRAVITY * STEP * (FRICTION * steps + GROWTH * STEP * steps * (steps + 1) / 2)
                # the contact that the run starts with is one step older, as contacts are resolved before the first step
                off = abs(SPEED - history.velocity[:, 0, 0] - lost).max()
                name = f"sphere sliding with friction that grows{' beside a wall' if beside else ''}, ranks {ranks}: loss of speed off the sum of mu g dt"
                measured.below(self, name, off / SPEED, 2 * GRAVITY * STEP * GROWTH * STEP * steps[-1] / SPEED + 1e-6, "", "Coulomb's law")

    def test_between_spheres(self):
        """Two large spheres on each other over a floor, the upper one sliding on the lower one: eight contacts at a time."""
        radius, speed = 1.0, 0.5
        pair = Spheres(2 * radius, [[3, 3, radius], [3, 3, 3 * radius]], [[0, 0, 0], [speed, 0, 0]])
        ends = {}
        for growth in (0.0, 100.0):
            scene = aging(pair, (0, 0, -0.1), (6, 6, 6), growth, e=0.0, mu=0.2, walls=("primitive type 2 zplane 0.0",), before=gravity(), words="passes 50")
            history = self.run_scene(scene, STEP, 50, every=50).history()
            ends[growth] = speed - history.velocity[-1, 1, 0]
            self.assertLess(abs(history.velocity[-1, 1, 2]), 0.01)
        steps = 50
        for growth, lost in ends.items():
            expected = GRAVITY * STEP * (0.2 * steps + growth * STEP * steps * (steps + 1) / 2)
            # the upper one's way around the lower one takes v^2/2r = 1.3 % of its weight
            self.assertAlmostEqual(lost / expected, 1, delta=0.05)

    def test_forgets(self):
        """A sphere that falls first: its age begins where it lands, and one that does not land has none."""
        history = self.slide(height=0.02, steps=1000)
        landed = history.time[numpy.flatnonzero(history.position[:, 0, 2] < RADIUS + 1e-6)[0]]
        sliding = history.time[-1] - landed
        # the landing itself takes mu times its own impulse, and has no age
        impact = FRICTION * numpy.sqrt(2 * GRAVITY * 0.02)
        lost = impact + GRAVITY * (FRICTION * sliding + GROWTH * sliding**2 / 2)
        self.assertAlmostEqual((SPEED - history.velocity[-1, 0, 0]) / lost, 1, delta=0.03)
