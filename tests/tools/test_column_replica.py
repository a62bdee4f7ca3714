# SPDX-License-Identifier: GPL-3.0-or-later
"""python/interphase/column_replica, column_limits: books close, a sediment rests, and each scheme bears the step that linear recursions or scans say."""

import unittest
from dataclasses import replace

import numpy as np

from interphase.column_limits import (
    AS_BUILT, SCHEMES, fluidized, half_held_limit, recursion_limit, sediment, settled, settling)  # fmt: skip
from interphase.column_replica import AIR, WATER, Scheme, Weights, hindered, rising

FREE = Scheme(hold=0.0, wall="flux", forces="faces")


def uniform(fluid, phi, x, scheme):
    """One mode, near its steady state: no noise, cells so high that nothing gets anywhere."""
    return settling(fluid, phi, x, scheme, noise=0.0, reach=1e-3, at_rest=False)[0]


class Parts(unittest.TestCase):
    def test_hats_keep_sums_and_see_a_uniform_suspension_as_uniform(self):
        z = (np.arange(60) + 0.5) / 6
        weights = Weights(z, 1.0, 10)
        np.testing.assert_allclose(weights.to_cells(np.ones(60)), 6, atol=1e-12)
        values, cells = np.sin(z), np.cos(np.arange(10.0))
        self.assertAlmostEqual(weights.to_cells(values) @ cells, values @ weights.to_layers(cells), 12)

    def test_contacts_keep_the_order_and_the_momentum_of_what_touches(self):
        values, weights = np.array([3.0, 1.0, 4.0, 2.0]), np.array([1.0, 3.0, 1.0, 1.0])
        np.testing.assert_allclose(rising(values, weights, 0, 10), [1.5, 1.5, 3, 3])
        np.testing.assert_allclose(rising(values, weights, 2, 10), [2, 2, 3, 3])

    def test_particles_that_settle_balance_weight_and_drag(self):
        for fluid in (WATER, AIR):
            speed, tau = hindered(0.3, fluid)
            drag = fluid.particle_density / tau * speed / 0.7
            self.assertAlmostEqual(drag / (0.7 * (fluid.particle_density - fluid.density) * 9.81), 1, 6)


class Books(unittest.TestCase):
    def test_momentum_and_volume_close(self):
        for name, scheme in list(SCHEMES.items())[::3]:
            for fluid in (WATER, AIR):
                for run in (settling, fluidized):
                    column = run(fluid, 0.4, 0.3, scheme)[1]
                    with self.subTest(scheme=name, fluid=fluid.name, run=run.__name__):
                        ledger = column.given + column.pending.sum() - column.taken
                        self.assertLess(abs(ledger), 1e-12 * column.exchanged)
                        height = column.cells * column.dz
                        volume = column.gas.sum() + column.a * len(column.z) - height
                        self.assertLess(abs(volume), 1e-12 * height)
                        self.assertLess(abs(column.owed().sum()), 1e-11)

    def test_what_layers_gain_is_what_fluid_gravity_and_walls_gave(self):
        _, column = settling(WATER, 0.5, 1.0, AS_BUILT)
        steps = 60 + 60 + 10
        weight = len(column.z) * column.a * WATER.particle_density * 9.81 * steps * column.dt
        gained = column.a * WATER.particle_density * column.v.sum()
        self.assertLess(abs(gained - column.taken - column.pushed + weight), 1e-12 * weight)


class Limits(unittest.TestCase):
    def test_now_diverges_where_the_linear_recursion_says(self):
        """Which leaves out the inertia of the fluid: beyond its limit nothing is calm, well below it all is."""
        for fluid in (WATER, AIR):
            for phi in (0.5, 0.6):
                limit = recursion_limit(phi)
                with self.subTest(phi=phi, fluid=fluid.name):
                    self.assertLess(uniform(fluid, phi, 0.4 * limit, replace(FREE, kind="now")).swing, 1e-3)
                    self.assertGreater(uniform(fluid, phi, limit, replace(FREE, kind="now")).swing, 0.05)

    def test_free_particles_taken_for_half_held_diverge_where_the_recursion_says(self):
        for phi in (0.5, 0.6):
            limit = half_held_limit(phi)
            with self.subTest(phi=phi):
                self.assertLess(uniform(AIR, phi, 0.8 * limit, replace(FREE, hold=0.5)).swing, 1e-3)
                self.assertGreater(uniform(AIR, phi, 1.2 * limit, replace(FREE, hold=0.5)).swing, 0.05)

    def test_one_mode_has_no_limit_in_the_new_scheme(self):
        for fluid in (WATER, AIR):
            for phi in (0.1, 0.3, 0.5, 0.6):
                for x in (0.1, 1, 10, 100):
                    with self.subTest(phi=phi, x=x, fluid=fluid.name):
                        self.assertLess(uniform(fluid, phi, x, FREE).swing, 1e-3)

    def test_waves_and_fronts_neither_as_it_is_built(self):
        for fluid in (WATER, AIR):
            for phi in (0.1, 0.3, 0.5, 0.6):
                for x in (0.1, 1, 10, 100):
                    with self.subTest(phi=phi, x=x, fluid=fluid.name):
                        self.assertTrue(settling(fluid, phi, x, AS_BUILT)[0].calm(0.02 if x <= 1 else 0.1))


class Rest(unittest.TestCase):
    def test_a_sediment_stays_where_it_is(self):
        for fluid in (WATER, AIR):
            for x in (0.1, 1, 10, 100):
                for scheme in (Scheme(), AS_BUILT):
                    with self.subTest(x=x, fluid=fluid.name, scheme=scheme):
                        moved, column = sediment(fluid, x, scheme)
                        self.assertLess(moved, 1e-12)
                        self.assertEqual(np.abs(column.v).max(), 0)

    def test_a_suspension_becomes_one(self):
        for fluid in (WATER, AIR):
            for x in (0.1, 1, 10):
                with self.subTest(x=x, fluid=fluid.name):
                    height, record = settled(fluid, 0.3, x, AS_BUILT)
                    self.assertAlmostEqual(height, 1, 9)
                    self.assertLess(record.fastest, 1e-9)
