# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 900
"""A packing has its own solid fraction in every cell, whatever the mesh: at walls, where cells change size, in cells of any
shape, across cyclic pairs and on any number of ranks; walls and baffles part it from what is behind them.

The scenes are those of mesh_zoo.py: a step of the program with the default mapping, the voidage of every cell beside the
lattice's.
"""

import dataclasses
import tempfile
import unittest

import measured
import mesh_zoo
import numpy
import support
import zoo_meshes as meshes
import zoo_packings

ROUND_OFF = 1e-12  # of sums over tens of thousands of spheres

# What a regular packing may leave of its own pattern, which is not spread to nothing.
REGULAR = 0.02

SCENES = (
    "uniform", "refined", "thin", "graded", "cells_d", "cells_1.02d", "cells_half_d", "cells_5d", "tetrahedra",
    "prisms", "polyhedra", "small_polyhedra", "refined_twice", "spot", "o_grid", "snapped", "wedge", "cyclic_x",
    "cyclic_xy", "cyclic_xyz", "cyclic_refined", "own_neighbour", "two_across", "flat", "short_baffle", "two_sizes",
)  # fmt: skip


class Meshes(unittest.TestCase):
    def assert_even(self, out, tolerance):
        worst = out.compared[abs(out.deviation).argmax()]
        self.assertLess(abs(out.deviation).max(), tolerance, f"cell {worst} at {out.mesh.centre[worst]} m")
        self.assertLess(abs(out.total), ROUND_OFF)

    def test_every_cell_has_the_packings_solid_fraction(self):
        worst = {}
        for name in SCENES:
            with self.subTest(name):
                out = mesh_zoo.run(name)
                self.assert_even(out, REGULAR)
                worst[name] = abs(out.deviation).max()
        measured.below(self, f"face-centred packing on {len(SCENES)} meshes, cells of 0.5 to 5 d: largest deviation of a cell's solid fraction "
                       f"({max(worst, key=worst.get)})", 100 * max(worst.values()), 100 * REGULAR, "%", "the packing's")  # fmt: skip

    def test_a_baffle_parts_a_packed_from_an_empty_column(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                out = mesh_zoo.run("baffle", ranks)
                self.assert_even(out, REGULAR)
                measured.within(self, f"packed beside an empty column, a baffle between, ranks: {ranks}: solids that pass it", out.leaked, 0, 0)

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
        measured.within(self, "gas through a packing whose mesh is refined 2:1: pressure gradient across the refinement, over that beside it", flow.gradient, 1, 0.01,
                        "", "a uniform packing's")  # fmt: skip

    def test_a_cyclic_pair_within_the_mesh_is_not_there(self):
        even = mesh_zoo.SCENES["uniform"]().packing(None)
        random = numpy.random.default_rng(3)
        some = random.random(len(even.places)) < 0.5
        moved = even.places[some] + random.uniform(-0.2, 0.2, (some.sum(), 3)) * mesh_zoo.D
        uneven = dataclasses.replace(even, places=moved, diameters=even.diameters[some])
        whole, joined = (mesh_zoo.run(name, packing=lambda _: uneven) for name in ("uniform", "joined_baffle"))
        self.assertGreater(whole.solids.std(), 0.01)
        self.assertLess(abs(whole.solids - joined.solids).max(), ROUND_OFF)

    def test_spheres_beyond_the_facets_of_a_round_vessel_belong_to_it(self):
        """16 facets, 13.8 mm from the axis at their edges, 0.27 mm nearer in their middle; spheres of 0.4 mm along the round wall."""
        radius, diameter, height = 13.8e-3, 0.4e-3, 4e-3
        angle = numpy.linspace(0, 2 * numpy.pi, 200, endpoint=False)
        reach = radius - diameter / 2
        places = numpy.column_stack([reach * numpy.cos(angle), reach * numpy.sin(angle), numpy.full(200, height / 2)])
        beyond = (numpy.cos(angle % (numpy.pi / 8) - numpy.pi / 16) * reach > radius * numpy.cos(numpy.pi / 16)).sum()
        self.assertGreater(beyond, 50)
        packing = zoo_packings.Packing(places, numpy.full(200, diameter), 0.0)
        vessel = mesh_zoo.Scene("", lambda folder: meshes.o_grid(folder, radius, height, 4, 4, 2), lambda _: packing)
        for ranks in (1, 2, 4):
            with self.subTest(ranks=ranks), tempfile.TemporaryDirectory() as folder:
                mesh, _ = mesh_zoo.prepare(vessel, folder)
                if ranks > 1:
                    mesh_zoo.decompose(folder, mesh, ranks)
                done = support.execute(folder, ranks)
                self.assertEqual(done.code, 0, done.text)
                self.assertEqual(done.column("ledger/centres_beyond_edge")[-1], beyond)
                self.assertEqual(done.column("ledger/particles_outside_mesh")[-1], 0)
                found = mesh_zoo.solids(folder, mesh, ranks) @ mesh.volume
                self.assertLess(abs(found / (200 * zoo_packings.SPHERE * diameter**3) - 1), ROUND_OFF)

    def test_ranks_are_alike(self):
        for name in ("cyclic_refined", "small_tetrahedra", "spot", "own_neighbour", "polyhedra", "snapped"):
            alone = mesh_zoo.run(name)
            for ranks in (2, 4):
                with self.subTest(name, ranks=ranks):
                    out = mesh_zoo.run(name, ranks)
                    self.assertLess(abs(out.solids - alone.solids).max(), ROUND_OFF)
