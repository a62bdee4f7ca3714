# SPDX-License-Identifier: GPL-3.0-or-later
"""Dimensionless numbers, minimum fluidization and Geldart's groups against closed solutions, published powders and measurements."""

import unittest

from interphase.drag_laws import LAWS
from interphase.fluidization import Grain

AIR = {"gas_density": 1.204, "viscosity": 1.825e-5, "gravity": 9.81}
WATER = {"gas_density": 1000.0, "viscosity": 1e-3, "gravity": 9.81}
SSCP1 = Grain(3.256e-3, 1131.0, **AIR)


class Groups(unittest.TestCase):
    def test_powders_that_geldart_names(self):
        """Of each group the examples of Geldart, Powder Technol. 7 (1973) 285, by their usual size [m] and density [kg/m3]."""
        for name, diameter, density, group in (
            ("flour", 10e-6, 1500, "C"), ("cracking catalyst", 60e-6, 1400, "A"), ("sand", 300e-6, 2650, "B"), ("glass beads", 500e-6, 2500, "B"),
            ("wheat", 4e-3, 1300, "D"), ("coffee beans", 7e-3, 600, "D"),
        ):  # fmt: skip
            with self.subTest(name):
                self.assertEqual(Grain(diameter, density, **AIR).geldart_group, group)

    def test_boundaries_lie_where_they_were_published(self):
        for diameter, density, below, above in ((225e-6, 1001.204, "A", "B"), (1000e-6, 1001.204, "B", "D")):
            self.assertEqual(Grain(0.999 * diameter, density, **AIR).geldart_group, below)
            self.assertEqual(Grain(1.001 * diameter, density, **AIR).geldart_group, above)

    def test_none_in_a_liquid(self):
        self.assertIsNone(Grain(1e-3, 2000, **WATER).geldart_group)
        self.assertIsNone(Grain(1e-3, 1.0, **AIR).geldart_group)  # it rises


class Fluidization(unittest.TestCase):
    def test_the_bed_that_was_measured(self):
        """Liu and van Wachem, Powder Technol. 343 (2019) 145 measured 1.05 m/s; the law's depends on the voidage, which is not known better than 0.41 to
        0.42 (cases/packed-bed); Wen and Yu's correlation has a standard deviation of 34 %."""
        self.assertAlmostEqual(SSCP1.minimum_fluidization(LAWS["BVK"], 0.41), 1.06, delta=0.005)
        self.assertAlmostEqual(SSCP1.minimum_fluidization(LAWS["BVK"]), 1.11, delta=0.005)
        self.assertLess(abs(SSCP1.minimum_fluidization_by_wen_yu / 1.05 - 1), 0.34)

    def test_drag_carries_the_packing_there(self):
        """The pressure gradient of Ergun's own equation, Chem. Eng. Prog. 48 (1952) 89, is the weight less buoyancy."""
        eps, d, mu, rho = 0.45, SSCP1.diameter, SSCP1.viscosity, SSCP1.gas_density
        speed = SSCP1.minimum_fluidization(LAWS["Ergun"], eps)
        gradient = 150 * mu * (1 - eps) ** 2 * speed / (eps**3 * d**2) + 1.75 * rho * (1 - eps) * speed**2 / (eps**3 * d)
        weight = (SSCP1.density - rho) * (1 - eps) * SSCP1.gravity
        self.assertAlmostEqual(gradient / weight, 1, delta=1e-9)  # of the root's own accuracy

    def test_stokes_fall(self):
        """v = (rho_p - rho) g d^2/(18 mu) for Re -> 0; the correction at Re = 6e-4 is 0.15 Re^0.687 = 1e-3."""
        fine = Grain(1e-5, 1100.0, **WATER)
        closed = 100 * 9.81 * 1e-10 / (18 * 1e-3)
        self.assertAlmostEqual(fine.terminal_velocity(LAWS["SchillerNaumann"]) / closed, 1, delta=1e-3)
        self.assertAlmostEqual(fine.viscous_relaxation_time, 1100 * 1e-10 / 0.018)

    def test_relaxation_times_of_the_suspension(self):
        """m/k [ms] of cases/suspension, by its solid fraction and velocity of fall [mm/s]: its page's two tables, to their digits."""
        sphere = Grain(1e-3, 2000.0, **WATER)
        for fraction, fall, time in ((0.1, 81.7, 20.6), (0.3, 37.1, 15.4), (0.4, 22.3, 12.7), (0.5, 11.9, 9.7)):
            found = sphere.relaxation_time(LAWS["WenYu"], 1 - fraction, 1e-3 * fall / (1 - fraction))
            self.assertAlmostEqual(1e3 * found, time, delta=0.06)

    def test_numbers_by_hand(self):
        self.assertAlmostEqual(SSCP1.archimedes / (1.204 * 1129.796 * 9.81 * 3.256e-3**3 / 1.825e-5**2), 1, delta=1e-12)
        self.assertAlmostEqual(SSCP1.reynolds(2.19), 1.204 * 2.19 * 3.256e-3 / 1.825e-5)
        self.assertAlmostEqual(SSCP1.stokes(2.19), 1131 * 3.256e-3 * 2.19 / (9 * 1.825e-5))

    def test_what_weighs_nothing(self):
        floating = Grain(1e-3, 1000.0, **WATER)
        self.assertIsNone(floating.minimum_fluidization(LAWS["WenYu"]))
        self.assertIsNone(floating.terminal_velocity(LAWS["WenYu"]))


if __name__ == "__main__":
    unittest.main()
