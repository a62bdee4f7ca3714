# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""The law `cohesive`: a sphere hangs from a ceiling, and from another sphere, up to the weight 2 pi w r_e and not beyond; parting takes the work
pi w r_e a; a pile hangs together; momentum stays on any number of ranks, and what is far apart is left alone.
"""

import measured
import numpy
import triangles

from hard_spheres import HardSphereTest, Spheres
from law_scenes import GRAVITY, gravity, law_scene

RADIUS = 2e-3
DENSITY = 2500.0
RANGE = 2e-4  # [m]
STEP = 1e-4  # [s]: a sphere at 0.1 m/s takes 20 steps through the range
MASS = DENSITY * 4 / 3 * numpy.pi * RADIUS**3
HANGING = MASS * GRAVITY / (2 * numpy.pi * RADIUS)  # work of adhesion that just carries a sphere at a plane [J/m2]


def cohesive(scene, work, reach=RANGE):
    scene.properties |= {"workOfAdhesion": scene.matrix(work), "cohesionRange": scene.matrix(reach)}
    return scene


class PullOff(HardSphereTest):
    def falls(self, spheres, work, step=STEP, **more):
        """How far the spheres have come down in 0.1 s; free fall makes 49 mm."""
        scene = cohesive(law_scene("cohesive", spheres, (0, 0, 0), (0.4, 0.1, 0.1), e=0.5, before=gravity(), **more), work)
        steps = round(0.1 / step)
        history = self.run_scene(scene, step, steps, every=steps).history()
        return history.position[0, :, 2] - history.position[-1, :, 2]

    def check(self, name, spheres, at_pull_off, **more):
        """Below and above: 0.1 % are a thousand times what single precision makes of the numbers."""
        for share, hangs in ((1.001, True), (0.999, False)):
            fall = self.falls(spheres, share * at_pull_off, **more)[-1]
            with self.subTest(name, share=share):
                if hangs:
                    self.assertLess(abs(fall), 1e-3 * RANGE)
                else:  # drawn back over the range, it is slow to start
                    self.assertGreater(fall, RANGE)

    def test_from_a_ceiling(self):
        one = Spheres(2 * RADIUS, [[0.05, 0.05, 0.09 - RADIUS]], density=DENSITY)
        self.check("plane", one, HANGING, walls=("primitive type 2 zplane 0.09",))

    def test_at_other_steps(self):
        """In the longest it would fall through nearly the whole range."""
        one = Spheres(2 * RADIUS, [[0.05, 0.05, 0.09 - RADIUS]], density=DENSITY)
        for step in (1e-5, 1e-3, 4e-3):
            self.check(f"step {step:g} s", one, HANGING, step=step, walls=("primitive type 2 zplane 0.09",))

    def test_from_a_ceiling_of_triangles(self):
        one = Spheres(2 * RADIUS, [[0.05, 0.05, 0.09 - RADIUS]], density=DENSITY)
        text = triangles.stl(triangles.square(5, (0, 0, 0.09), (0.1, 0, 0), (0, 0.1, 0), seed=1))
        for share, hangs in ((1.001, True), (0.999, False)):
            scene = law_scene("cohesive", one, (0, 0, 0), (0.4, 0.1, 0.1), e=0.5, walls=("mesh n_meshes 1 meshes ceiling",),
                              before=gravity() + "fix ceiling all mesh/surface file ceiling.stl type 2\n")  # fmt: skip
            done = self.run_scene(cohesive(scene, share * HANGING), STEP, 1000, every=1000, files={"ceiling.stl": text})
            fall = numpy.ptp(done.history().position[:, 0, 2])
            self.assertEqual(fall < 1e-3 * RANGE, hangs, fall)

    def test_from_another_sphere(self):
        """That one hangs by more from the ceiling: r_e of two is half of r_e at a plane."""
        two = Spheres(2 * RADIUS, [[0.05, 0.05, 0.09 - RADIUS], [0.05, 0.05, 0.09 - 3 * RADIUS]], density=DENSITY)
        held = [[1.0, 10.0], [10.0, 1.0]]
        self.check("sphere", two, 2 * HANGING * numpy.array(held), walls=("primitive type 2 zplane 0.09",))

    def test_work(self):
        """Thrown off a wall it slows down by the work pi w r a, and comes back where it has less."""
        work = 0.1
        barrier = numpy.pi * work * RADIUS * RANGE  # [J]
        speeds = numpy.sqrt(2 * barrier / MASS) * numpy.array([0.95, 1.05, 1.5, 3.0])
        n = len(speeds)
        spheres = Spheres(2 * RADIUS, numpy.column_stack([0.02 * (1 + numpy.arange(n)), numpy.full(n, 0.05), numpy.full(n, RADIUS)]),
                          numpy.column_stack([numpy.zeros((n, 2)), speeds]), density=DENSITY)  # fmt: skip
        step = RANGE / speeds.max() / 100
        scene = cohesive(law_scene("cohesive", spheres, (0, 0, -0.01), (0.4, 0.1, 0.1), e=0.5, walls=("primitive type 2 zplane 0.0",)), work)
        history = self.run_scene(scene, step, 4000, every=4000).history()
        self.assertLess(abs(history.velocity[-1, 0, 2]), 1e-12, "it is back, and at rest")
        lost = 0.5 * MASS * (speeds**2 - history.velocity[-1, :, 2] ** 2)
        # a step is 1/100 of the range or less: the force at its end is 1 % off, half of it before and half behind
        measured.below(self, "cohesive sphere thrown off a plane: work of parting off pi w r a", abs(lost[1:] / barrier - 1).max(), 0.02, "", "integral of the force")


class Piles(HardSphereTest):
    def heap(self):
        """Rows of touching spheres under a ceiling, 6 x 6 x 6."""
        sites = numpy.stack([k.ravel() for k in numpy.mgrid[0:6, 0:6, 0:6]], axis=1)
        return Spheres(2 * RADIUS, [0.03, 0.03, 0.09 - RADIUS] + 2 * RADIUS * sites * [1, 1, -1], density=DENSITY)

    def test_hangs(self):
        """Each row of six hangs by its uppermost contact: six weights, of two spheres' half radius."""
        heap, ceiling = self.heap(), ("primitive type 2 zplane 0.09",)
        for ranks in (1, 2):
            for share, hangs in ((20.0, True), (0.0, False)):
                work = share * 2 * HANGING
                scene = law_scene("cohesive", heap, (0, 0, -0.3), (0.1, 0.1, 0.1), e=0.5, mu=0.3, et=0.5, walls=ceiling, before=gravity())
                history = self.run_scene(cohesive(scene, work), STEP, 2000, every=2000, ranks=ranks).history()
                fall = history.position[0, :, 2] - history.position[-1, :, 2]
                with self.subTest(ranks=ranks, hangs=hangs):
                    if hangs:
                        self.assertLess(abs(fall).max(), 0.05 * RADIUS)
                    else:
                        self.assertGreater(fall.min(), 0.15)

    def test_rolling_and_cohesion_together(self):
        """Below the weight that pulls it off, a sphere on the ceiling that rolls slows down by mu_r r (F - m g)."""
        share, mu_r = 3.0, 0.05
        speed = 0.2
        one = Spheres(2 * RADIUS, [[0.02, 0.05, 0.09 - RADIUS]], [[speed, 0, 0]], [[0, -speed / RADIUS, 0]], density=DENSITY)
        scene = law_scene("cohesive_rolling", one, (0, 0, 0), (0.4, 0.1, 0.1), e=0.5, et=0.5, mu=0.6, walls=("primitive type 2 zplane 0.09",), before=gravity())
        scene.properties = {"coefficientRollingFriction": scene.matrix(mu_r)}
        history = self.run_scene(cohesive(scene, share * HANGING), STEP, 500, every=10).history()
        slope = numpy.polyfit(history.time[1:], history.velocity[1:, 0, 0], 1)[0]
        measured.within(self, "sphere rolling along a ceiling it sticks to: deceleration", -slope, 5 / 7 * mu_r * (share - 1) * GRAVITY, 1e-3, "m/s2", "equation of motion")


class Ranks(HardSphereTest):
    def test_momentum(self):
        """A periodic gas of two sizes that sticks together."""
        draw = numpy.random.default_rng(5)
        edge, pitch = 8, 3e-3
        sites = numpy.stack([k.ravel() for k in numpy.mgrid[0:edge, 0:edge, 0:edge]], axis=1) + 0.5
        size = pitch * edge
        spheres = Spheres(draw.uniform(1.6e-3, 2.4e-3, len(sites)), pitch * sites + draw.uniform(-2e-4, 2e-4, sites.shape), 0.2 * draw.normal(size=sites.shape))
        mass = spheres.mass[:, None]
        bonds = {}
        for ranks in (1, 2, 4):
            for work in (0.0, 0.05):
                scene = law_scene("cohesive", spheres, (0, 0, 0), (size, size, size), e=0.5, et=0.5, mu=0.4, boundary="p p p", skin=5e-4)
                history = self.run_scene(cohesive(scene, work), STEP, 500, every=500, ranks=ranks).history()
                x = history.position[-1] % size
                apart = x[:, None] - x[None]
                gaps = numpy.linalg.norm(apart - size * numpy.round(apart / size), axis=2) - 0.5 * (spheres.diameter[:, None] + spheres.diameter[None])
                bonds[work] = (gaps[numpy.triu_indices(len(x), 1)] < 0.1 * RANGE).sum()
                momentum = (mass * (history.velocity[-1] - history.velocity[0])).sum(axis=0)
                measured.below(self, f"gas of cohesive spheres, w = {work} J/m2, 500 steps, ranks {ranks}: change of momentum over the sum of all",
                               abs(momentum).max() / (mass * abs(history.velocity[0])).sum(), 1e-13, "", "Newton's third law")  # fmt: skip
            self.assertGreater(bonds[0.05], 3 * bonds[0.0] + 20, "they stick together")

    def test_alike(self):
        """Two spheres drawn together across the plane between two ranks, by which no contact tells them of each other."""
        two = Spheres(2 * RADIUS, [[0.05 - RADIUS - 0.4 * RANGE, 0.05, 0.05], [0.05 + RADIUS + 0.4 * RANGE, 0.05, 0.05]], density=DENSITY)
        ends = []
        for ranks in (1, 2):
            scene = cohesive(law_scene("cohesive", two, (0, 0, 0), (0.1, 0.1, 0.1), e=0.5), 0.01)
            ends.append(self.run_scene(scene, 2e-5, 1500, every=10, ranks=ranks).history())
        self.assertLess(ends[0].position[:, 1, 0].min(), 0.05 + RADIUS + 0.1 * RANGE, "they come together")
        numpy.testing.assert_allclose(ends[1].position, ends[0].position, rtol=0, atol=1e-15)
