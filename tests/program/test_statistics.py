# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 900
"""The rows of /statistics are what tools/report measures of snapshots at the same times; a run that is stopped and goes on has the same
rows to the last bit; a run without `statistics` has none. The bed is that of test_resume: spheres are poured into it."""

import dataclasses
import os
import re
import unittest

import numpy

import support
from interphase import record_samples, reporting
from interphase.statistics_rows import samples, scene_of_rows, statistics_rows
from resumed_run import ResumedRun

INTERVAL = 0.002
BLOCK = """statistics
{
    interval    %g;
    tapInterval 0.001;
    windows     { count 3; centre 0.006; height 0.012; frontDepth 0.003; }
    voidage     { limits (0.5 0.9); }
    bubbles     { voidage 0.7; }
}
"""
ROUND_OFF = 1e-12  # of sums over a thousand particles, added in another order


class Statistics(ResumedRun, support.ProgramTest):
    stop, end = 0.02, 0.04

    def case(self, folder, block=BLOCK % INTERVAL):
        """With `block` in the place of the case's own."""
        path = os.path.join(folder, "system/couplingDict")
        text, found = re.subn(r"^statistics\n\{.*?^\}\n", lambda _: block, support.read(path), flags=re.M | re.S)
        self.assertEqual(found, 1)
        support.write(path, text)
        self.set_entry(folder, "system/couplingDict", "records/snapshotInterval", INTERVAL)
        return folder

    def compare_with_snapshots(self, folder):
        run = reporting.opened(folder)
        rows = statistics_rows(run)
        scene = dataclasses.replace(scene_of_rows(rows, (50,)), voidage=None)  # of snapshots it is another one
        measured = record_samples.of_snapshots(run, scene, lambda frame: True)
        taken = samples(rows, lambda time: True)
        self.assertGreater(len(rows.time), 15)
        numpy.testing.assert_array_equal(measured.time, taken["time"])
        for name in ("spheres", "number", "pairs", "overlap_counts", "below"):
            numpy.testing.assert_array_equal(getattr(measured, name), taken[name], name)
        weight = run.recorded("weight")  # snapshots do not repeat what all spheres have alike; in their means it cancels
        for name, times in (("real", weight), ("sums", weight), ("temperatures", 1), ("largest", 1)):
            numpy.testing.assert_allclose(times * getattr(measured, name), taken[name], rtol=ROUND_OFF, atol=ROUND_OFF, err_msg=name)
        self.assertGreater(taken["number"].sum(), 0)
        self.assertGreater(taken["pairs"].sum(), 0)

    def expect_sound_rows(self, done):
        rows, series = done.table("statistics"), done.table("series")
        cells = 8 * 4 * 16
        self.assertEqual(rows["layer_voidage"].shape[1], 16)  # the mesh's own layers
        numpy.testing.assert_array_equal(rows["voidage_counts"].sum(axis=1), cells)
        numpy.testing.assert_array_equal(rows["voidage_limit_counts"].sum(axis=1), cells)
        at = numpy.argmin(abs(series["time"][:, None] - rows["time"]), axis=0)
        numpy.testing.assert_allclose(rows["translation_energy"], series["kinetic_energy"][at], rtol=ROUND_OFF)
        # the mean of the layers is that of the vessel: all cells are alike
        self.assertTrue((rows["layer_voidage"].mean(axis=1) < 1).all())
        taps = done.table("taps")
        self.assertEqual(taps["pressure"].shape, (round(self.end / 1e-3) + 1, 2))
        at = numpy.argmin(abs(taps["time"][:, None] - series["time"]), axis=0)
        drop = taps["pressure"][:, 0] - taps["pressure"][:, 1]
        numpy.testing.assert_array_equal(drop[at], series["pressure_drop"])

    def check(self, method, ranks=1):
        straight, stopped = map(self.case, self.ready(method, ranks))
        whole = self.run_case(straight, ranks)
        done = self.resumed(stopped, ranks)
        self.expect_equal_rows(whole, done)
        with whole.results() as file:
            self.assertIn("statistics", file)
            self.assertIn("taps", file)
        self.compare_with_snapshots(straight)
        self.expect_sound_rows(whole)
        said = support.tool("report", straight, "--from", 0, "--no-write")
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertIn("rows of /statistics", said.stdout)
        self.assertIn("mapped voidage below 0.5", said.stdout)

    def test_springs(self):
        self.check("DEM")

    def test_parcels_on_two_ranks(self):
        self.check("CGPM", ranks=2)

    def test_mp_pic_on_two_ranks(self):
        self.check("MPPIC", ranks=2)

    def test_off(self):
        folder = self.case(self.ready("CGPM")[0], "")
        self.set_entry(folder, "system/controlDict", "endTime", 0.005)
        with self.run_case(folder).results() as file:
            self.assertNotIn("statistics", file)
            self.assertNotIn("taps", file)

    def test_without_gas(self):
        folder = self.case(self.ready("CGPM")[0], "statistics { interval 0.001; }\n")
        self.set_entry(folder, "system/couplingDict", "gas/model", "none")
        self.set_entry(folder, "system/couplingDict", "gas/coupling", "oneWay")
        self.set_entry(folder, "system/controlDict", "endTime", 0.005)
        rows = self.run_case(folder).table("statistics")
        self.assertIn("overlap_counts", rows)
        self.assertNotIn("voidage_counts", rows)
        self.assertNotIn("bubble_number", rows)

    def test_what_cannot_be_sampled_is_refused_before_the_run(self):
        folder = self.case(self.ready("CGPM")[0], "statistics { interval 0.001; windows { centre 3; } }\n")
        done = support.execute(folder)
        self.assertEqual(done.code, 1)
        for words in ("the windows are outside of the vessel: z = ", "statistics.windows", "correct centre and height [m]"):
            self.assertIn(words, done.text)

    def test_gravity_across_the_height_is_refused_before_the_run(self):
        folder = self.case(self.ready("CGPM")[0], "statistics { interval 0.001; }\n")
        self.edit(folder, "constant/g", r"^value .*;", "value (0 -9.81 0);")
        self.edit(folder, "dem/in.liggghts", r"vector 0\.0 0\.0 -1\.0", "vector 0.0 -1.0 0.0")
        done = support.execute(folder)
        self.assertEqual(done.code, 1)
        for words in ("gravity is (0 -9.81 0) m/s2", "these take z as up: windows, voidage, surface, bubbles", "gravity points along -z"):
            self.assertIn(words, done.text)


if __name__ == "__main__":
    unittest.main()
