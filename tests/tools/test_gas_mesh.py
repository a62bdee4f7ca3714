# SPDX-License-Identifier: GPL-3.0-or-later
"""What an upright plane cuts of a mesh of the gas: cells to their area, walls where they are, in any format, whole or in pieces."""

import dataclasses
import os
import shutil
import sys
import tempfile
import unittest

import numpy

from block_of_cells import write_field, write_mesh
from interphase import gas_mesh
from interphase.gas_section import GasSections
from interphase.input_error import InputError

SIZE, CELLS = (0.4, 0.2, 0.6), (8, 2, 12)


def area(polygon):
    x, z = polygon[:, 0], polygon[:, 1]
    return 0.5 * abs(numpy.dot(x, numpy.roll(z, -1)) - numpy.dot(z, numpy.roll(x, -1)))


def tube(centre):
    """A block of 2 x 2 cells across the vessel, from x = 0.15 to 0.25 and z = 0.25 to 0.35."""
    return abs(centre[0] - 0.2) < 0.05 and abs(centre[2] - 0.3) < 0.05


class Cut(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="interphase-mesh-")
        self.addCleanup(shutil.rmtree, self.folder)

    def mesh(self, **options):
        self.centres = write_mesh(self.folder, SIZE, CELLS, **options)
        return gas_mesh.read(self.folder)

    def test_the_cells_fill_the_plane_but_for_a_tube(self):
        for binary in (False, True):
            mesh = self.mesh(left_out=tube, binary=binary)
            for y in (0.05, 0.1, 0.15001):  # in a layer of cells, in a layer of corners, and elsewhere
                cells, polygons = gas_mesh.polygons(mesh, gas_mesh.cut(mesh, y))
                self.assertEqual(len(cells), 8 * 12 - 4)
                self.assertAlmostEqual(sum(map(area, polygons)), 0.4 * 0.6 - 0.1 * 0.1, places=12)
                numpy.testing.assert_allclose([p.mean(axis=0) for p in polygons], self.centres[cells][:, (0, 2)], atol=1e-12)

    def test_volumes_of_boxes_and_of_cells_that_lean(self):
        mesh = self.mesh(left_out=tube)
        box = numpy.prod(numpy.divide(SIZE, CELLS))
        numpy.testing.assert_allclose(mesh.volumes, box, rtol=1e-12)
        # a shear keeps volumes, and moves the mesh off the origin
        leaning = dataclasses.replace(mesh, points=mesh.points @ numpy.array([[1, 0, 0], [0.3, 1, 0], [0.5, -0.2, 1]]) + 7.0)
        numpy.testing.assert_allclose(leaning.volumes, box, rtol=1e-9)

    def test_walls_and_where_gas_passes(self):
        mesh = self.mesh(left_out=tube)
        lines = gas_mesh.boundary(mesh, gas_mesh.cut(mesh, 0.05))
        length = {kind: numpy.linalg.norm(each[:, 1] - each[:, 0], axis=1).sum() for kind, each in lines.items()}
        self.assertAlmostEqual(length["wall"], 2 * 0.6 + 4 * 0.1)  # the sides and the tube
        self.assertAlmostEqual(length["open"], 2 * 0.4)
        self.assertEqual(set(lines["open"][:, :, 1].ravel()), {0.0, 0.6})

    def test_a_patch_that_is_closed_by_its_condition_is_a_wall(self):
        mesh = self.mesh()
        write_field(self.folder, "0.1", "U", numpy.zeros((len(self.centres), 3)))
        path = os.path.join(self.folder, "0.1", "U")
        with open(path, "a", encoding="ascii") as file:
            file.write("boundaryField\n{\n    inlet\n    {\n        type            slip;\n    }\n}\n")
        closed = gas_mesh.closed_patches(self.folder)
        self.assertEqual(closed, ("inlet",))
        lines = gas_mesh.boundary(mesh, gas_mesh.cut(mesh, 0.05), closed)
        self.assertEqual(set(lines["open"][:, :, 1].ravel()), {0.6})

    def test_a_field_in_the_plane_whole_and_in_pieces(self):
        whole = tempfile.mkdtemp(prefix="interphase-mesh-")
        self.addCleanup(shutil.rmtree, whole)
        centres = write_mesh(whole, SIZE, CELLS)
        write_field(whole, "0.5", "voidage", centres[:, 0], binary=True)
        for rank, here in enumerate((lambda c: c[2] < 0.3, lambda c: c[2] > 0.3)):
            part = os.path.join(self.folder, f"processor{rank}")
            centres = write_mesh(part, SIZE, CELLS, left_out=lambda c, here=here: not here(c))
            write_field(part, "0.5", "voidage", centres[:, 0])
        for folder in (whole, self.folder):
            section = GasSections(folder, 0.1).nearest("voidage", 0.47)
            self.assertEqual((section.time, len(section.values)), (0.5, 8 * 12))
            numpy.testing.assert_allclose(section.values, section.middles[:, 0], atol=1e-12)
            self.assertAlmostEqual(sum(map(area, section.polygons)), 0.4 * 0.6, places=12)

    def test_what_is_not_there_is_said(self):
        self.mesh()
        with self.assertRaisesRegex(InputError, "no voidage of the gas was written; writeInterval"):
            GasSections(self.folder, 0.1).nearest("voidage", 0.0)
        os.mkdir(os.path.join(self.folder, "processors2"))
        with self.assertRaisesRegex(InputError, "in the pieces of its ranks, collated: reconstructPar"):
            GasSections(self.folder, 0.1).nearest("voidage", 0.0)
        write_field(self.folder, "0.5", "voidage", [0.5, 0.6])
        with self.assertRaisesRegex(InputError, "2 values, and the mesh .* has 192 cells"):
            GasSections(self.folder, 0.1).nearest("voidage", 0.5)

    def test_a_time_that_is_still_being_written_is_left_out(self):
        self.mesh()
        for time in ("0.5", "0.6"):
            write_field(self.folder, time, "voidage", self.centres[:, 0])
        path = os.path.join(self.folder, "0.6", "voidage")
        os.truncate(path, os.path.getsize(path) // 2)
        self.assertEqual(GasSections(self.folder, 0.1).nearest("voidage", 0.6).time, 0.5)


if __name__ == "__main__":
    sys.exit(unittest.main())
