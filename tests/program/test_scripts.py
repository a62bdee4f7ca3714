# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 600
"""What a script does with the package: a case changed, run, stopped, gone on with, and its numbers read with their units, also while it
goes; and what it is told where it asks for what there is not."""

import contextlib
import io
import math
import os
import time
from unittest import mock

import h5py
import numpy

import interphase
import starting_runs
import support

VESSEL = starting_runs.WIDTH * starting_runs.DEPTH * starting_runs.HEIGHT  # [m3]


class Scripts(support.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.enterClassContext(mock.patch.dict(os.environ, support.environment()))
        settings = dict(starting_runs.SETTINGS)
        of_files = {name: settings.pop(name) for name in list(settings) if ":" in name}
        cls.case = interphase.Case(starting_runs.case(cls.shared)).set(of_files, **settings)
        cls.ended = cls.case.run(os.path.join(cls.shared, "ended"), until=0.04)

    def failed(self, action):
        """The run that `action` gives, and what was told of it."""
        with contextlib.redirect_stderr(io.StringIO()) as told:
            run = action()
        return run, told.getvalue()


class Cases(Scripts):
    def test_set_leaves_the_case_as_it_was(self):
        other = self.case.set(inletVelocity=0.7, method="CGHS", weight=2)
        self.assertEqual((other.method, other.weight, other.parameters["inletVelocity"]), ("CGHS", 2, 0.7))
        self.assertEqual((self.case.method, self.case.weight, self.case.parameters["inletVelocity"]), ("CGPM", 8, 0.4))
        self.assertEqual(other.parameters["width"], starting_runs.WIDTH)

    def test_what_a_case_does_not_have_is_refused_with_the_nearest(self):
        for changes, words in (({"inletVelocty": 1}, "no entry 'inletVelocty': did you mean 'inletVelocity'"),
                               ({"method": "CGHX"}, "method 'CGHX' is unknown: did you mean"),
                               ({"weight": 0.5}, "weight 0.5: a tracked sphere stands for at least 1"),
                               ({"method": "DEM", "weight": 8}, "does not go with method DEM")):  # fmt: skip
            with self.subTest(changes), self.assertRaisesRegex(interphase.InputError, words):
                self.case.set(**changes)
        with self.assertRaisesRegex(interphase.InputError, "no such folder"):
            interphase.Case(os.path.join(self.root, "nowhere"))
        with self.assertRaisesRegex(interphase.InputError, "ranks = 1.5: give a whole number"):
            self.case.run(os.path.join(self.root, "run"), ranks=1.5)

    def test_an_earlier_run_stays(self):
        with self.assertRaisesRegex(interphase.InputError, "^.*ended holds an earlier run: --overwrite replaces it"):
            self.case.run(self.ended.path, until=0.04)

    def test_a_step_before_the_program_that_fails(self):
        """A bed higher than its vessel."""
        out = os.path.join(self.root, "run")
        with self.assertRaisesRegex(interphase.StepFailed, "prepare failed.*(\n.*)*do not fit|would reach"):
            self.case.set(particleCount=160000).run(out, until=0.01)
        self.assertEqual(interphase.Run(out).state, "broken off")

    def test_a_run_that_fails_is_no_ok_and_says_why(self):
        with mock.patch.dict(os.environ, INTERPHASE_BIN="false"):
            run, told = self.failed(lambda: self.case.run(os.path.join(self.root, "run"), until=0.01))
        self.assertEqual((run.ok, run.state, run.record["exit_code"]), (False, "failed", 1))
        self.assertIn("stopped before its end", told)


class Numbers(Scripts):
    def test_of_a_run_that_has_ended(self):
        run = interphase.Run(self.ended.path)
        self.assertTrue(run.ok)
        self.assertEqual(run.meta["case"], "ended")
        self.assertEqual(run.record["weight"], 8)

    def test_series_and_their_means(self):
        series = self.ended.series["pressure_drop"]
        with h5py.File(os.path.join(self.ended.path, "results.h5")) as file:
            numpy.testing.assert_array_equal(series.values, file["series/pressure_drop"][:])
            numpy.testing.assert_array_equal(series.time, file["series/time"][:])
        mean = series.mean(after=0.0095)
        self.assertEqual((mean.unit, mean.samples), ("Pa", numpy.count_nonzero(series.time >= 0.0095)))
        self.assertEqual(mean.value, series.values[series.time >= 0.0095].mean())
        self.assertIn("kinetic_energy", self.ended.series)
        self.assertIsNone(self.ended.series.get("nothing"))
        # closed to round-off, which grows with the 40 steps
        self.assertLess(abs(self.ended.ledger["momentum_residual"].values).max(), 1e-12)

    def test_snapshots_are_the_particles_by_id(self):
        snapshots = self.ended.snapshots
        numpy.testing.assert_allclose(snapshots.times, [0, 0.01, 0.02, 0.03, 0.04], atol=1e-12)
        for snapshot, (moment, rows) in zip(snapshots, starting_runs.snapshots(self.ended.path)):
            self.assertEqual(snapshot.time, moment)
            numpy.testing.assert_array_equal(snapshot.positions, rows["position"])
            numpy.testing.assert_array_equal(snapshot.ids, numpy.arange(1, starting_runs.COUNT // 8 + 1))
        self.assertEqual(snapshots[-1].velocities.shape, (200, 3))
        self.assertEqual(snapshots[-1].read("diameter").unit, "m")
        self.assertIs(snapshots.at(0.02), snapshots[2])

    def test_fields_hold_the_solids_there_are(self):
        """Cells are alike, so their mean solid fraction times the vessel's volume is that of all spheres: to the six digits that are written."""
        voidage = self.ended.fields("voidage", time=0.04)
        self.assertEqual((voidage.unit, voidage.values.shape, voidage.uniform), ("1", (8 * 4 * 16,), False))
        spheres = starting_runs.COUNT * math.pi / 6 * starting_runs.DIAMETER**3
        self.assertAlmostEqual((1 - voidage.values).mean() * VESSEL / spheres, 1, delta=1e-5)
        velocity = self.ended.fields("U")
        self.assertEqual((velocity.unit, velocity.values.shape, velocity.time), ("m/s", (512, 3), 0.04))
        self.assertEqual(self.ended.fields("p_rgh").unit, "Pa")

    def test_what_there_is_not(self):
        for ask, words in ((lambda: self.ended.series["presure_drop"], "did you mean 'pressure_drop'"),
                           (lambda: self.ended.series["pressure_drop"].mean(after=9), "no rows after 9 s .* there are rows of"),
                           (lambda: self.ended.fields("voidge"), "did you mean 'voidage'"),
                           (lambda: self.ended.fields("U", time=7), "no fields of the gas at 7 s; there are those of 0, 0.02, 0.04 s"),
                           (lambda: self.ended.snapshots.at(7), "no snapshot at 7 s; the nearest is at 0.04 s"),
                           (lambda: self.ended.snapshots[0].read("charge"), "no dataset|has no 'charge'"),
                           (lambda: self.ended.stop(), r"is not running here \(ended\)"),
                           (lambda: interphase.Run(self.root), "it is no run"),
                           (lambda: interphase.Run(os.path.join(self.root, "nowhere")), "no such folder")):  # fmt: skip
            with self.subTest(words), self.assertRaisesRegex(interphase.InputError, words):
                ask()

    def test_a_mean_of_few_rows_is_not_trusted(self):
        mean = self.ended.series["pressure_drop"].mean(after=0.0345)
        self.assertTrue(math.isnan(mean.error))
        self.assertIn("at least 20 are needed", str(mean))

    def test_a_series_that_is_not_finite(self):
        from interphase.series import Series
        series = Series("drop", numpy.arange(30.0), numpy.where(numpy.arange(30) == 4, numpy.nan, 1.0), "Pa")
        with self.assertRaisesRegex(interphase.InputError, "drop is not finite in 1 rows, first at t = 4 s"):
            series.mean()
        self.assertEqual(series.mean(after=5).value, 1.0)


class Going(Scripts):
    def test_stopped_while_it_goes_and_gone_on_with(self):
        """A script looks at a run that goes, ends it, and goes on to where it was to end."""
        mine = self.case.run(os.path.join(self.root, "run"), until=600, wait=False)
        other = interphase.Run(mine.path)  # another program's view of it
        deadline = time.monotonic() + 120
        while not (os.path.exists(os.path.join(mine.path, "results.h5")) and len(other.series) and len(other.series["bed_height"].time) > 5):
            self.assertEqual(other.state, "running")
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.1)
        with self.assertRaisesRegex(interphase.InputError, "the run still goes"):
            other.resume()
        self.assertFalse(other.ok)
        _, told = self.failed(other.stop)
        self.assertEqual(other.state, "stopped")
        _, told = self.failed(mine.wait)
        self.assertIn("stopped by SIGTERM before its end", told)
        rows = len(other.series["bed_height"].time)
        reached = other.series["bed_height"].time[-1]
        self.assertGreater(rows, 5)

        other.resume(until=round(reached + 0.02, 6))
        self.assertEqual((other.state, other.ok), ("ended", True))
        longer = other.series["bed_height"].time
        self.assertAlmostEqual(longer[-1], round(reached + 0.02, 6), delta=1e-9)
        self.assertGreater(len(longer), rows)
        self.assertTrue((numpy.diff(longer) > 0).all())

    def test_two_ranks_put_their_fields_together(self):
        run = self.case.run(os.path.join(self.root, "run"), ranks=2, until=0.02)
        self.assertTrue(run.ok)
        voidage, alone = run.fields("voidage", 0.02).values, self.ended.fields("voidage", 0.02).values
        # the same bed; the two runs may part by round-off only in 20 steps, and values have six digits
        numpy.testing.assert_allclose(voidage, alone, atol=1e-4)
        os.rename(os.path.join(run.path, "0.02"), os.path.join(run.path, "gone"))
        with self.assertRaisesRegex(interphase.InputError, "reconstructPar -case"):
            run.fields("voidage")
