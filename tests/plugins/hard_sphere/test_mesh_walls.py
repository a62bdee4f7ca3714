# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 300
"""Walls of triangles are walls: a floor of many is a plane, six sides of triangles are a box, and nobody leaves a cylinder.

An inner edge of a flat floor must not be felt: what rolls over it keeps its speed.
"""

import numpy

from hard_spheres import HardSphereTest, Scene, Spheres
from triangles import square, stl

GRAVITY = "fix weight all gravity 9.81 vector 0 0 -1\n"
RADIUS = 5e-3


MESH = "fix sides all mesh/surface file sides.stl type 2\n"
MESH_WALL = ("mesh n_meshes 1 meshes sides",)


class Floor(HardSphereTest):
    def histories(self, spheres, step, steps, **laws):
        """With a plane, and with the same floor of 2, of 512 regular and of 450 irregular triangles."""
        def run(walls, before, files=None):
            scene = Scene(spheres, (-1, -1, -0.1), (1, 1, 1), walls=walls, before=before + GRAVITY, **laws)
            return self.run_scene(scene, step, steps, files=files).history()

        yield "a plane", run(("primitive type 2 zplane 0.0",), "")
        for cells, seed in ((1, None), (16, None), (15, 4)):
            triangles = square(cells, (-0.9, -0.9, 0), (1.8, 0, 0), (0, 1.8, 0), seed)
            yield f"{len(triangles)} triangles", run(MESH_WALL, MESH, {"sides.stl": stl(triangles)})

    def rolling(self):
        """Through the middle, along edges, across corners, and any way."""
        draw = numpy.random.default_rng(2)
        start = [[-0.3, -0.3], [-0.3, 0.0], [0.0, -0.45], [-0.4, 0.4], *draw.uniform(-0.4, 0.4, (4, 2))]
        heading = [[1, 1], [1, 0], [0, 1], [1, -1], *draw.normal(size=(4, 2))]
        heading = numpy.array(heading) / numpy.linalg.norm(heading, axis=1, keepdims=True)
        start = numpy.array(start)
        n = len(start)
        return Spheres(2 * RADIUS, numpy.column_stack([start, numpy.full(n, RADIUS)]), numpy.column_stack([heading, numpy.zeros(n)]))

    def test_sliding_over_edges_without_friction(self):
        spheres = self.rolling()
        for k in range(len(spheres.position)):
            alone = Spheres(2 * RADIUS, spheres.position[k], spheres.velocity[k])
            for name, h in self.histories(alone, 5e-4, 600, e=0.9):
                speed = numpy.linalg.norm(h.velocity[:, 0], axis=1)
                off = abs(speed - 1).max()
                rise = abs(h.position[:, 0, 2] / RADIUS - 1).max()
                print(f"sphere {k} on {name}: speed changes by {off:.1e}, height by {rise:.1e} r")
                with self.subTest(name=name, sphere=k):
                    # the corners of a mesh are rounded to about 1e-16 m
                    self.assertLess(off, 1e-9)
                    self.assertLess(rise, 1e-9)

    def compare(self, spheres, step, steps, tolerance, **laws):
        reference = None
        for name, h in self.histories(spheres, step, steps, **laws):
            if reference is None:
                reference = h
                continue
            off = abs(h.position - reference.position).max() / RADIUS
            faster = abs(h.velocity - reference.velocity).max()
            print(f"{name} against a plane: positions differ by {off:.1e} r, velocities by {faster:.1e} m/s")
            with self.subTest(name):
                self.assertLess(off, tolerance)
                self.assertLess(faster, tolerance)

    def spread(self, speed, height):
        """25 spheres that stay apart, each with a velocity of its own."""
        draw = numpy.random.default_rng(9)
        place = numpy.stack([k.ravel() for k in numpy.mgrid[-2:3, -2:3]], axis=1) * 0.11
        velocity = numpy.column_stack([draw.uniform(-0.1, 0.1, (25, 2)) * speed, numpy.zeros(25)])
        return Spheres(2 * RADIUS, numpy.column_stack([place, RADIUS + height * draw.uniform(0.5, 1, 25)]), velocity)

    def test_rolling_with_friction_is_as_on_a_plane(self):
        self.compare(self.spread(5, 0), 2e-4, 1000, 1e-9, e=0.9, et=0.3, mu=0.3)

    def test_bouncing_is_as_on_a_plane(self):
        # corners of a mesh 1e-16 m off the plane; e^k g t magnifies no more than the number of bounces
        self.compare(self.spread(3, 0.1), 2e-4, 1500, 1e-9, e=0.8, et=0.3, mu=0.3)


class Box(HardSphereTest):
    LOW, HIGH = -0.03, 0.03

    def sides(self, cells, seed=None):
        low, high, edge = self.LOW, self.HIGH, self.HIGH - self.LOW
        x, y, z = numpy.eye(3) * edge
        triangles = []
        for corner, along, across in (((low,) * 3, x, y), ((low,) * 3, y, z), ((low,) * 3, z, x),
                                      ((high,) * 3, -x, -y), ((high,) * 3, -y, -z), ((high,) * 3, -z, -x)):  # fmt: skip
            triangles += square(cells, corner, along, across, seed)
        return triangles

    def both(self, spheres, step, steps, before="", **laws):
        planes = tuple(f"primitive type 2 {axis}plane {at}" for axis in "xyz" for at in (self.LOW, self.HIGH))
        found = {}
        for name, walls, mesh, files in (
            ("planes", planes, "", None),
            ("12 triangles", MESH_WALL, MESH, {"sides.stl": stl(self.sides(1))}),
            ("300 triangles", MESH_WALL, MESH, {"sides.stl": stl(self.sides(5, 7))}),
        ):
            scene = Scene(spheres, (-0.1,) * 3, (0.1,) * 3, walls=walls, before=mesh + before, **laws)
            found[name] = self.run_scene(scene, step, steps, files=files).history()
        return found

    def test_a_flight_through_the_box(self):
        """Sides met one after the other, e = 1: as the planes send it, for 40 impacts."""
        spheres = Spheres(2 * RADIUS, [[0.001, 0.002, -0.003]], [[1.0, 0.7310, 0.3317]])
        found = self.both(spheres, 1e-4, 10000)
        for name, h in found.items():
            off = abs(h.position - found["planes"].position).max() / RADIUS
            speed = abs(numpy.linalg.norm(h.velocity[:, 0], axis=1) / numpy.linalg.norm(spheres.velocity) - 1).max()
            print(f"flight in a box of {name}: {off:.1e} r from the one between planes, speed changes by {speed:.1e}")
            with self.subTest(name):
                # at an edge both sides are near at once, whose impulses are kept in single precision
                self.assertLess(off, 1e-4)
                self.assertLess(speed, 1e-6)

    def test_into_a_corner(self):
        """Thrown into the corner, all three sides hit it at once; it comes back the way it came, e times as fast."""
        e = 0.8
        direction = numpy.array([-1.0, -1, -1]) / numpy.sqrt(3)
        for name, h in self.both(Spheres(2 * RADIUS, [[0.0] * 3], [direction]), 1e-4, 700, e=e).items():
            back = h.velocity[-1, 0]
            nearest = (h.position[:, 0] - self.LOW).min() / RADIUS
            print(f"corner of {name}: comes back with {back / e}, nearest to a side {nearest:.7f} r")
            with self.subTest(name):
                self.assertLess(numpy.linalg.norm(back + e * direction), 1e-5)
                self.assertGreater(nearest, 1 - 1e-5)

    def test_rests_in_a_corner(self):
        """Gravity along the diagonal, friction: it comes to rest touching three sides."""
        before = "fix weight all gravity 9.81 vector -1 -1 -1\n"
        for name, h in self.both(Spheres(2 * RADIUS, [[0.0, 0.003, -0.002]], [[0.1, 0, 0.2]]), 2e-4, 5000, before, e=0.5, et=0.3,
                                 mu=0.3).items():  # fmt: skip
            deep = (h.position[:, 0] - self.LOW).min() / RADIUS
            gap = (h.position[-1, 0] - self.LOW).max() / RADIUS - 1
            speed = numpy.linalg.norm(h.velocity[-1, 0])
            print(f"rest in a corner of {name}: speed {speed:.1e} m/s, largest gap {gap:.1e} r, deepest {1 - deep:.1e} r")
            with self.subTest(name):
                self.assertLess(speed, 1e-6)
                self.assertLess(abs(gap), 0.01)  # 0.3 % of a diameter of overlap are tolerated
                self.assertGreater(deep, 0.98)


class Cylinder(HardSphereTest):
    RADIUS = 0.03

    def flight(self, axis, e, step, time=1.0):
        """Bounces round in the cylinder; (how far out the centre comes, over the radius; change of the angular momentum about the
        axis; energy, its first value 1; change of the velocity along the axis)."""
        along, first, second = (("xyz".index(axis) + k) % 3 for k in range(3))
        position, velocity = numpy.zeros((1, 3)), numpy.zeros((1, 3))
        position[0, first], velocity[0, first], velocity[0, second], velocity[0, along] = 0.011, 0.37, 0.9, 0.01
        scene = Scene(Spheres(2 * RADIUS, position + 0.002, velocity), (-0.1,) * 3, (0.1,) * 3, e=e,
                      walls=(f"primitive type 2 {axis}cylinder {self.RADIUS} 0.002 0.002",))  # fmt: skip
        h = self.run_scene(scene, step, round(time / step)).history()
        x, v = h.position[:, 0] - 0.002, h.velocity[:, 0]
        out = (numpy.hypot(x[:, first], x[:, second]).max() + RADIUS - self.RADIUS) / RADIUS
        # between impacts: in a step with one, the position is still that of before, the velocity that of afterwards
        free = numpy.append(True, (v[1:] == v[:-1]).all(axis=1))
        turn = (x[:, first] * v[:, second] - x[:, second] * v[:, first])[free]
        energy = (v**2).sum(axis=1) / (velocity**2).sum()
        print(f"{axis}cylinder, e = {e}, step {step}: out by {out:.1e} r, angular momentum {turn.min() / turn[0] - 1:+.1e} "
              f"{turn.max() / turn[0] - 1:+.1e}, energy {energy.min():.6f} to {energy.max():.6f}")
        return out, abs(turn / turn[0] - 1).max(), energy, abs(v[:, along] / 0.01 - 1).max()

    def test_a_sphere_stays_in_a_frictionless_cylinder(self):
        for axis in "xyz":
            for e in (1.0, 0.8):
                with self.subTest(axis=axis, e=e):
                    out, turn, energy, along = self.flight(axis, e, 1e-4)
                    # What slides along a wall (e below 1) may be in it by the overlap that is tolerated, below 1 % of a diameter.
                    self.assertLess(out, 0.02)
                    self.assertLess(energy.max(), 1 + 1e-9)
                    self.assertLess(along, 1e-12)
                    if e == 1:
                        self.assertGreater(energy.min(), 1 - 1e-9)

    def test_angular_momentum_about_the_axis(self):
        """A smooth wall gives none. What is left is how well Newton's iteration finds the normal where the sphere touches."""
        turns = [self.flight("z", 1.0, step)[1] for step in (2e-4, 1e-4)]
        self.assertLess(max(turns), 1e-6)

    def test_many_stay_in(self):
        """200 spheres in a cylinder with a floor and gravity, from above down to rest."""
        draw = numpy.random.default_rng(4)
        place = [(x, y, z) for z in numpy.arange(10) * 0.0105 for x in numpy.arange(-2, 3) * 0.0105 for y in numpy.arange(-2, 3) * 0.0105
                 if numpy.hypot(x, y) < 0.0245]  # fmt: skip
        position = numpy.array(place) + [0, 0, RADIUS] + draw.uniform(-1e-4, 1e-4, (len(place), 3))
        scene = Scene(Spheres(2 * RADIUS, position), (-0.1, -0.1, -0.1), (0.1, 0.1, 0.2), e=0.8, before=GRAVITY,
                      walls=(f"primitive type 2 zcylinder {self.RADIUS} 0.0 0.0", "primitive type 2 zplane 0.0"))  # fmt: skip
        h = self.run_scene(scene, 3e-4, 2000, every=100).history()
        out = numpy.hypot(h.position[..., 0], h.position[..., 1]).max() + RADIUS - self.RADIUS
        below = RADIUS - h.position[..., 2].min()
        print(f"{len(place)} spheres in a cylinder: into the side by {out / RADIUS:.1e} r, into the floor by {below / RADIUS:.1e} r")
        # 0.3 % of a diameter is tolerated without a push, the rest is what four passes leave of an impact of the whole heap
        self.assertLess(out / RADIUS, 0.03)
        self.assertLess(below / RADIUS, 0.03)
