# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 600
"""The templates of tools/new-plugin at walls and meshes; what they remember; what they refuse."""

import os

import numpy
import triangles

from contact_scenes import FIXES, FLOOR, GRAVITY, KEPT, PLAIN, ContactTest, scene, sphere, vectors

MESH = "fix mesh all mesh/surface file floor.stl type 1\nfix floor all wall/{plugin} mesh n_meshes 1 meshes mesh\n"


class Walls(ContactTest):
    def test_a_mesh_is_a_plane(self):
        """A sphere that bounces and slides over 50 triangles moves as over the plane: at their edges it forgets nothing."""
        with open(os.path.join(self.root, "floor.stl"), "w", encoding="utf-8") as file:
            file.write(triangles.stl(triangles.square(5, (0, 0, 0), (0.1, 0, 0), (0, 0.1, 0), seed=1)))
        lines = sphere(1, 0.004, (0.013, 0.02, 0.0041), (0.4, 0.27, -0.1))
        for plugin in (PLAIN, KEPT):
            for ranks in (1, 2):
                plane, mesh = [self.states(plugin, scene(plugin, lines, GRAVITY + wall + "run 15000\n", 15000), ranks)[-1] for wall in (FLOOR, MESH)]
                self.assertGreater(plane["x"][0], 0.05)
                # the nearest point of a triangle is rounded to 1e-17 m, and the stiffness makes 1e-14 N of it
                for name in ("x", "v"):
                    numpy.testing.assert_allclose(vectors(mesh, name), vectors(plane, name), rtol=0, atol=1e-9)

    def test_a_cylinder_and_materials(self):
        """Restitution is that between the sphere's and the wall's material."""
        for kind, restitution in ((1, 0.7), (2, 0.9)):
            wall = f"fix tube all wall/{{plugin}} primitive type {kind} zcylinder 0.03 0.05 0.05\n"
            states = self.states(PLAIN, scene(PLAIN, sphere(1, 0.004, (0.07, 0.05, 0.05), (1, 0, 0), kind=kind), wall + "run 4000\n", 4000))
            self.assertAlmostEqual(states[-1]["vx"][0], -restitution, delta=0.01)  # a collision has 160 steps


    def test_what_a_mesh_feels(self):
        """A mesh of style mesh/surface/stress shows the forces on it, wherever its wall stands in the script; on two ranks, too."""
        with open(os.path.join(self.root, "floor.stl"), "w", encoding="utf-8") as file:
            file.write(triangles.stl(triangles.square(5, (0, 0, 0), (0.1, 0, 0), (0, 0.1, 0), seed=1)))
        lines = sphere(1, 0.004, (0.03, 0.02, 0.008), (0.3, 0.2, -0.4)) + sphere(2, 0.003, (0.07, 0.06, 0.008), (-0.2, 0.1, -0.3))
        mesh = MESH.replace("mesh/surface file", "mesh/surface/stress file").splitlines(keepends=True)
        shown = "fix shown all ave/time 1 1 1 f_mesh[1] f_mesh[2] f_mesh[3] file felt\n"
        for plugin in (PLAIN, KEPT):
            for ranks, fixes, after in ((1, FIXES, "".join(mesh)), (1, "".join(mesh).replace("{plugin}", plugin) + FIXES, ""), (2, FIXES, "".join(mesh))):
                script = scene(plugin, lines, after + GRAVITY + shown + "run 2000\n", 2000, fixes=fixes)
                first, end = self.states(plugin, script, ranks)
                felt = numpy.loadtxt(os.path.join(self.root, "felt"), comments="#")[:, 1:]
                mass = first["mass"][:, None]
                lost = (mass * (vectors(first) - vectors(end))).sum(axis=0) - [0, 0, 9.81 * mass.sum() * 2000e-5]
                # ave/time writes six digits
                numpy.testing.assert_allclose(1e-5 * felt.sum(axis=0), lost, atol=1e-4 * abs(lost).max())


class MovingWalls(ContactTest):
    def write_floor(self):
        with open(os.path.join(self.root, "floor.stl"), "w", encoding="utf-8") as file:
            file.write(triangles.stl(triangles.square(3, (0, 0, 0), (0.1, 0, 0), (0, 0.1, 0), seed=2)))

    def test_a_floor_that_rises(self):
        """At u it meets a sphere at rest, which leaves with (1 + e) u."""
        self.write_floor()
        rises = MESH.replace("fix floor", "fix lift all move/mesh mesh mesh linear 0.0 0.0 0.5\nfix floor")
        for plugin in (PLAIN, KEPT):
            for ranks in (1, 2):
                end = self.states(plugin, scene(plugin, sphere(1, 0.004, (0.04, 0.05, 0.01)), rises + "run 6000\n", 6000), ranks)[-1]
                self.assertAlmostEqual(end["vz"][0], 1.7 * 0.5, delta=0.01)  # a collision has 160 steps
                self.assertAlmostEqual(end["vx"][0], 0, delta=1e-12)

    def test_a_belt(self):
        """It drags a sphere by mu g until that rolls with 2/7 of its speed."""
        self.write_floor()
        belt = MESH.replace("type 1", "type 1 surface_vel 0.2 0 0") + GRAVITY
        until = round(2 / 7 * 0.2 / (0.3 * 9.81) / 1e-5)
        for plugin in (PLAIN, KEPT):
            lines = sphere(1, 0.004, (0.02, 0.05, 0.004 - 2000 * 4 / 3 * 3.14159265 * 0.004**3 * 9.81 / 1000))  # as deep as its weight presses it
            half, *_, end = self.states(plugin, scene(plugin, lines, belt + f"run {4 * until}\n", until // 2))[1:]
            self.assertAlmostEqual(half["vx"][0] / (0.3 * 9.81 * (until // 2) * 1e-5), 1, delta=0.02)  # friction sets in within a few steps, or as its spring stretches
            self.assertAlmostEqual(end["vx"][0] / (2 / 7 * 0.2), 1, delta=0.02)


class Restart(ContactTest):
    def test_native_restart(self):
        """A heap that friction's springs hold, stopped, read from LIGGGHTS's restart file and taken further: as one that went on, to the last
        bit, and unlike one that forgot its contacts."""
        draw = numpy.random.default_rng(5)
        lines = "".join(sphere(1 + 4 * i + j, 0.004, (0.03 + 0.0082 * i + draw.uniform(0, 2e-4), 0.05, 0.0041 + 0.0079 * j), kind=1 + j % 2)
                        for i in range(5) for j in range(4))  # fmt: skip
        tilted = "fix gravity all gravity 9.81 vector 0.2 0.0 -1.0\nfix stop all wall/{plugin} primitive type 1 xplane 0.085\n" + FLOOR
        for ranks in (1, 2):
            first = scene(KEPT, lines, tilted + "run 5000\nwrite_restart kept\nrun 2000\n", 7000)
            whole = self.states(KEPT, first, ranks)[-1]
            ends = {}
            for fix_id in ("push", "other"):  # LIGGGHTS gives what a file holds to the fix of the same id and style
                fixes = FIXES.replace("fix push", f"fix {fix_id}")
                second = scene(KEPT, "", tilted + "run 2000\n", 7000, domain="read_restart kept\n", fixes=fixes)
                ends[fix_id] = self.states(KEPT, second, ranks)[-1]
            for name in ("x", "v", "omega"):
                numpy.testing.assert_array_equal(vectors(ends["push"], name), vectors(whole, name))
            self.assertGreater(numpy.abs(vectors(ends["other"], "v") - vectors(whole, "v")).max(), 1e-6)


class Refusals(ContactTest):
    ONE = sphere(1, 0.004, (0.05, 0.05, 0.05))

    def test_materials(self):
        for good, bad, words in (
            ("2 1000 500 500 2000", "2 1000 -500 -500 2000", ("property/global kn is -500", "between types 1 and 2", "0 or more")),
            ("2 1000 500 500 2000", "2 1000 0 0 2000", ("kn is 0.000000 between types 1 and 2", "give numbers above 0 N/m")),
            ("2 0.7 0.8 0.8 0.9", "2 0.7 0.8 0.8 1.5", ("coefficientRestitution is 1.5", "between types 2 and 2", "up to 1")),
            ("fix mu all property/global coefficientFriction peratomtypepair 2 0.3 0.4 0.4 0.5\n", "",
             ("does not say the coefficientFriction", "peratomtypepair 2 ...`, 4 numbers")),
        ):  # fmt: skip
            self.assertIn(good, FIXES)
            for ranks in (1, 2):
                with self.subTest(bad, ranks=ranks):
                    self.refused(scene(PLAIN, self.ONE, "run 1\n", fixes=FIXES.replace(good, bad)), *words, ranks=ranks)

    def test_words_and_company(self):
        self.refused(scene(PLAIN, self.ONE, "run 1\n", fixes=FIXES.replace("/spheres", "/spheres stiffness 3")), "'stiffness' is not known here")
        self.refused(scene(PLAIN, self.ONE, "run 1\n").replace("single vel yes", "single vel no"), "give `communicate single vel yes`")
        self.refused(scene(PLAIN, self.ONE, FLOOR + "unfix push\nrun 1\n"), "Fix floor wall/plain_contacts: no fix heeds this wall")
        self.refused(scene(PLAIN, self.ONE, FLOOR.replace("type 1", "type 3")), "type 3 is none of the 2 types")

    def test_spheres_that_no_force_can_part(self):
        self.refused(scene(PLAIN, self.ONE + sphere(2, 0.003, (0.05, 0.05, 0.05)), "run 1\n"), "spheres 1 and 2 have the same centre", "Take one of them away")

    def test_a_law_without_an_answer(self):
        touching = self.ONE + sphere(2, 0.004, (0.0579, 0.05, 0.05))
        self.refused(scene("nan_contacts", touching, "run 100\n"), "nan_contacts/spheres: the law answers a force of (", "on sphere 1, at an overlap of 0.0001",
                     "with sphere 2", "Look for a division by 0", plugin="nan_contacts")  # fmt: skip
