# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the start-up of a record ends, and which records are too short to tell."""

import math
import unittest

import numpy

from interphase.start_up import FEWEST, start_up_of, truncation
from made_up import steady


class StartUpOfSeries(unittest.TestCase):
    def test_a_steady_series_has_none_and_a_ramp_no_end(self):
        self.assertEqual(truncation(numpy.full(200, 3.7)), 0)
        self.assertEqual(truncation(numpy.zeros(200)), 0)
        self.assertIsNone(truncation(numpy.arange(200.0)))
        self.assertIsNone(truncation(numpy.full(FEWEST - 1, 1.0)))
        self.assertRaises(ValueError, truncation, [1.0, math.nan] * 20)

    def test_the_approach_to_rest_ends(self):
        """1 - exp(-t/10): within a thousandth, the share that counts as none, after 69 samples; MSER weighs it against length."""
        for samples in (300, 1000):
            self.assertTrue(40 <= truncation(1 - numpy.exp(-numpy.arange(samples) / 10)) <= 100)

    def test_few_steady_records_are_too_short_to_tell(self):
        """Records of 100 samples whose neighbours correlate by 0.5: of 300 none was."""
        self.assertLess(sum(truncation(steady(100, 0.5, seed)) is None for seed in range(100)), 5)

    def test_a_start_up_of_known_length_is_left_out(self):
        """Five deviations off for 200 of 1,000 samples, 100 records: at most 20 samples of it stay, more than half of the rest does;
        of the records without any, few are too short to tell."""
        step = numpy.where(numpy.arange(1000) < 200, 5.0, 0.0)
        found = [truncation(steady(1000, 0.7, seed) + step) for seed in range(100)]
        self.assertGreater(sum(cut is not None and 180 <= cut for cut in found), 90)
        self.assertLess(numpy.median([cut for cut in found if cut is not None]), 300)
        none = [truncation(steady(1000, 0.7, seed)) for seed in range(100)]
        self.assertGreater(sum(cut is not None for cut in none), 80)

    def test_the_latest_series_decides_and_what_cannot_be_judged_is_named(self):
        times = 0.01 * numpy.arange(1, 401)
        late = numpy.where(times < 1.5, 5.0, 0.0) + steady(400, 0.3, 1)
        found = start_up_of(times, {"pressure_drop": numpy.full(400, numpy.nan), "bed_height": numpy.ones(400), "kinetic_energy": late})
        self.assertTrue(1.5 <= found.end + 1e-9 <= 1.7)  # none of the start-up stays, little else goes
        self.assertEqual(found.by, "kinetic energy")
        found = start_up_of(times, {"particles": 5 * times, "kinetic_energy": late})
        self.assertIsNone(found.end)
        self.assertIn("number of particles not steady", found.reason)
        self.assertAlmostEqual(found.needed, 7.99)
        self.assertAlmostEqual(start_up_of(times[:10], {"particles": times[:10]}).needed, 0.4)  # 40 rows
        self.assertIsNone(start_up_of(times, {}).end)
