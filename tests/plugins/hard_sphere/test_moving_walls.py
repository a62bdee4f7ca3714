# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 300
"""Meshes that LIGGGHTS moves (fix move/mesh) or that slide along themselves (surface_vel) are walls with a velocity: a sphere is hit, carried along and set
rolling as mechanics says, at any step, on any number of ranks.
"""

import numpy

from hard_spheres import HardSphereTest, Scene, Spheres
from triangles import square, stl

RADIUS = 5e-3
MESH_WALL = ("mesh n_meshes 1 meshes sides",)
GRAVITY = "fix weight all gravity 9.81 vector 0 0 -1\n"


def mesh(more="", move=""):
    return f"fix sides all mesh/surface file sides.stl type 2{more}\n" + (f"fix travel all move/mesh mesh sides {move}\n" if move else "")


class Piston(HardSphereTest):
    """A plate of 32 triangles that rises, below a sphere at rest. It sets out in ten steps, as one that jumps by more than half a radius is refused."""

    SPEED = 2.0
    START = 10  # steps
    MOVE = (f"variable zero equal 0.0\nvariable up equal {SPEED}*(step>={START})+{SPEED / START}*step*(step<{START})\n"
            "fix travel all move/mesh mesh sides linear/variable v_zero v_zero v_up\n")  # fmt: skip

    def height(self, step):
        """Where the plate is after START steps of `step` s, from when on it has SPEED."""
        return step * self.SPEED * (sum(range(self.START)) / self.START + 1)

    def hit(self, step, e, ranks=1, spheres=None, **laws):
        """Sphere `up` m above the plate's start; (up, steps, history)."""
        up = 0.03 + 15 * self.SPEED * step
        spheres = spheres or Spheres(2 * RADIUS, [[0.001, 0.002, up]])
        triangles = square(4, (-0.05, -0.05, 0), (0.1, 0, 0), (0, 0.1, 0), seed=3)
        scene = Scene(spheres, (-0.5, -0.5, -0.01), (0.5, 0.5, 1.5), walls=MESH_WALL, before=mesh() + self.MOVE, e=e, **laws)
        steps = self.START + round((up + 0.08 - self.height(step)) / self.SPEED / step)
        return up, steps, self.run_scene(scene, step, steps, ranks=ranks, files={"sides.stl": stl(triangles)}).history()

    def test_it_leaves_with_one_plus_e_times_the_speed(self):
        """At steps in which the plate moves by 0.01 to 4 radii."""
        for e in (1.0, 0.6, 0.0):
            for step in (2.5e-5, 1e-3, 1e-2):
                up, steps, h = self.hit(step, e)
                left = h.velocity[-1, 0]
                after = (steps - self.START) * step - (up - RADIUS - self.height(step)) / self.SPEED  # s, since they met
                off = abs(h.position[-1, 0, 2] - up - (1 + e) * self.SPEED * after) / RADIUS
                print(f"e = {e}, plate moves by {self.SPEED * step / RADIUS:g} r in a step: leaves with {left[2] / self.SPEED:.9f} u, {off:.1e} r off")
                with self.subTest(e=e, step=step):
                    # impulses of what touches one wall are in double precision; a mesh has corners of 1e-16 m
                    self.assertLess(abs(left[2] / self.SPEED - (1 + e)), 1e-9)
                    self.assertLess(abs(left[:2]).max(), 1e-9)
                    self.assertLess(off, 1e-9)

    def test_on_two_ranks(self):
        """The plate crosses from one rank to the other and takes four spheres along, which stay apart."""
        spheres = Spheres(2 * RADIUS, [[x, 0.01, z] for x, z in ((-0.03, 0.07), (-0.01, 0.1), (0.01, 0.15), (0.03, 0.06))])
        alone = self.hit(1e-3, 0.5, spheres=spheres)[2]
        for ranks in (2, 4):
            h = self.hit(1e-3, 0.5, ranks, spheres)[2]
            self.assertLess(abs(h.position[-1] - alone.position[-1]).max(), 1e-12)
            self.assertLess(abs(h.velocity[-1] - alone.velocity[-1]).max(), 1e-12)

    def test_nobody_gets_to_the_other_side(self):
        """200 spheres in the plate's way, at 4 radii a step."""
        draw = numpy.random.default_rng(8)
        places = numpy.stack([k.ravel() for k in numpy.mgrid[-2:3, -2:3, 0:8]], axis=1) * 0.0112
        spheres = Spheres(2 * RADIUS, places + (0, 0, 0.02) + draw.uniform(-1e-4, 1e-4, (200, 3)))
        _, steps, h = self.hit(1e-2, 0.8, spheres=spheres, mu=0.3)
        plate = self.height(1e-2) + (steps - self.START) * 1e-2 * self.SPEED
        on_it = abs(h.position[-1, :, :2]).max(axis=1) < 0.05
        over = (h.position[-1, on_it, 2] - plate).min()
        print(f"the plate is at {plate:g} m, the lowest sphere over it {over / RADIUS:.3f} r above it, {(~on_it).sum()} have left it sideways")
        self.assertGreater(on_it.sum(), 50)
        self.assertGreater(over, 0)

    def refused(self, move, step, message):
        scene = Scene(Spheres(2 * RADIUS, [[0, 0, 0.4]]), (-0.06, -0.06, -0.01), (0.06, 0.06, 0.5), walls=MESH_WALL, before=mesh() + move)
        done = self.execute(scene, step, 3, files={"sides.stl": stl(square(1, (-0.05, -0.05, 0), (0.1, 0, 0), (0, 0.1, 0)))})
        self.assertNotEqual(done.code, 0)
        self.assertRegex(done.text, message)

    def test_one_that_jumps(self):
        """From rest to 2 m/s, by two thirds of a radius in the first step."""
        self.refused("fix travel all move/mesh mesh sides linear 0 0 2\n", 5 / 3 * 1e-3, r"a wall is 0\.0033.* let the mesh set out slowly")

    def test_one_that_is_too_fast(self):
        """100 parts of a step are the most: 300 m/s in 1 ms are 60 radii."""
        fast = self.MOVE.replace("2.0*(step", "300.0*(step").replace("0.2*step", "2.4*step")
        self.refused(fast.replace(f"step>={self.START}", "step>=2").replace(f"step<{self.START}", "step<2"), 1e-3, "a wall is 0.29")
        slow = "variable zero equal 0.0\nvariable up equal 2.0*step\nfix travel all move/mesh mesh sides linear/variable v_zero v_zero v_up\n"
        scene = Scene(Spheres(2 * RADIUS, [[0, 0, 30]]), (-0.06, -0.06, -0.01), (0.06, 0.06, 60), walls=MESH_WALL, before=mesh() + slow)
        done = self.execute(scene, 1e-3, 200, files={"sides.stl": stl(square(1, (-0.05, -0.05, 0), (0.1, 0, 0), (0, 0.1, 0)))})
        self.assertRegex(done.text, r"Fix tdhs: a wall moves at 25\d\.\d+ m/s, which is 0\.25.* it may pass through a sphere\. Give a step below 0\.0000")


class Belt(HardSphereTest):
    def test_slip_to_roll(self):
        """A sphere laid on a belt of speed u is dragged along by mu g until it rolls: then it has 2/7 of u, and its surface the belt's speed."""
        speed, mu = 0.7, 0.2
        triangles = square(6, (-0.5, -0.5, 0), (1, 0, 0), (0, 1, 0), seed=1)
        until = 2 / 7 * speed / (mu * 9.81)
        for direction in (numpy.array([1.0, 0, 0]), numpy.array([0.6, -0.8, 0])):
            belt = mesh(" surface_vel {} {} 0".format(*(speed * direction[:2])))
            scene = Scene(Spheres(2 * RADIUS, [[0, 0, RADIUS]]), (-0.6, -0.6, -0.01), (0.6, 0.6, 0.1), walls=MESH_WALL, before=belt + GRAVITY, mu=mu, e=0.9, et=0.0)
            step = 2e-4
            h = self.run_scene(scene, step, round(2 * until / step), files={"sides.stl": stl(triangles)}).history()
            half = round(0.5 * until / step)
            sliding = h.velocity[half, 0] @ direction
            print(f"half way {sliding / (mu * 9.81 * h.time[half]):.6f} mu g t, in the end {h.velocity[-1, 0] @ direction / speed:.9f} u")
            # one step of the belt's drag
            self.assertLess(abs(sliding - mu * 9.81 * h.time[half]), 1.01 * mu * 9.81 * step)
            # passes over a contact are in single precision
            numpy.testing.assert_allclose(h.velocity[-1, 0], 2 / 7 * speed * direction, atol=1e-6 * speed)
            spin = 5 / 7 * speed / RADIUS * numpy.cross(direction, [0, 0, 1])
            numpy.testing.assert_allclose(h.spin[-1, 0], spin, atol=1e-6 * speed / RADIUS)


class Drum(HardSphereTest):
    def test_a_sphere_goes_round_with_the_drum(self):
        """A drum of 48 flat sides about y, whose friction holds the sphere once it rests against it (gravity off): it moves as the side does."""
        n, radius, length, omega = 48, 0.05, 0.04, 6.0
        angle = numpy.linspace(0, 2 * numpy.pi, n + 1)
        ring = numpy.stack([radius * numpy.cos(angle), 0 * angle, radius * numpy.sin(angle)], axis=1)
        triangles = []
        for k in range(n):
            a, b, along = ring[k], ring[k + 1], numpy.array([0, length, 0])
            triangles += [[a, b, b + along], [a, b + along, a + along]]
        move = f"rotate origin 0 0 0 axis 0 1 0 period {2 * numpy.pi / omega!r}"
        start = Spheres(2 * RADIUS, [[0.04, 0.02, 0.0]], [[0.3, 0, 0]])
        scene = Scene(start, (-0.06, -0.01, -0.06), (0.06, 0.05, 0.06), walls=MESH_WALL, before=mesh(move=move), e=0.3, et=0.0, mu=1.0)
        h = self.run_scene(scene, 2e-4, 5000, files={"sides.stl": stl(triangles)}).history()
        x, v = h.position[:, 0], h.velocity[:, 0]
        from_axis = numpy.hypot(x[:, 0], x[:, 2])
        turning = (x[-2000:, 2] * v[-2000:, 0] - x[-2000:, 0] * v[-2000:, 2]) / from_axis[-2000:] ** 2
        print(f"turns with {turning.mean():.4f} of {omega} rad/s, at most {from_axis.max():.5f} m from the axis")
        self.assertLess(from_axis.max(), radius - RADIUS + 1e-4)
        self.assertGreater(turning.mean(), 0.2 * omega)
        self.assertLess(turning.mean(), 1.02 * omega)
