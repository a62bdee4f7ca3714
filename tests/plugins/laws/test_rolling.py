# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""The law `rolling`: a sphere that rolls on a plane slows down at 5/7 mu_r g and stops; on a slope it stays where tan(slope) is below mu_r and
rolls down at 5/7 g (sin - mu_r cos) where it is above. Momentum, and angular momentum of two spheres, stay.

The couple mu_r r m g and sticking friction act on a sphere with I = 2/5 m r^2 about its centre, 7/5 m r^2 about the contact: 7/5 m r^2 a/r = mu_r r m g.
"""

import measured
import numpy

from hard_spheres import HardSphereTest, Spheres
from law_scenes import GRAVITY, gravity, law_scene

RADIUS = 5e-3
STEP = 2e-4
RESISTANCE = (0.01, 0.05, 0.2)
SPEEDS = (0.1, 0.5)


def rolling(scene, value):
    scene.properties = {"coefficientRollingFriction": scene.matrix(value)}
    return scene


class OnAPlane(HardSphereTest):
    def roll(self, weight, speeds, seconds, beside_a_wall):
        """Spheres of each resistance side by side, rolling along x at the start; a smooth wall along its way makes a sphere one of two
        contacts, for which the solver of clusters is responsible."""
        cases = [(k, u) for k in range(len(RESISTANCE)) for u in speeds]
        kind, speed = numpy.array(cases).T
        n, floor = len(cases), len(RESISTANCE) + 1
        side = floor + 1
        position = numpy.column_stack([numpy.full(n, 0.1), 0.1 + 0.1 * numpy.arange(n), numpy.full(n, RADIUS)])
        velocity = numpy.column_stack([speed, numpy.zeros((n, 2))])
        spin = numpy.column_stack([numpy.zeros(n), speed / RADIUS, numpy.zeros(n)])
        pairs, friction = numpy.zeros((side, side)), numpy.zeros((side, side))
        pairs[floor - 1, : len(RESISTANCE)] = pairs[: len(RESISTANCE), floor - 1] = RESISTANCE
        friction[floor - 1, : len(RESISTANCE)] = friction[: len(RESISTANCE), floor - 1] = 0.6
        walls = [f"primitive type {floor} zplane 0.0"]
        if beside_a_wall:
            walls += [f"primitive type {side} yplane {y - RADIUS!r}" for y in position[:, 1].tolist()]
        scene = law_scene("rolling", Spheres(2 * RADIUS, position, velocity, spin, type=1 + kind.astype(int)), (0, -1, -0.01), (4, 5, 0.1), e=0.5,
                          et=0.5, mu=friction, types=side, walls=walls, before=weight)  # fmt: skip
        history = self.run_scene(rolling(scene, pairs), STEP, int(seconds / STEP)).history()
        return numpy.array(RESISTANCE)[kind.astype(int)], speed, history

    def test_slows_down_and_stops(self):
        for beside in (False, True):
            resistance, speed, history = self.roll(gravity(), SPEEDS, 1.0, beside)
            slows, distances, rests = [], [], []
            for k, (mu, u) in enumerate(zip(resistance, speed)):
                deceleration = 5 / 7 * mu * GRAVITY
                v = history.velocity[:, k, 0]
                rolls = (history.time > 3 * STEP) & (v > 0.1 * u)
                slope = numpy.polyfit(history.time[rolls], v[rolls], 1)[0]
                slows.append(abs(-slope / deceleration - 1))
                if u / deceleration < 0.8:  # it stops within the run
                    distances.append(abs((history.position[-1, k, 0] - 0.1) / (u * u / (2 * deceleration)) - 1))
                    rests.append(abs(v[-1]))
            self.assertGreater(len(distances), 2)
            name = f"sphere rolling on a plane, mu_r 0.01 to 0.2{' beside a wall' if beside else ''}: "
            # each step's impulses are exact; the couple is felt by the centre one step later, through friction
            measured.below(self, name + "deceleration off 5/7 mu_r g", max(slows), 1e-3, "", "equation of motion")
            measured.below(self, name + "way to rest off v^2/(2 a)", max(distances), 0.02, "", "equation of motion")
            self.assertLess(max(rests), 1e-8)

    def test_slopes(self):
        slope = 0.1  # between the second and the third resistance
        weight = gravity(numpy.sin(slope), 0.0, -numpy.cos(slope))
        for beside in (False, True):
            resistance, _, history = self.roll(weight, (0.0,), 0.3, beside)
            seconds = history.time[-1] - history.time[0]
            for k, mu in enumerate(resistance):
                expected = max(0.0, 5 / 7 * GRAVITY * (numpy.sin(slope) - mu * numpy.cos(slope)))
                found = history.velocity[-1, k, 0] / seconds
                measured.within(self, f"sphere on a slope of 0.1, mu_r {mu}{', beside a wall' if beside else ''}: acceleration", found, expected,
                                0.01 * GRAVITY * slope, "m/s2", "5/7 g (sin - mu_r cos), 0 at rest")  # fmt: skip


class Conservation(HardSphereTest):
    def test_angular_momentum_of_two(self):
        """Off-centre, spinning: what the couple takes from one it gives to the other."""
        spheres = Spheres([0.01, 0.014], [[0.1, 0.1, 0.1], [0.113, 0.104, 0.1]], [[1, 0, 0], [-1, 0.1, 0]], [[10, 200, -50], [30, -100, 80]])
        ends = {}
        for mu in (0.0, 0.3):
            scene = rolling(law_scene("rolling", spheres, (0, 0, 0), (0.2, 0.2, 0.2), e=0.8, et=0.5, mu=0.4), mu)
            history = self.run_scene(scene, STEP, 50, every=50).history()
            mass, inertia = spheres.mass[:, None], spheres.inertia[:, None]
            spins = [(mass * numpy.cross(history.position[k], history.velocity[k]) + inertia * history.spin[k]).sum(axis=0) for k in (0, -1)]
            self.assertLess(numpy.abs(spins[1] - spins[0]).max(), 1e-13 * numpy.abs(mass * history.position[0]).max())
            ends[mu] = history.spin[-1]
        self.assertGreater(numpy.abs(ends[0.3] - ends[0.0]).max(), 1, "the couple acts")

    def test_momentum_of_a_gas_on_ranks(self):
        """In a dense periodic gas; more than half of its contacts are in clusters."""
        draw = numpy.random.default_rng(5)
        edge, pitch = 8, 2.2e-3
        sites = numpy.stack([k.ravel() for k in numpy.mgrid[0:edge, 0:edge, 0:edge]], axis=1) + 0.5
        position = pitch * sites + draw.uniform(-1e-4, 1e-4, sites.shape)
        spheres = Spheres(draw.uniform(1.6e-3, 2e-3, len(sites)), position, draw.normal(size=sites.shape), draw.normal(size=sites.shape) * 500)
        size = pitch * edge
        for ranks in (1, 2, 4):
            scene = rolling(law_scene("rolling", spheres, (0, 0, 0), (size, size, size), e=0.9, et=0.5, mu=0.4, boundary="p p p", skin=5e-4), 0.2)
            history = self.run_scene(scene, 2e-5, 500, every=500, ranks=ranks).history()
            momentum = (spheres.mass[:, None] * (history.velocity[-1] - history.velocity[0])).sum(axis=0)
            whole = (spheres.mass[:, None] * abs(history.velocity[0])).sum()
            measured.below(self, f"gas with rolling resistance, 500 steps, ranks {ranks}: change of momentum over the sum of all", abs(momentum).max() / whole,
                           1e-13, "", "Newton's third law")  # fmt: skip
