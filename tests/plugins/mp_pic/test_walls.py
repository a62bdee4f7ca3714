# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 300
"""Off walls of each kind, planes, cylinders and triangle meshes, parcels come with -e_n of the velocity across and e_t of that
along the wall, from both sides; and they are where straight flight, impact and straight flight bring them.
"""

import glob
import os

import numpy

import boxes
import measured
import support
from triangles import square, stl

SIZE = (0.04, 0.04, 0.08)
DIAMETER, RADIUS = 2e-3, 1e-3
EN, ET = 0.7, 0.4
END = 0.02


def bounced(velocity, normal):
    across = (velocity * normal).sum(axis=1, keepdims=True) * normal
    return ET * (velocity - across) - EN * across


def after_impact(position, velocity, time, normal):
    """(positions, velocities) at END of what meets a wall of `normal` [n, 3] after `time` [n, 1]."""
    then = bounced(velocity, normal)
    return position + time * velocity + (END - time) * then, then


class Walls(support.ProgramTest):
    def fly(self, position, velocity, walls, step, files=(), after=""):
        """(positions, velocities) at END, without gas, gravity and stress."""
        box = boxes.Box(SIZE, (4, 4, 8), DIAMETER, 1000.0, position, velocity, en=EN, et=ET, walls=walls, step=step, end=END,
                        integrator="fix move all mp_pic stress off\n" + after, gas="model none;")  # fmt: skip
        folder = box.write(os.path.join(self.root, f"flight{len(os.listdir(self.root))}"))
        for name, text in files:
            support.write(os.path.join(folder, name), text)
        last = self.run_case(folder).last()
        return last["position"], last["velocity"]

    def off(self, found, expected):
        """Largest distances of positions [r] and velocities [m/s]."""
        return abs(found[0] - expected[0]).max() / RADIUS, abs(found[1] - expected[1]).max()

    def towards(self, middle, normal, seed, count=40):
        """Parcels on both sides of a plane that fly to within 6 mm of `middle` on it in 3 to 9 ms, at any angle up to 60 degrees."""
        draw = numpy.random.default_rng(seed)
        first = numpy.cross(normal, [0, 0, 1] if abs(normal[2]) < 0.9 else [1, 0, 0])
        first /= numpy.linalg.norm(first)
        along = numpy.stack([first, numpy.cross(normal, first)])
        side = numpy.where(numpy.arange(count) % 2, 1.0, -1.0)[:, None]
        target = middle + draw.uniform(-6e-3, 6e-3, (count, 2)) @ along + side * RADIUS * normal
        velocity = draw.uniform(-0.6, 0.6, (count, 2)) @ along - side * draw.uniform(0.4, 0.8, (count, 1)) * normal
        time = draw.uniform(3e-3, 9e-3, (count, 1))
        return target - time * velocity, velocity, time, side

    def test_planes(self):
        for axis, name in enumerate("xyz"):
            normal, middle = numpy.eye(3)[axis], numpy.array(SIZE) / 2
            position, velocity, time, side = self.towards(middle, normal, axis)
            found = self.fly(position, velocity, f"fix wall all wall/mp_pic primitive type 2 {name}plane {middle[axis]!r}\n", 1e-4)
            place, faster = self.off(found, after_impact(position, velocity, time, side * -normal))
            print(f"{name}plane: positions off by {place:.1e} r, velocities by {faster:.1e} m/s")
            self.assertLess(max(place, faster), 1e-9)  # round-off of 200 steps

    def test_triangles(self):
        """A tilted square, of 2 large and of 162 irregular triangles: as the plane that they make, edges and corners too."""
        normal, middle = numpy.array([2.0, -1, 3]) / numpy.sqrt(14), numpy.array(SIZE) / 2
        first = numpy.cross(normal, [0, 0, 1.0])
        along = 0.032 * first / numpy.linalg.norm(first)
        across = numpy.cross(normal, along)
        position, velocity, time, side = self.towards(middle, normal, 5)
        for cells, seed in ((1, None), (9, 4)):
            triangles = square(cells, middle - (along + across) / 2, along, across, seed)
            # into the middle of an edge, and into a corner where several triangles meet
            for k, target in enumerate((0.5 * (triangles[0][0] + triangles[0][2]), triangles[len(triangles) // 2][0])):
                if numpy.linalg.norm(target - middle) < 8e-3:
                    position[k] = target + side[k] * RADIUS * normal - time[k] * velocity[k]
            walls = "fix sides all mesh/surface file dem/sides.stl type 2\nfix wall all wall/mp_pic mesh n_meshes 1 meshes sides\n"
            found = self.fly(position, velocity, walls, 1e-4, [("dem/sides.stl", stl(triangles))])
            place, faster = self.off(found, after_impact(position, velocity, time, side * -normal))
            measured.below(self, f"MP-PIC: bounces off {len(triangles)} tilted triangles: position off the exact flight, radii", place, 1e-9, "", "e_n, e_t of the velocity")
            self.assertLess(faster, 1e-9)

    def test_a_plate_that_moves(self):
        """Parcels above and below a plate that rises at u: those that it meets leave with e_n times the speed at which they met, on top of u."""
        u, middle = 0.5, 0.02
        moved = ("fix sides all mesh/surface file dem/sides.stl type 2\n" + "fix rises all move/mesh mesh sides linear 0 0 {}\n".format(u)
                 + "fix wall all wall/mp_pic mesh n_meshes 1 meshes sides\n")  # fmt: skip
        draw = numpy.random.default_rng(6)
        time = draw.uniform(2e-3, 0.6 * END, 40)
        velocity = draw.uniform(-0.5, 0.5, (40, 3)) * (0.3, 0.3, 1)
        above = velocity[:, 2] < u
        place = numpy.column_stack([numpy.full((40, 2), SIZE[0] / 2) + draw.uniform(-6e-3, 6e-3, (40, 2)), middle + u * time + numpy.where(above, RADIUS, -RADIUS)])
        start = place - time[:, None] * velocity
        ahead = velocity - (0, 0, u)
        after = numpy.column_stack([ET * velocity[:, :2], u - EN * ahead[:, 2]])
        expected = place + (END - time)[:, None] * after, after
        for order in (1, -1):  # the mesh moves before the parcels, or after them
            lines = moved.splitlines(keepends=True)
            box_walls = "".join(lines if order == 1 else lines[:1] + lines[2:])
            for step in (1e-4, 5e-4):
                found = self.fly(start, velocity, box_walls, step, [("dem/sides.stl", stl(square(3, (0.0, 0.0, middle), (0.04, 0, 0), (0, 0.04, 0), 1)))],
                                 after="" if order == 1 else lines[1])  # fmt: skip
                place_off, faster = self.off(found, expected)
                print(f"a plate that moves {'before' if order == 1 else 'after'} the parcels, step {step:g} s: positions off by {place_off:.1e} r, velocities {faster:.1e} m/s")
                # the plate stands still in the first step, for which LIGGGHTS tells no velocity
                self.assertLess(faster, 1e-9)
                self.assertLess(place_off, 1e-9)

    def test_what_the_plate_feels(self):
        """A mesh of style mesh/surface/stress shows the momentum that parcels lose to it, and the torque of that about a point."""
        normal, middle = numpy.array([0, 0, 1.0]), numpy.array(SIZE) / 2
        position, velocity, time, side = self.towards(middle, normal, 3)
        about, step = numpy.array([0.01, 0.03, 0.02]), 1e-4
        walls = ("fix sides all mesh/surface/stress file dem/sides.stl type 2 reference_point {} {} {}\n".format(*about)
                 + "fix wall all wall/mp_pic mesh n_meshes 1 meshes sides\n"
                 + "fix shown all ave/time 1 1 1 " + " ".join(f"f_sides[{k}]" for k in range(1, 7)) + " file felt\n")  # fmt: skip
        plate = square(3, (0.0, 0.0, middle[2]), (SIZE[0], 0, 0), (0, SIZE[1], 0), 1)
        found = self.fly(position, velocity, walls, step, [("dem/sides.stl", stl(plate))])
        felt = numpy.loadtxt(sorted(glob.glob(os.path.join(self.root, "flight*", "felt")))[-1], comments="#")[:, 1:]
        mass = 1000 * numpy.pi / 6 * DIAMETER**3
        impulse = -mass * (found[1] - velocity)
        where = position + time * velocity - side * RADIUS * normal  # of contact
        expected = numpy.concatenate([impulse.sum(axis=0), numpy.cross(where - about, impulse).sum(axis=0)])
        off = abs(step * felt.sum(axis=0) - expected) / abs(impulse).sum() / ([1] * 3 + [RADIUS] * 3)
        print(f"impulse and torque on the plate off by {off.max():.1e} of all impulses (and a radius)")
        # ave/time writes six digits; contacts are placed at the end of the part of a step, up to 0.08 radii off
        self.assertLess(off[:3].max(), 1e-4)
        self.assertLess(off[3:].max(), 0.02)

    def round_the_axis(self, axis, big, inside, seed):
        """Parcels that meet a cylinder once before END; (position, velocity, time of impact, normal to the wall)."""
        draw = numpy.random.default_rng(seed)
        count, reach = 400, big - RADIUS if inside else big + RADIUS
        angle, far = draw.uniform(0, 2 * numpy.pi, count), draw.uniform(0.2, 0.6, count) * reach if inside else draw.uniform(1.5, 2.2, count) * reach
        flat = far[:, None] * numpy.column_stack([numpy.cos(angle), numpy.sin(angle)])
        speed = draw.uniform(-1, 1, (count, 2))

        def meeting(x, v):
            """When |x + v t| comes to `reach`, from the side where the parcels are; infinite: never."""
            a, b, c = (v**2).sum(axis=1), (x * v).sum(axis=1), (x**2).sum(axis=1) - reach**2
            root = numpy.sqrt(numpy.maximum(b**2 - a * c, 0))
            time = (-b + root if inside else -b - root) / a
            return numpy.where((b**2 > a * c) & (time > 1e-9), time, numpy.inf)

        time = meeting(flat, speed)
        hit = flat + numpy.minimum(time, END)[:, None] * speed
        outwards = hit / numpy.linalg.norm(hit, axis=1, keepdims=True)
        again = meeting(hit, bounced(speed, outwards)) if inside else numpy.full(count, numpy.inf)
        # no grazing: what misses by the length of a step is another flight
        steep = abs((speed * outwards).sum(axis=1)) > 0.3 * numpy.linalg.norm(speed, axis=1)
        chosen = numpy.flatnonzero((time > 1e-3) & (time < 0.9 * END) & (time + again > 1.1 * END) & steep)[:40]
        self.assertEqual(len(chosen), 40)
        place, velocity, normal = (numpy.zeros((40, 3)) for _ in range(3))
        others = [(axis + 1) % 3, (axis + 2) % 3]
        place[:, others], velocity[:, others], normal[:, others] = flat[chosen], speed[chosen], outwards[chosen] * (1 if inside else -1)
        velocity[:, axis] = draw.uniform(-0.5, 0.5, 40)
        return place + numpy.array(SIZE) / 2, velocity, time[chosen][:, None], normal

    def test_cylinders(self):
        """Inside and outside, along each axis. The wall is straight over a part of a step: first order in it."""
        for axis, name in enumerate("xyz"):
            for inside, big in ((True, 0.018), (False, 0.006)):
                position, velocity, time, normal = self.round_the_axis(axis, big, inside, 10 + axis)
                middle = numpy.array(SIZE) / 2
                at = f"{middle[(axis + 1) % 3]!r} {middle[(axis + 2) % 3]!r}"
                expected = after_impact(position, velocity, time, normal)
                errors = []
                for step in (1e-4, 1e-5):
                    found = self.fly(position, velocity, f"fix wall all wall/mp_pic primitive type 2 {name}cylinder {big} {at}\n", step)
                    place, faster = self.off(found, expected)
                    errors.append(faster)
                    print(f"{name}cylinder from {'inside' if inside else 'outside'}, step {step:g} s: positions off by {place:.1e} r, "
                          f"velocities by {faster:.1e} m/s")  # fmt: skip
                    # the normal is one of up to a step later, off by v dt/(R -+ r), and with it 1 + e_n of v; v^2 is below 2
                    self.assertLess(faster, (1 + EN) * 2 * step / (big - RADIUS))
                    self.assertLess(place * RADIUS, END * faster + 1e-9)
                self.assertLess(errors[1], 0.3 * errors[0])
