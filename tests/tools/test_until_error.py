# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/run --until-error: what it takes, when it is reached, what it says where it is not; the watch on a run that grows."""

import os
import subprocess
import threading
import unittest

import h5py
import numpy

from interphase import until_error
from interphase.input_error import InputError
from interphase.run import Run
from interphase.start_up import StartUp
from interphase.tree import CASES, TOOLS
from interphase.series import Series
from made_up import steady
from scratch import InFolder


def series(values, unit="Pa"):
    return Series("pressure_drop", 0.05 * numpy.arange(len(values)), values, unit)


class Standings(unittest.TestCase):
    def of(self, text, values, settled=StartUp(0.0)):
        return until_error.standing(until_error.target(text), series(values), settled)

    def test_what_is_asked_for(self):
        self.assertEqual(until_error.target("pressure_drop 2%"), until_error.Target("pressure_drop", 2, "%"))
        self.assertEqual(until_error.target("bed_height 0.002 m"), until_error.Target("bed_height", 0.002, "m"))
        self.assertEqual(until_error.target("bed_height 2e-3"), until_error.Target("bed_height", 0.002, ""))
        for bad in ("pressure_drop", "pressure_drop 0%", "pressure_drop -1", "pressure_drop nan", "2% pressure_drop", "a 1 m m", ""):
            with self.assertRaisesRegex(InputError, "--until-error"):
                until_error.target(bad)

    def test_reached_or_how_far_it_is(self):
        """White noise of deviation 20 about 850, 400 rows: 1.0 Pa by theory, known to 9 % by 64 degrees of freedom."""
        values = 850 + 20 * steady(400, 0.0, 1)
        self.assertTrue(self.of("pressure_drop 1%", values).reached)
        self.assertTrue(self.of("pressure_drop 1.5 Pa", values).reached)
        short = self.of("pressure_drop 0.1", values)
        self.assertFalse(short.reached)
        self.assertAlmostEqual(short.needed / (19.95 * 100), 1, delta=0.4)  # errors by 1/sqrt(T)
        with self.assertRaisesRegex(InputError, "is in Pa"):
            self.of("pressure_drop 2 m", values)

    def test_why_it_is_not_to_be_reached(self):
        values = 20 * steady(400, 0.0, 2)
        self.assertIn("not told from zero", self.of("pressure_drop 2%", values).words)
        self.assertIn("drifts", self.of("pressure_drop 2%", 850 + values + numpy.linspace(0, 300, 400)).words)
        self.assertIn("start-up", self.of("pressure_drop 2%", values, StartUp(None, reason="bed height not steady")).words)
        self.assertIn("not to be trusted", self.of("pressure_drop 50%", 850 + 20 * steady(60, 0.98, 5)).words)


class Watching(InFolder):
    def write_rows(self, count):
        with h5py.File(os.path.join(self.root, "new.h5"), "w") as file:
            group = file.create_group("series")
            group["time"] = 0.05 * numpy.arange(1, count + 1)
            group["pressure_drop"] = 850 + 20 * steady(4000, 0.0, 1)[:count]
            group["pressure_drop"].attrs["unit"] = "Pa"
        os.replace(os.path.join(self.root, "new.h5"), os.path.join(self.root, "results.h5"))

    def watched(self, text, rows):
        """The watch on a run that records as many rows at each look."""
        stopped, watch = threading.Event(), until_error.Watch([until_error.target(text)], self.root)
        before, until_error.SECONDS_BETWEEN_LOOKS = until_error.SECONDS_BETWEEN_LOOKS, 0.02
        self.addCleanup(setattr, until_error, "SECONDS_BETWEEN_LOOKS", before)
        looks = []
        reads = watch._last

        def last():
            if len(looks) < len(rows):
                self.write_rows(rows[len(looks)])
            looks.append(reads())
            return looks[-1]

        watch._last = last
        watch.start(stopped.set)
        stopped.wait(10 if len(rows) > 1 else 0.5)
        watch.end()
        return watch

    def test_it_ends_a_run_that_grows(self):
        watch = self.watched("pressure_drop 0.5%", [50, 100, 400, 800])
        self.assertTrue(watch.reached)
        self.assertRegex(watch.told()[0], r"^reached: pressure_drop 0.5%: 8\d\d\.?\d* \+- \d\.?\d* Pa, from 0.05 to")

    def test_it_leaves_one_that_stands_still(self):
        """Whose program may not listen to signals yet: it goes on from these rows."""
        self.assertFalse(self.watched("pressure_drop 0.5%", [800]).reached)

    def test_an_unknown_series_is_refused_with_the_nearest(self):
        watch = self.watched("presure_drop 2%", [50, 100, 200])
        self.assertIn("pressure_drop", str(watch.refused))
        self.assertFalse(watch.reached)

    def test_what_the_rest_would_take(self):
        self.write_rows(400)
        Run(self.root)
        told = until_error.Watch([until_error.target("pressure_drop 0.01%")], self.root).told()
        self.assertRegex(told[0], r"not reached: .*; about to t = \d+")

    def test_the_command_line_is_refused(self):
        done = subprocess.run([os.path.join(TOOLS, "run"), os.path.join(CASES, "sscp1"), "--until-error", "pressure_drop 0%"], capture_output=True,
                              text=True, timeout=60)  # fmt: skip
        self.assertEqual(done.returncode, 2)
        self.assertIn("must be above 0", done.stderr)


if __name__ == "__main__":
    unittest.main()
