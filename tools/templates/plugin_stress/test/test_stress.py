#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The stress is what its source says: 0 below phi_min, values beyond it, growing with the solid fraction, finite at 1; what is not a number of
it is refused.
"""

import unittest

import numpy

from table import table

WORDS = "stress @NAME@ 0.05 2 5 0.5 close_packing 0.65"


class Stress(unittest.TestCase):
    def test_values(self):
        solid_fraction, stress = table(WORDS)
        at = dict(zip(solid_fraction.round(4), stress))
        for phi, expected in ((0, 0), (0.5, 0), (0.55, 12.5), (0.6, 1600), (0.64, 9.8e6)):  # by hand
            with self.subTest(solid_fraction=phi):
                self.assertAlmostEqual(at[phi], expected, delta=1e-9 * expected)

    def test_grows_and_is_finite(self):
        solid_fraction, stress = table(WORDS)
        self.assertEqual(solid_fraction[-1], 1)
        self.assertTrue(numpy.isfinite(stress).all())
        self.assertTrue((numpy.diff(stress[solid_fraction >= 0.5]) > 0).all())


class Numbers(unittest.TestCase):
    def test_refused(self):
        for words, told in (("-1 2 5 0.5", "Fr -1: give a number above 0, in Pa"), ("0.05 2 5", "'stress @NAME@ phi_min table': no number"),
                            ("1e300 2 5 0.5", "is inf Pa at a solid fraction of")):  # fmt: skip
            with self.subTest(words):
                with self.assertRaisesRegex(AssertionError, told):
                    table(f"stress @NAME@ {words}")


if __name__ == "__main__":
    unittest.main()
