#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 900
"""A packing has its own solid fraction in every cell, whatever the mesh: at walls, where cells change size, in cells of any
shape, across cyclic pairs and on any number of ranks; walls and baffles part it from what is behind them.

The scenes are those of mesh_zoo.py: a step of the program with the default mapping, the voidage of every cell beside the
lattice's.
"""

import dataclasses
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import mesh_zoo  # noqa: E402
import numpy  # noqa: E402
import support  # noqa: E402

ROUND_OFF = 1e-12  # of sums over tens of thousands of spheres

# What a regular packing may leave of its own pattern, which is not spread to nothing.
REGULAR = 0.02
# Cells with more than three faces at a corner have kinks in their weights, which follow the pattern of spheres as large as
# the cells.
KINKS = 0.04

SCENES = {
    "uniform": REGULAR, "refined": REGULAR, "thin": REGULAR, "graded": REGULAR, "cells_d": REGULAR, "cells_1.02d": REGULAR,
    "cells_half_d": REGULAR, "cells_5d": REGULAR, "tetrahedra": REGULAR, "prisms": REGULAR, "polyhedra": KINKS,
    "small_polyhedra": KINKS, "refined_twice": KINKS, "spot": KINKS, "o_grid": REGULAR, "snapped": REGULAR, "wedge": REGULAR,
    "cyclic_x": REGULAR, "cyclic_xy": REGULAR, "cyclic_xyz": REGULAR, "cyclic_refined": REGULAR, "own_neighbour": REGULAR,
    "two_across": REGULAR, "flat": REGULAR, "short_baffle": REGULAR, "two_sizes": REGULAR,
}  # fmt: skip


class Meshes(unittest.TestCase):
    def assert_even(self, out, tolerance):
        worst = out.compared[abs(out.deviation).argmax()]
        self.assertLess(abs(out.deviation).max(), tolerance, f"cell {worst} at {out.mesh.centre[worst]} m")
        self.assertLess(abs(out.total), ROUND_OFF)

    def test_every_cell_has_the_packings_solid_fraction(self):
        for name, tolerance in SCENES.items():
            with self.subTest(name):
                self.assert_even(mesh_zoo.run(name), tolerance)

    def test_a_baffle_parts_a_packed_from_an_empty_column(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                out = mesh_zoo.run("baffle", ranks)
                self.assert_even(out, REGULAR)
                self.assertEqual(out.leaked, 0)

    def test_a_large_sphere_in_the_gas_changes_neither_the_bed_nor_the_gas_far_from_it(self):
        out = mesh_zoo.run("large_sphere")
        self.assert_even(out, REGULAR)
        # 12 d below a sphere of 5 d its kernel, 10 d wide at half height, has fallen to 2^-23 and is spread over 12 d across
        self.assertLess(out.leaked, 1e-4)

    def test_gas_flows_through_a_refinement_as_if_it_were_not_there(self):
        flow = mesh_zoo.flow_through_refinement()
        near = abs(flow.height) < 3
        # what is left of the lattice's pattern at the refinement
        numpy.testing.assert_allclose(flow.voidage[near], 0.42, rtol=0.01)
        numpy.testing.assert_allclose(flow.superficial[near], 1.05, rtol=0.01)
        self.assertAlmostEqual(flow.gradient, 1, delta=0.01)

    def test_a_cyclic_pair_within_the_mesh_is_not_there(self):
        even = mesh_zoo.SCENES["uniform"]().packing(None)
        random = numpy.random.default_rng(3)
        some = random.random(len(even.places)) < 0.5
        moved = even.places[some] + random.uniform(-0.2, 0.2, (some.sum(), 3)) * mesh_zoo.D
        uneven = dataclasses.replace(even, places=moved, diameters=even.diameters[some])
        whole, joined = (mesh_zoo.run(name, packing=lambda _: uneven) for name in ("uniform", "joined_baffle"))
        self.assertGreater(whole.solids.std(), 0.01)
        self.assertLess(abs(whole.solids - joined.solids).max(), ROUND_OFF)

    def test_ranks_are_alike(self):
        for name in ("cyclic_refined", "small_tetrahedra", "spot", "own_neighbour"):
            alone = mesh_zoo.run(name)
            for ranks in (2, 4):
                with self.subTest(name, ranks=ranks):
                    out = mesh_zoo.run(name, ranks)
                    self.assertLess(abs(out.solids - alone.solids).max(), ROUND_OFF)


if __name__ == "__main__":
    unittest.main()
