# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 300
"""What hard spheres do to meshes of style mesh/surface/stress: forces, torques and stresses are those of the spheres' change of momentum, on any number of ranks.

LIGGGHTS shows at step n what acted since step n - 1.
"""

import glob
import os

import numpy

from hard_spheres import HardSphereTest, Scene, Spheres
from triangles import square, stl

RADIUS = 5e-3
G = 9.81
GRAVITY = f"fix weight all gravity {G} vector 0 0 -1\n"
WALL = ("mesh n_meshes 1 meshes sides",)
SHOWN = "step atoms " + " ".join(f"f_sides[{k}]" for k in range(1, 7))


def mesh(more=""):
    return f"fix sides all mesh/surface/stress file sides.stl type 2{more}\n"


def floor(cells=5, seed=2):
    return square(cells, (-0.5, -0.5, 0), (1, 0, 0), (0, 1, 0), seed)


def box(size):
    """Six sides of a cube in the corner of the axes."""
    x, y, z = size * numpy.eye(3)
    return [t for a, b, c in ((x, y, z), (y, z, x), (z, x, y)) for at in (0 * c, c) for t in square(3, at, a, b, seed=1)]


class WallForces(HardSphereTest):
    def shown(self, done):
        """(forces, torques) of steps 1, 2, ..."""
        rows = done.thermo()[1:, 2:]
        return rows[:, :3], rows[:, 3:]

    def test_sliding_sphere(self):
        """mu m g along the floor, m g down on it, at the point of contact: the torque about any point tells where."""
        mu, step, about = 0.3, 2e-4, numpy.array([0.1, -0.2, 0.05])
        spheres = Spheres(2 * RADIUS, [[-0.1, 0.07, RADIUS]], [[0.9, -0.3, 0]])
        before = mesh(" reference_point {} {} {}".format(*about)) + GRAVITY
        scene = Scene(spheres, (-0.6, -0.6, -0.01), (0.6, 0.6, 0.1), walls=WALL, before=before, mu=mu, thermo=SHOWN)
        done = self.run_scene(scene, step, 200, files={"sides.stl": stl(floor())})
        force, torque = self.shown(done)
        h, weight = done.history(), spheres.mass[0] * G
        along = spheres.velocity[0] / numpy.linalg.norm(spheres.velocity[0])
        expected = weight * (mu * along - numpy.array([0, 0, 1]))
        # by the impulse of the step before, from where the sphere then was; of passes in single precision, the first of which take it up
        contact = h.position[:-1, 0] - numpy.array([0, 0, RADIUS])
        print(f"force {force[50]} of {expected} N, torque {torque[50]} N m")
        numpy.testing.assert_allclose(force[50:], numpy.broadcast_to(expected, force[50:].shape), atol=1e-6 * weight)
        numpy.testing.assert_allclose(torque[50:], numpy.cross(contact - about, force)[50:], atol=1e-6 * weight * 0.3)

    def test_momentum_of_a_crowd(self):
        """What the sides of a box take is what 216 spheres and their weight lose, binary collisions and clusters alike."""
        size = 0.1
        draw = numpy.random.default_rng(5)
        places = numpy.stack([k.ravel() for k in numpy.mgrid[0:6, 0:6, 0:6]], axis=1) * 0.0155 + 0.011
        spheres = Spheres(2 * RADIUS, places, draw.normal(0, 0.5, (216, 3)), draw.normal(0, 30, (216, 3)))
        for ranks in (1, 2, 4):
            scene = Scene(spheres, (-0.01,) * 3, (0.11,) * 3, walls=WALL, before=mesh() + GRAVITY, e=0.8, mu=0.3, thermo=SHOWN)
            step, steps = 2e-4, 1500
            done = self.run_scene(scene, step, steps, ranks=ranks, files={"sides.stl": stl(box(size))})
            force, _ = self.shown(done)
            momentum = (spheres.mass[:, None] * done.history().velocity).sum(axis=1)
            weight = numpy.array([0, 0, -spheres.mass.sum() * G])
            # the velocities of step 0 have the contacts of the first step, whose impulses LIGGGHTS shows at step 1
            given = numpy.cumsum(step * force[1:], axis=0)
            lost = momentum[0] + weight * step * numpy.arange(1, steps)[:, None] - momentum[1:-1]
            off = abs(given - lost).max() / (step * abs(force)).sum()
            print(f"{ranks} ranks: off by {off:.1e} of all impulses")
            # 1e-7: of a contact's impulse as passes keep it, in single precision
            self.assertLess(off, 1e-7)

    def test_the_triangle_that_is_pressed(self):
        """Of a sphere at rest: m g over the area of the triangle below it, nothing on the others; on two ranks too."""
        place = numpy.array([0.13, -0.22])
        spheres = Spheres(2 * RADIUS, [[*place, RADIUS]])
        triangles = numpy.array(floor())
        for ranks in (1, 2):
            before = mesh() + GRAVITY + "dump sides all mesh/vtk 100 sides*.vtk stress\n"
            scene = Scene(spheres, (-0.6, -0.6, -0.01), (0.6, 0.6, 0.1), walls=WALL, before=before, thermo=SHOWN)
            done = self.run_scene(scene, 2e-4, 100, ranks=ranks, files={"sides.stl": stl(triangles)})
            corners, pressure = stresses(glob.glob(os.path.join(done.folder, "sides*100.vtk"))[0])
            a, b, c = corners[:, 0, :2], corners[:, 1, :2], corners[:, 2, :2]
            cross = lambda p, q: p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]  # noqa: E731
            area = 0.5 * abs(cross(b - a, c - a))
            sides = [cross(q - p, place - p) for p, q in ((a, b), (b, c), (c, a))]
            below = (numpy.sign(sides) == numpy.sign(sides[0])).all(axis=0)
            self.assertEqual(below.sum(), 1)
            # the file has six digits
            numpy.testing.assert_allclose(pressure * area, numpy.where(below, spheres.mass[0] * G, 0), atol=1e-4 * spheres.mass[0] * G)

    def test_a_moving_plate(self):
        """A plate that rises below four spheres gives them (1 + e) u each, on one rank and as it crosses from one to another."""
        speed, e, start, step = 1.0, 0.5, 10, 1e-3
        spheres = Spheres(2 * RADIUS, [[x, 0.01, z] for x, z in ((-0.03, 0.05), (-0.01, 0.06), (0.01, 0.08), (0.03, 0.04))])
        move = (f"variable zero equal 0.0\nvariable up equal {speed}*(step>={start})+{speed / start}*step*(step<{start})\n"
                "fix travel all move/mesh mesh sides linear/variable v_zero v_zero v_up\n")  # fmt: skip
        files = {"sides.stl": stl(square(4, (-0.05, -0.05, 0), (0.1, 0, 0), (0, 0.1, 0), seed=3))}
        for ranks in (1, 2):
            scene = Scene(spheres, (-0.5, -0.5, -0.01), (0.5, 0.5, 0.5), walls=WALL, before=mesh() + move, e=e, thermo=SHOWN)
            force, _ = self.shown(self.run_scene(scene, step, 150, ranks=ranks, files=files))
            # impulses of what touches one wall are in double precision; the mesh moves by numbers of ten digits
            numpy.testing.assert_allclose(step * force.sum(axis=0), [0, 0, -(1 + e) * speed * spheres.mass.sum()], atol=1e-9)

    def test_hanging_on(self):
        """A sphere that sticks to a ceiling pulls it by its weight, though it presses, too."""
        ceiling = square(5, (-0.5, -0.5, 0.05), (1, 0, 0), (0, 1, 0), seed=2)
        spheres = Spheres(2 * RADIUS, [[0.03, 0.04, 0.05 - RADIUS]])
        weight = spheres.mass[0] * G
        work = 3 * weight / (2 * numpy.pi * RADIUS)  # J/m2: three weights to part them
        scene = Scene(spheres, (-0.6, -0.6, -0.01), (0.6, 0.6, 0.1), walls=WALL, before=mesh() + GRAVITY, thermo=SHOWN, law="cohesive",
                      plugin=os.path.join("plugins", "liblaws.so"))  # fmt: skip
        scene.properties = {"workOfAdhesion": scene.matrix(work), "cohesionRange": scene.matrix(0.02 * RADIUS)}
        force, _ = self.shown(self.run_scene(scene, 2e-4, 100, files={"sides.stl": stl(ceiling)}))
        # passes in single precision
        numpy.testing.assert_allclose(force[50:], numpy.broadcast_to([0, 0, -weight], force[50:].shape), atol=1e-6 * weight)

    def test_wear_is_refused(self):
        scene = Scene(Spheres(2 * RADIUS, [[0, 0, 0.02]]), (-0.6, -0.6, -0.01), (0.6, 0.6, 0.1), walls=WALL, before=mesh(" wear finnie"))
        done = self.execute(scene, 1e-4, 3, files={"sides.stl": stl(floor())})
        self.assertNotEqual(done.code, 0)
        self.assertIn("mesh 'sides' asks for wear, which only wall/gran gives", done.text)


def stresses(path):
    """(corners [n, 3, 3], normal stress [n]) of a file of dump mesh/vtk, which gives each triangle points of its own."""
    with open(path, encoding="utf-8") as file:
        words = file.read().split()
    first, count = words.index("POINTS") + 3, int(words[words.index("POINTS") + 1])
    corners = numpy.array(words[first : first + 3 * count], float).reshape(-1, 3, 3)
    first = words.index("normal_stress_average") + 4
    return corners, numpy.array(words[first : first + count // 3], float)
