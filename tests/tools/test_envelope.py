# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/envelope tells runs that are calm and right from such as alternate, drift, stop or lie: series are made up, so that the
answers are known; what the drag laws say is held against numbers worked out by hand."""

import math
import os
import unittest

import numpy

from interphase import envelope_map
from interphase.envelope_measures import Column
from interphase.envelope_scenes import FRACTIONS, METHODS, RATIOS, SCENES, NotRun, Point, plan
from interphase.envelope_verdict import BEYOND, ERROR, FAILED, RIGHT, TOLD, Measures, alternation, deviation, verdict
from interphase.even_bed import even_bed
from interphase.uniform_suspension import Suspension

SOURCE = os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..")

GOOD = Measures({"velocity": 0.01}, 0.01, 0.001, 20)
LOG = "t = 1 s\nReached t = 1 s in 0:29 of wall time.\n"


def like(**changes):
    return Measures(**{**GOOD.__dict__, **changes})


class Series(unittest.TestCase):
    steps = numpy.arange(40)

    def test_alternation_is_the_amplitude_of_two_steps(self):
        self.assertAlmostEqual(alternation(1 + 0.3 * (-1.0) ** self.steps), 0.3)

    def test_trends_and_long_waves_are_none(self):
        self.assertLess(alternation(0.1 * self.steps), 1e-15)
        self.assertLess(alternation(numpy.sin(2 * math.pi * self.steps / 12)), 0.02)

    def test_a_drift_is_no_swing(self):
        self.assertLess(deviation(1 + 0.01 * self.steps), 1e-12)
        self.assertAlmostEqual(deviation(numpy.sin(2 * math.pi * self.steps / 10)), math.sqrt(0.5), delta=0.02)

    def test_short_and_broken_series(self):
        self.assertEqual(alternation([1.0, 2.0]), 0)
        self.assertAlmostEqual(alternation([1.0, -1.0, 1.0]), 1.0)
        self.assertEqual(deviation([1.0, math.nan, 2.0]), math.inf)


class Verdicts(unittest.TestCase):
    def test_right(self):
        self.assertEqual(verdict(0, LOG, GOOD)[0], RIGHT)

    def test_calm_but_off(self):
        name, seen = verdict(0, LOG, like(errors={"height": -0.08, "solid fraction": 0.01}))
        self.assertEqual(name, ERROR)
        self.assertIn("height -8.0 %", seen)

    def test_wrong_without_a_word(self):
        for changes in ({"rms": 0.2}, {"alternation": 0.1}, {"errors": {"velocity": 0.4}}, {"errors": {"velocity": math.nan}},
                        {"rms": math.inf}, {"samples": 1}):  # fmt: skip
            with self.subTest(**changes):
                self.assertEqual(verdict(0, LOG, like(**changes))[0], FAILED)
        self.assertEqual(verdict(0, LOG, None)[0], FAILED)

    def test_told(self):
        stopped = "interphase: error: the pressure alternates\n  where: here\n  remedy: a shorter gas step\n"
        name, seen = verdict(1, stopped, None)
        self.assertEqual(name, TOLD)
        self.assertIn("the pressure alternates where: here", seen)
        self.assertEqual(verdict(0, "interphase: warning: swings\n" + LOG, like(rms=0.3))[0], TOLD)

    def test_counts_of_warnings_are_none(self):
        counted = LOG + "  counted\n    warnings of LIGGGHTS   0\n    warnings of OpenFOAM   0\n"
        self.assertNotEqual(verdict(0, counted, like(rms=0.3))[0], TOLD)

    def test_a_warning_does_not_spoil_what_is_right(self):
        self.assertEqual(verdict(0, "interphase: warning: swings\n" + LOG, GOOD)[0], RIGHT)

    def test_crashes_fail(self):
        for code in (-11, 139, 134):
            self.assertEqual(verdict(code, "interphase: error: something\n", GOOD)[0], FAILED)
        self.assertEqual(verdict(1, LOG, GOOD)[0], FAILED)  # not a word why
        self.assertEqual(verdict(1, "error: x\nmpirun: exited on signal 11 (Segmentation fault)\n", None)[0], FAILED)


class Law(unittest.TestCase):
    def test_stokes_settling(self):
        s = Suspension(1e-9, 1e-5, 2000.0, 1000.0, 1e-3, "WenYu")
        self.assertAlmostEqual(s.hindered_velocity() / (1000 * 9.81 * 1e-10 / 18e-3), 1, delta=2e-3)  # (rho_p - rho) g d^2/(18 mu)
        self.assertAlmostEqual(s.relaxation_time() / (2000 * 1e-10 / 18e-3), 1, delta=2e-3)

    def test_ergun(self):
        s = Suspension(0.6, 1e-3, 2000.0, 10.0, 1.5e-3, "Ergun")
        u = 0.005
        self.assertAlmostEqual(
            s.pressure_gradient(u), 150 * 1.5e-3 * 0.36 * u / (0.4**3 * 1e-6) + 1.75 * 10 * 0.6 * u**2 / (0.4**3 * 1e-3), places=6)
        self.assertAlmostEqual(s.pressure_gradient(s.carrying_velocity()) / s.weight_gradient(), 1, places=9)

    def test_column_of_a_uniform_bed(self):
        s = Suspension(0.4, 1e-3, 2000.0, 10.0, 1.5e-3, "Ergun")
        layers, height, area, volume = 20, 0.05, 1e-4, math.pi / 6 * 1e-9
        z = (numpy.arange(round(0.4 * area * height / volume)) + 0.5) * volume / (0.4 * area)
        column = Column(z, volume, area, height, layers, 0.0025)
        depth = height - (5 + 0.5) * height / layers
        self.assertAlmostEqual(column.weight(0.0126, s) / (s.weight_gradient() * depth), 1, delta=2e-3)
        self.assertAlmostEqual(column.drop(0.0126, s, 0.01) / (s.pressure_gradient(0.01) * depth), 1, delta=5e-3)


class Scenes(unittest.TestCase):
    def test_every_point_has_a_plan_or_a_reason(self):
        run = 0
        for scene in SCENES:
            for method in METHODS:
                for phi in FRACTIONS[scene]:
                    for ratio in RATIOS:
                        try:
                            made = plan(Point(scene, method, phi, ratio))
                        except NotRun as reason:
                            self.assertTrue(str(reason))
                            continue
                        run += 1
                        self.assertAlmostEqual(made.step / (ratio * made.suspension.relaxation_time()), 1)
                        for low, high in made.windows.values():
                            self.assertTrue(0 < low < high <= made.until * (1 + 1e-9), (scene, method, phi, ratio))
                        # what alternates from step to step is seen: an odd number of steps between records
                        every = float(made.settings["recordInterval"]) / made.step
                        self.assertEqual(round(every) % 2, 1)
        self.assertGreater(run, 200)

    def test_even_bed(self):
        places = even_bed(860, 1e-3, (0, 0, 0.01), (0.01, 0.01, 0.025))  # a packing of 0.3
        self.assertTrue((places >= [0, 0, 0.01]).all() and (places <= [0.01, 0.01, 0.025]).all())
        apart = numpy.linalg.norm(places[:, None] - places[None], axis=2) + numpy.eye(len(places))
        self.assertGreater(apart.min(), 1e-3)
        layers = numpy.histogram(places[:, 2], 5, (0.01, 0.025))[0]
        self.assertLess(abs(layers - 172).max(), 15)


class Map(unittest.TestCase):
    def test_table(self):
        rows = [
            {"scene": "closed", "method": "TDHS", "phi": 0.3, "ratio": x, "verdict": verdict_, "error": 0.034}
            for x, verdict_ in ((0.1, RIGHT), (1.0, ERROR), (10.0, FAILED), (100.0, BEYOND))
        ]
        text = envelope_map.markdown(rows)
        self.assertIn("| TDHS | 0.3 | right | +3.4 % | **failed** | - |", text)
        self.assertIn("failed: 1", text)
