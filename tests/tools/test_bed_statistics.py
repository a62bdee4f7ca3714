# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocities, granular temperatures, overlaps and voidages of a snapshot are those that made-up beds were made with: uniform flow, two
temperatures, spheres of known overlap, a lattice of known packing."""

import unittest

import numpy

from interphase import bed_statistics
from interphase.particle_states import Box
from interphase.box_mesh import BoxMesh
from interphase.report_scene import Windows
from made_up import scattered

# A vessel of 0.2 x 0.1 x 0.4 m; windows are 0.1 m wide, z from 0.1 to 0.2 m, the slice 0.01 m deep.
WINDOWS = Windows(count=2, left=0.0, right=0.2, centre=0.15, height=0.1, front=0.0, front_depth=0.01)
MESH = BoxMesh((0.0, 0.0, 0.0), (0.2, 0.1, 0.4), (4, 2, 8))
SIZE = (0.2, 0.1, 0.4)


class Velocity(unittest.TestCase):
    def moments(self, position, velocity):
        """Of single particles: number, sums and temperatures."""
        number, real, sums, temperatures = bed_statistics.window_moments(position, velocity, numpy.ones(len(position)), WINDOWS, False)
        numpy.testing.assert_array_equal(real, number)
        return number, sums, temperatures

    def test_uniform_flow_has_its_velocity_everywhere_and_no_temperature(self):
        position = scattered(5000, SIZE)
        number, sums, temperatures = self.moments(position, numpy.tile([0.3, 9.0, -0.7], (5000, 1)))
        numpy.testing.assert_allclose(sums / number[:, None], [[0.3, -0.7]] * 2, rtol=1e-12)
        numpy.testing.assert_allclose(temperatures, 0, atol=1e-25)

    def test_two_temperatures(self):
        """Half of each window's spheres move at u + a, half at u - a: Theta is a^2, in x and z apart; y does not count."""
        position = scattered(4000, SIZE)
        velocity = numpy.zeros((4000, 3))
        inside = bed_statistics.window_of(position, WINDOWS, False)
        for window, (a, b) in enumerate([(0.2, 0.5), (0.1, 0.0)]):
            mine = numpy.flatnonzero(inside == window)[: 2 * (numpy.count_nonzero(inside == window) // 2)]
            sign = numpy.where(numpy.arange(len(mine)) % 2, 1.0, -1.0)
            velocity[mine] = numpy.column_stack([1.5 + a * sign, 7 * sign, -2 + b * sign])
            position[numpy.setdiff1d(numpy.flatnonzero(inside == window), mine), 2] = 0.0  # the odd one goes outside
        number, sums, temperatures = self.moments(position, velocity)
        self.assertTrue((number > 100).all() and (number % 2 == 0).all())
        numpy.testing.assert_allclose(sums / number[:, None], [[1.5, -2.0]] * 2, rtol=1e-12)
        numpy.testing.assert_allclose(temperatures, [[0.04, 0.25], [0.01, 0.0]], rtol=1e-12, atol=1e-25)

    def test_parcels_count_as_their_particles(self):
        """Spheres of weights 1 to 5 give what as many single particles at their places and of their velocities give."""
        random = numpy.random.default_rng(3)
        position, velocity, weight = scattered(500, SIZE), random.normal(size=(500, 3)), random.integers(1, 6, 500)
        number, *of_parcels = bed_statistics.window_moments(position, velocity, weight.astype(float), WINDOWS, False)
        _, *of_particles = bed_statistics.window_moments(
            numpy.repeat(position, weight, axis=0), numpy.repeat(velocity, weight, axis=0), numpy.ones(weight.sum()), WINDOWS, False)
        for parcels, particles in zip(of_parcels, of_particles):
            numpy.testing.assert_allclose(parcels, particles, rtol=1e-12)
        self.assertTrue((number < of_parcels[0]).all())

    def test_a_window_is_where_it_says(self):
        places = {(0.05, 0.05, 0.15): (0, -1), (0.15, 0.005, 0.15): (1, 1), (0.1, 0.005, 0.15): (1, 1),
                  (0.05, 0.01, 0.1): (0, 0), (0.05, 0.005, 0.2): (-1, -1), (0.05, 0.005, 0.0999): (-1, -1), (-0.01, 0.005, 0.15): (-1, -1),
                  (0.2, 0.005, 0.15): (-1, -1), (0.21, 0.005, 0.15): (-1, -1)}
        for front_only, column in ((False, 0), (True, 1)):
            found = bed_statistics.window_of(numpy.array(list(places)), WINDOWS, front_only)
            self.assertEqual(list(found), [value[column] for value in places.values()])

    def test_one_sphere_has_no_temperature(self):
        number, _, temperatures = self.moments(numpy.array([[0.05, 0.05, 0.15]]), numpy.ones((1, 3)))
        self.assertEqual(list(number), [1, 0])
        self.assertTrue(numpy.isnan(temperatures).all())


class OverlapsOfPairs(unittest.TestCase):
    def test_known_overlaps_of_one_size(self):
        d, wanted = 0.01, [0.001, 0.02, 0.3]
        places = [[0.05 * n + (d * (1 - w) if second else 0), 0.0, 0.0] for n, w in enumerate(wanted) for second in (0, 1)]
        places += [[0.5, 0, 0], [0.5 + d * 1.0001, 0, 0]]  # these do not touch
        found = bed_statistics.overlaps(numpy.array(places), numpy.full(8, d))
        numpy.testing.assert_allclose(sorted(found), wanted, rtol=1e-9)

    def test_mixed_sizes_are_measured_by_the_smaller_sphere(self):
        position = numpy.array([[0.0, 0, 0], [0, 0.0149, 0], [0, 0.1, 0], [0.004, 0.1, 0]])
        diameter = numpy.array([0.02, 0.01, 0.005, 0.005])
        numpy.testing.assert_allclose(sorted(bed_statistics.overlaps(position, diameter)), [0.01, 0.2], rtol=1e-9)

    def test_a_compressed_lattice_has_three_contacts_a_sphere(self):
        n, d, overlap = 12, 0.01, 0.004
        grid = numpy.stack(numpy.meshgrid(*[numpy.arange(n)] * 3), -1).reshape(-1, 3) * d * (1 - overlap)
        found = bed_statistics.overlaps(grid, numpy.full(n**3, d))
        self.assertEqual(len(found), 3 * n**2 * (n - 1))
        numpy.testing.assert_allclose(found, overlap, rtol=1e-9)

    def test_pairs_across_sides_that_repeat(self):
        """The lattice that repeats along y and z: each of its spheres has all its contacts there, wherever the box begins and the images lie."""
        n, d, overlap = 6, 0.01, 0.004
        length = n * d * (1 - overlap)
        grid = numpy.stack(numpy.meshgrid(*[numpy.arange(n)] * 3, indexing="ij"), -1).reshape(-1, 3) * d * (1 - overlap)
        for shift in (0.0, 0.3 * d, -2.5 * length, -1e-20):
            box = Box((0.0, -0.7 * d, 1.0), (length,) * 3, (False, True, True))
            found = bed_statistics.overlaps(grid + shift, numpy.full(n**3, d), box)
            self.assertEqual(len(found), n**2 * (n - 1) + 2 * n**3)
            numpy.testing.assert_allclose(found, overlap, rtol=1e-6)

    def test_none_and_one(self):
        self.assertEqual(len(bed_statistics.overlaps(numpy.zeros((0, 3)), numpy.zeros(0))), 0)
        self.assertEqual(len(bed_statistics.overlaps(numpy.zeros((1, 3)), numpy.ones(1))), 0)

    def test_every_overlap_is_counted(self):
        self.assertEqual(bed_statistics.overlap_counts(numpy.array([1e-12, 1e-3, 1.0, 50.0])).sum(), 4)


class VoidageOfCells(unittest.TestCase):
    def test_solid_volume_is_conserved(self):
        position, diameter = scattered(2000, SIZE), numpy.random.default_rng(2).uniform(0.001, 0.03, 2000)
        solid, outside = bed_statistics.solid_fraction(position, diameter, MESH)
        self.assertEqual(outside, 0)
        self.assertAlmostEqual(solid.sum() * MESH.cell_volume / (numpy.pi / 6 * (diameter**3).sum()), 1, delta=1e-12)

    def lattice(self, spacing, shift):
        axes = [(numpy.arange(-1, round(edge / spacing) + 1) + shift) * spacing for edge in SIZE]
        return numpy.stack(numpy.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)

    def test_a_lattice_has_its_packing_in_every_cell(self):
        """A simple cubic lattice at contact fills pi/6; here every sphere lies within one cell."""
        position = self.lattice(0.01, 0.5)
        solid, _ = bed_statistics.solid_fraction(position, numpy.full(len(position), 0.01), MESH)
        numpy.testing.assert_allclose(solid, numpy.pi / 6, rtol=1e-12)

    def test_faces_that_cut_all_spheres_in_the_same_place_are_the_worst_case(self):
        mesh = BoxMesh((0.0, 0.0, 0.0), SIZE, (4, 3, 7))
        position = self.lattice(0.004, 0.5)
        solid, _ = bed_statistics.solid_fraction(position, numpy.full(len(position), 0.004), mesh)
        numpy.testing.assert_allclose(solid, numpy.pi / 6, rtol=0.025)

    def test_a_random_bed_is_known_to_a_part_of_a_thousand(self):
        """Spheres a fifth of a cell wide, a solid fraction of 0.5 on average, against the same with 4,096 points each."""
        position, diameter = scattered(7600, SIZE), numpy.full(7600, 0.01)
        found, _ = bed_statistics.solid_fraction(position, diameter, MESH)
        fine, _ = bed_statistics.solid_fraction(position, diameter, MESH, 4096)
        self.assertLess(numpy.sqrt(numpy.mean((found - fine) ** 2)), 1.5e-3)

    def test_a_sphere_on_a_face_an_edge_and_a_corner_is_halved_quartered_divided_by_eight(self):
        for axes, parts in (((0,), 2), ((0, 2), 4), ((0, 1, 2), 8)):
            centre = numpy.array([0.025, 0.025, 0.025])
            centre[list(axes)] = 0.05
            solid, _ = bed_statistics.solid_fraction(centre[None], numpy.array([0.03]), MESH)
            shares = solid[solid > 0] * MESH.cell_volume / (numpy.pi / 6 * 0.03**3)
            self.assertEqual(len(shares), parts)
            numpy.testing.assert_allclose(shares, 1 / parts, atol=0.04)

    def test_a_cap_has_its_share(self):
        """A plane at c radii from the centre cuts off (2 - 3 c + c^3) / 4 of the ball, from whichever side."""
        errors = []
        for c in numpy.linspace(-0.95, 0.95, 39):
            for axis in range(3):
                centre = numpy.full(3, 0.025)
                centre[axis] = 0.05 - 0.01 * c
                solid, _ = bed_statistics.solid_fraction(centre[None], numpy.array([0.02]), MESH)
                errors.append(solid[tuple(int(a == axis) for a in range(3))] * MESH.cell_volume / (numpy.pi / 6 * 0.02**3)
                              - (2 - 3 * c + c**3) / 4)
        self.assertLess(numpy.sqrt(numpy.mean(numpy.square(errors))), 0.02)

    def test_what_sticks_out_stays_and_what_is_outside_is_counted(self):
        solid, outside = bed_statistics.solid_fraction(
            numpy.array([[0.001, 0.001, 0.001], [0.3, 0.05, 0.1]]), numpy.array([0.01, 0.01]), MESH
        )
        self.assertEqual(outside, 1)
        self.assertAlmostEqual(solid[0, 0, 0] * MESH.cell_volume, numpy.pi / 6 * 1e-6, delta=1e-18)

    def test_the_points_are_a_ball(self):
        points = bed_statistics.ball_points(bed_statistics.SPLIT)
        numpy.testing.assert_allclose(points.mean(axis=0), 0, atol=1e-15)
        numpy.testing.assert_allclose(points.T @ points / len(points), numpy.eye(3) / 5, atol=1e-12)
        self.assertLess(numpy.linalg.norm(points, axis=1).max(), 1.001)
