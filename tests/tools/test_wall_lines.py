# SPDX-License-Identifier: GPL-3.0-or-later
"""The walls of the particles, by LIGGGHTS's log: planes, cylinders, meshes at rest and moving, and the lines that they are from the front."""

import os
import shutil
import struct
import sys
import tempfile
import unittest

import numpy

from interphase import script_walls
from interphase.stl import read_stl, revolved, write_stl
from interphase.wall_lines import Walls, edges_of, section_of

VIEW = (-1.0, 1.0, 0.0, 2.0)
CYLINDER = revolved(numpy.array([(0.5, 0.0), (0.5, 1.0)]), 64)
BLADE = numpy.array([[(0, 0, 0), (1, 0, 0), (1, 0, 1)], [(0, 0, 0), (1, 0, 1), (0, 0, 1)]], dtype=float)


class Log(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="interphase-walls-")
        self.addCleanup(shutil.rmtree, self.folder)
        os.mkdir(os.path.join(self.folder, "dem"))

    def walls(self, log):
        with open(os.path.join(self.folder, "dem/log.liggghts"), "w", encoding="ascii") as file:
            file.write(log)
        return script_walls.read(self.folder)

    def stl(self, name, triangles):
        write_stl(os.path.join(self.folder, "dem", name), {"surface": triangles})

    def test_the_line_with_all_values_counts(self):
        found = self.walls("fix left all wall/tdhs primitive type 2 xplane ${left}\nfix left all wall/tdhs primitive type 2 xplane -0.25\n"
                           "fix tube all wall/gran model hooke primitive type 2 ycylinder 0.1 0.2 &\n 0.7\nfix gone all wall/tdhs primitive type 2 zplane 0\n"
                           "unfix gone\n")  # fmt: skip
        self.assertEqual([(each.style, each.numbers) for each in found.primitives], [("xplane", (-0.25,)), ("ycylinder", (0.1, 0.2, 0.7))])
        lines = Walls(found, [], (0.0, 1.0)).lines(0.0, VIEW)
        numpy.testing.assert_allclose(lines[0].segments, [[(-0.25, 0), (-0.25, 2)]])
        numpy.testing.assert_allclose(numpy.linalg.norm(lines[1].segments - (0.2, 0.7), axis=2), 0.1)

    def test_an_upright_cylinder_is_two_lines(self):
        found = self.walls("fix tube all wall/gran primitive type 2 zcylinder 0.5 0.1 0.5\n")
        (line,) = Walls(found, [], (0.0, 1.0)).lines(0.0, VIEW)
        numpy.testing.assert_allclose(sorted(line.segments[:, 0, 0]), [-0.4, 0.6], atol=1e-6)

    def test_meshes_that_particles_meet_and_that_let_them_in(self):
        self.stl("vessel.stl", CYLINDER)
        self.stl("face.stl", BLADE)
        found = self.walls("fix vessel all mesh/surface file dem/vessel.stl type 2 scale 2\nfix face all mesh/surface/planar file dem/face.stl type 2\n"
                           "fix w all wall/tdhs mesh n_meshes 1 meshes vessel\n")  # fmt: skip
        vessel, face = found.surfaces
        self.assertTrue(vessel.wall)
        self.assertFalse(face.wall)
        self.assertAlmostEqual(abs(vessel.triangles[:, :, 0]).max(), 1.0)
        self.assertEqual({each.kind for each in Walls(found, [], (-1.0, 1.0)).lines(0.0, VIEW)}, {"solid", "solid edge", "passage"})

    def test_a_blade_that_turns_and_a_plate_that_rises(self):
        self.stl("blade.stl", BLADE)
        words = "fix blade all mesh/surface file dem/blade.stl type 2\nfix w all wall/gran mesh n_meshes 1 meshes blade\n"
        turning = self.walls(words + "fix turn all move/mesh mesh blade rotate origin 0. 0. 0. axis 0. 0. 1. period 0.4\n").surfaces[0]
        tip = turning.at(0.1).reshape(-1, 3)[2]  # a quarter of a turn, anticlockwise from above: x comes to y
        numpy.testing.assert_allclose(tip, (0, 1, 1), atol=1e-12)
        rising = self.walls(words + "fix rise all move/mesh mesh blade linear 0. 0. 2.\n").surfaces[0]
        numpy.testing.assert_allclose(rising.at(0.25) - BLADE, numpy.broadcast_to((0, 0, 0.5), BLADE.shape))

    def test_what_is_not_understood_is_said(self):
        self.stl("blade.stl", BLADE)
        words = "fix blade all mesh/surface file dem/blade.stl type 2{}\n"
        found = self.walls(words.format("") + "fix m all move/mesh mesh blade linear/variable v_x v_y v_z\n")
        self.assertRegex(found.notes[0], "blade moves .*linear/variable.*: drawn where it starts")
        numpy.testing.assert_array_equal(found.surfaces[0].at(3.0), BLADE)
        self.assertRegex(self.walls(words.format(" move 0 0 1 scale 2")).notes[0], "blade is not drawn: placed by scale and move")
        self.assertRegex(self.walls("fix b all mesh/surface file dem/none.stl type 2\n").notes[0], "b is not drawn: .*none.stl: cannot be read")
        self.assertRegex(self.walls("fix b all wall/region ball harmonic 1.0 1.0 2.5\n").notes[0], "wall b is not drawn: wall/region ball")
        self.assertRegex(self.walls("fix b all wall/gran primitive type 2 cone 1 2\n").notes[0], "wall b is not drawn: primitive type 2 cone 1 2")

    def test_binary_files(self):
        path = os.path.join(self.folder, "b.stl")
        with open(path, "wb") as file:
            file.write(b"solid as some begin".ljust(80) + struct.pack("<I", len(BLADE)))
            file.writelines(struct.pack("<12fH", 0, 0, 0, *triangle.ravel(), 0) for triangle in BLADE)
        numpy.testing.assert_array_equal(read_stl(path), BLADE)


class Lines(unittest.TestCase):
    def test_a_tube_is_cut_in_its_outline(self):
        cut = section_of(CYLINDER, 1e-4)
        numpy.testing.assert_allclose(abs(cut[:, :, 0]), 0.5, atol=2e-3)  # 64 corners: a facet's middle is 0.1 % nearer to the axis
        self.assertAlmostEqual(abs(cut[:, 1, 1] - cut[:, 0, 1]).sum(), 2.0)

    def test_edges_are_rims_and_outline_but_not_facets(self):
        edges = edges_of(CYLINDER)
        level = edges[:, 0, 1] == edges[:, 1, 1]
        self.assertEqual(level.sum(), 2 * 64)
        upright = edges[~level]
        numpy.testing.assert_allclose(abs(upright[:, :, 0]), 0.5, atol=2e-3)
        self.assertEqual(len(upright), 2)

    def test_a_blade_in_the_plane_of_the_cut_is_seen_by_its_edges(self):
        self.assertEqual(len(section_of(BLADE, 0.0)), 0)
        self.assertEqual(len(edges_of(BLADE)), 4)


if __name__ == "__main__":
    sys.exit(unittest.main())
