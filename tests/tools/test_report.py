# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/report: what it finds in made-up runs of known means, where, from when on, and what it refuses. What it measures of one snapshot is in
test_bed_statistics.py, of series in test_time_statistics.py and test_start_up.py."""

import contextlib
import io
import json
import math
import os
import re
import shutil
import subprocess
import sys
import unittest

import h5py
import numpy

import interphase
from interphase import bed_statistics, record_samples, report_scene, report_table, reporting, time_statistics as statistics
from interphase.box_mesh import BoxMesh, box_mesh
from interphase.commands import report as report_tool
from interphase.input_error import InputError
from interphase.report_keys import KEYS
from interphase.report_vessel import Vessel
from interphase.run import Run
from interphase.tree import CASES, TOOLS
from made_up import scattered, steady
from scratch import InFolder, write, write_results, write_snapshots

SCRIPT = os.path.join(TOOLS, "report")

SIZE = (0.2, 0.1, 0.4)  # of the vessel [m]

PARAMETERS = "width 0.2;\ndepth 0.1;\nheight 0.4;\nacross 4;\n"

MESH_DICT = """scale 1;
vertices
(
    (0 0 0)       ($width 0 0)       ($width $depth 0)       (0 $depth 0)
    (0 0 $height) ($width 0 $height) ($width $depth $height) (0 $depth $height)
);
blocks (hex (0 1 2 3 4 5 6 7) ($across 2 8) simpleGrading (1 1 1));
"""

REPORT_DICT = """#include "$FOAM_CASE/parameters"
from 1;
windows { count 2; left 0; right $width; centre 0.15; height 0.1; frontDepth 0.01; }
overlaps { shares (0.0025 0.01); percentiles (50 90); }
voidage { lowest 0.3; highest 1; bins 28; limits (0.5 0.95); }
"""


class Table(unittest.TestCase):
    def mean(self, value, error, reason=""):
        return statistics.Mean(value, error, 1.0, 100, 50, 40, 1, reason)

    def test_numbers_are_shown_to_the_digits_of_their_error(self):
        for value, error, expected in (
            (846.23, 3.12, "846.2 +- 3.1"), (0.03456, 0.00123, "0.0346 +- 0.0012"), (-12345.6, 210, "-12346 +- 210"),
            (0.0, 0.01, "0.000 +- 0.010"), (100.0, 0.0, "100 +- 0"), (3.21e-6, 4e-8, "(3.210 +- 0.040)e-6"),
        ):
            self.assertEqual(report_table.shown(self.mean(value, error)), expected)
        self.assertEqual(report_table.shown(self.mean(1.5, math.nan, "few")), "1.5 +- ?")
        self.assertEqual(report_table.shown(self.mean(1.5, 0.1, "drifts")), "1.50 +- 0.10 ?")
        self.assertEqual(report_table.shown(None), "-")

    def test_agreement_is_by_the_joint_uncertainty(self):
        a = [self.mean(1.0, 0.3), self.mean(1.0, 0.3), self.mean(1.0, 0.3), None]
        b = [self.mean(1.5, 0.4), self.mean(5.0, 0.4), self.mean(1.0, 0.4, "drifts"), self.mean(1.0, 0.3)]
        found = [row[0] for row in report_table.judged(a, [b], 0.95)]
        self.assertEqual([j.verdict for j in found], ["agree", "differ", "not judged", "not judged"])
        self.assertAlmostEqual(found[0].ratio, 0.5 / 0.5)
        self.assertAlmostEqual(found[1].ratio, 4 / 0.5)


class Folder(InFolder):
    """Runs' folders as tools/run and the program leave them."""

    def write(self, run, name, text):
        write(os.path.join(self.root, run, name), text)

    def case(self, run, scene=REPORT_DICT, mesh=MESH_DICT):
        self.write(run, "parameters", PARAMETERS)
        if scene:
            self.write(run, "system/reportDict", scene)
        if mesh:
            self.write(run, "system/blockMeshDict", mesh)
        return os.path.join(self.root, run)

    def run_of(self, name, snapshots=60, seed=1, ended=True, weight=1.0, results=True, shift=0.0, case=True):
        """300 spheres at 20 Hz: vertical velocity 0.5 + `shift` on average, shared deviations of 0.2, an overlap of 1e-3."""
        folder = self.case(name) if case else os.path.join(self.root, name)
        random = numpy.random.default_rng(seed)
        together = 0.2 * steady(snapshots, 0.5, seed)

        def spheres(n):
            position = scattered(300, SIZE, 1000 * seed + n) * 0.9 + 0.005
            position[:2] = [[0.1, 0.05, 0.39], [0.1, 0.05 + 0.001 * (1 - 1e-3), 0.39]]
            velocity = [random.normal(0, 0.3, 300), random.normal(0, 1, 300), 0.5 + shift + together[n] + random.normal(0, 0.6, 300)]
            return {"id": numpy.arange(1, 301), "position": position, "velocity": numpy.column_stack(velocity), "diameter": numpy.full(300, 0.001)}

        write_snapshots(folder, [(0.05 * n, spheres(n)) for n in range(snapshots)])
        if results:
            series = {"time": 0.05 * numpy.arange(1, snapshots), "pressure_drop": 900 + 100 * steady(snapshots - 1, 0.5, seed + 1),
                      "bed_height": numpy.full(snapshots - 1, 0.3), "kinetic_energy": 0.1 + 0.01 * steady(snapshots - 1, 0.5, seed + 2)}  # fmt: skip
            write_results(folder, series, weight=weight, **({"wall_time": 12.0} if ended else {}))
        return folder

    def report(self, *given, code=0):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            found = report_tool.main([str(word) for word in given])
        self.assertEqual(found, code, out.getvalue() + err.getvalue())
        return out.getvalue() if code == 0 else err.getvalue()


class WholeReport(Folder):
    def test_the_numbers_are_in_the_file_with_units(self):
        run = self.run_of("one", snapshots=120)
        text = self.report(run)
        with h5py.File(os.path.join(run, "results.h5"), "r") as file:
            for depth in ("front_slice", "full_depth"):
                group = file[f"profiles/{depth}"]
                for name, expected, unit in (("vertical_velocity", 0.5, "m/s"), ("horizontal_velocity", 0.0, "m/s")):
                    found, error = group[name][()], group[f"{name}_error"][()]
                    self.assertEqual(group[name].attrs["unit"], unit)
                    self.assertTrue((error > 0).all() and (abs(found - expected) < 4 * error).all())
            # (0.3^2 + 0.6^2) / 3, less 1/N of it: some 40 spheres are in a window
            group = file["profiles/full_depth"]
            number = group["number"][()]
            expected = (0.09 + 0.36) / 3 * (1 - 1 / number)
            error = group["granular_temperature_error"][()]
            self.assertTrue((abs(group["granular_temperature"] - expected) < 4 * error).all())
            self.assertEqual(group["granular_temperature"].attrs["unit"], "m2/s2")
            numpy.testing.assert_allclose(file["profiles/window_centre"], [0.05, 0.15])
            overlap = file["histograms/overlap"]
            self.assertAlmostEqual(overlap["share"][()].sum(), 1)
            self.assertLess(overlap["share_below_limits"][0], 1)  # other pairs of random spheres overlap more
            self.assertGreaterEqual(overlap["largest"][()], 1e-3)
            voidage = file["histograms/voidage"]
            self.assertAlmostEqual(voidage["share"][()].sum() + voidage.attrs["share_below_edges"], 1)
            self.assertAlmostEqual(file["profiles/means/bed_height"][()], 0.3)
            self.assertEqual(file["profiles/means/pressure_drop"].attrs["unit"], "Pa")
            self.assertAlmostEqual(file["profiles"].attrs["from"], 1.0)
            self.assertEqual(file["profiles"].attrs["snapshots"], 100)
            self.assertIn("series/time", file)  # what was there stays
            before = voidage["share"][()]
        self.assertIn("front slice", text)  # W = 1
        self.assertTrue(os.path.isfile(os.path.join(run, "report.png")))
        self.report(run)
        with h5py.File(os.path.join(run, "results.h5"), "r") as file:
            numpy.testing.assert_array_equal(file["histograms/voidage/share"], before)

    def test_twins_agree_and_a_shifted_run_differs(self):
        runs = [self.run_of("a", 120), self.run_of("b", 120, seed=2), self.run_of("c", 120, seed=3, shift=0.5)]
        text = self.report(*runs, "--no-write", "--depth", "full")
        columns = text.split("vertical velocity [m/s]\n")[1].splitlines()[0]
        self.assertRegex(columns, r"x = 0\.0500 m .* agree .* differ")
        self.assertRegex(text, r"B against A: \d+ agree, 0 differ")
        self.assertRegex(text, r"A: a +B: b +C: c +B - A +C - A")
        self.assertFalse(os.path.exists(os.path.join(runs[0], "report.png")))
        with h5py.File(os.path.join(runs[0], "results.h5"), "r") as file:
            self.assertNotIn("profiles", file)

    def test_parcels_are_shown_over_the_full_depth(self):
        self.assertIn("full depth", self.report(self.run_of("one", weight=8.0), "--no-write"))

    def test_weights_that_differ(self):
        """Parcels of 9 that rise at 1 m/s among as many particles that sink at 1 m/s: 0.8 m/s on average."""
        run = self.run_of("mixed", 60, weight=5.0)
        with h5py.File(os.path.join(run, "particles.h5"), "r+") as file:
            for group in file["snapshots"].values():
                weight = numpy.where(numpy.arange(300) % 2, 9.0, 1.0)
                group["weight"] = weight
                group["velocity"][:, 2] = numpy.where(weight > 1, 1.0, -1.0)
        text = self.report(run)
        self.assertIn("full depth", text)
        with h5py.File(os.path.join(run, "results.h5"), "r") as file:
            group = file["profiles/full_depth"]
            # of 1,600 spheres in a window half are of each kind but for chance, which is 0.01 m/s
            numpy.testing.assert_allclose(group["vertical_velocity"], 0.8, atol=0.05)

    def test_the_range_is_that_of_the_shortest_run(self):
        long, short = self.run_of("long", 80), self.run_of("short", 50, seed=4)
        text = self.report(long, short, "--no-write")
        self.assertIn("from 1 to 2.45 s", text)
        self.assertRegex(text, r"snapshots +30 +30\b")
        self.assertRegex(self.report(long, short, "--no-write", "--from", 0, "--every", 5), r"snapshots +10 +10\b")

    def test_the_figure_goes_where_it_is_asked_for(self):
        path = os.path.join(self.root, "figure.png")
        self.report(self.run_of("one", 30), "--no-write", "--out", path)
        with open(path, "rb") as file:
            self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")

    def test_without_pressure_taps(self):
        """The report says what asks for a pressure drop, and so does a script that looks for it."""
        run = self.run_of("one", 30)
        with h5py.File(os.path.join(run, "results.h5"), "r+") as file:
            del file["series/pressure_drop"]
        text = self.report(run, "--no-write")
        self.assertIn("the case has no pressure taps", text)
        self.assertIn("bed height", text)
        with self.assertRaisesRegex(InputError, r"no pressure taps.*records \{ pressureTaps"):
            Run(run).series["pressure_drop"]

    def test_from_the_command_line(self):
        done = subprocess.run([SCRIPT, self.run_of("one", 30)], capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("pressure drop", done.stdout)
        done = subprocess.run([SCRIPT, "--help"], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0)
        self.assertIn("reportDict", done.stdout)

    def test_parts_that_are_not_asked_for_are_left_out(self):
        run = self.run_of("one", 30)
        self.write("one", "system/reportDict", "windows none; voidage none; overlaps { shares (0.01); percentiles (90); }")
        text = self.report(run)
        self.assertNotIn("voidage", text.replace("voidage.", ""))
        with h5py.File(os.path.join(run, "results.h5"), "r") as file:
            self.assertEqual(list(file["histograms"]), ["overlap"])

    def test_the_reference_bed_is_described_as_the_experiment_was(self):
        case = os.path.join(CASES, "sscp1")
        file, mesh = report_scene.opened(case), box_mesh(case)
        scene, notes = report_scene.scene_of(file, Vessel(mesh.low, mesh.high, "the mesh", 0.003, 0.003, 0.003, 0.1), mesh)
        self.assertEqual(notes, [])
        edges = bed_statistics.window_edges(scene.windows)
        self.assertEqual(scene.voidage.mesh, BoxMesh((0, 0, 0), (0.2286, 0.0762, 1.2192), (16, 4, 85)))
        numpy.testing.assert_allclose(numpy.diff(edges), 0.0457, atol=5e-5)
        self.assertEqual((scene.windows.centre, scene.windows.front_depth, report_scene.start_of(file)), (0.0762, 0.003, 10))


STATISTICS = "statistics\n{\n" + REPORT_DICT.split("\n", 1)[1] + "}\n"


class RowsOfTheRun(Folder):
    """Runs that took their statistics themselves: rows as the program writes them, made here of the snapshots."""

    def with_rows(self, name):
        run = self.run_of(name, 60, case=False)
        self.case(name, scene=None)
        self.write(name, "system/couplingDict", '#include "$FOAM_CASE/parameters"\n' + STATISTICS)
        records = reporting.opened(run)
        windows = report_scene.Windows(2, 0.0, 0.2, 0.15, 0.1, 0.0, 0.01)
        measured = record_samples.of_snapshots(records, report_scene.Scene(windows, report_scene.Overlaps((0.0025, 0.01), (50,)), None), lambda _: True)
        with h5py.File(os.path.join(run, "results.h5"), "a") as file:
            group = file.create_group("statistics")
            for name_, value in (("count", 2), ("left", 0.0), ("right", 0.2), ("centre", 0.15), ("height", 0.1), ("front", 0.0), ("front_depth", 0.01)):
                group.attrs[f"windows_{name_}"] = float(value)
            group.attrs.update({"overlap_shares": [0.0025, 0.01], "voidage_edges": numpy.linspace(0.3, 1, 29), "voidage_limits": [0.5, 0.95],
                                "voidage_cells": 64.0})
            for at, depth in enumerate(("front_slice", "full_depth")):
                group[f"{depth}_number"], group[f"{depth}_real"] = measured.number[:, at], measured.real[:, at]
                for axis, way in enumerate(("horizontal", "vertical")):
                    group[f"{depth}_{way}_sum"] = measured.sums[:, at, :, axis]
                    group[f"{depth}_{way}_temperature"] = measured.temperatures[:, at, :, axis]
            group["time"], group["spheres"] = measured.time, measured.spheres.astype(float)
            group["overlap_pairs"], group["overlap_largest"] = measured.pairs.astype(float), measured.largest
            group["overlap_counts"], group["overlap_below"] = measured.overlap_counts, measured.below
            group["voidage_counts"] = numpy.tile([0.0] + [2.0] * 28 + [8.0], (60, 1))
            group["voidage_limit_counts"] = numpy.tile([16.0, 40.0, 8.0], (60, 1))
        return run

    @staticmethod
    def numbers(text):
        """The lines of the table that rows and snapshots both have."""
        return [" ".join(line.split()) for line in text.splitlines() if re.search(r"\+-|largest", line) and "voidage" not in line]

    def test_are_reported_as_snapshots_are(self):
        run = self.with_rows("one")
        of_rows, of_snapshots = self.report(run, "--no-write"), self.report(run, "--no-write", "--snapshots")
        self.assertRegex(of_rows, r"rows of /statistics +40")
        self.assertRegex(of_snapshots, r"snapshots +40")
        self.assertEqual(self.numbers(of_rows), self.numbers(of_snapshots))
        self.assertRegex(of_rows, r"mapped voidage below 0.5 \[% of cells\] +25 \+- 0")
        self.assertNotIn("mapped", of_snapshots)

    def test_no_snapshot_is_read(self):
        run = self.with_rows("one")
        os.remove(os.path.join(run, "particles.h5"))
        self.assertRegex(self.report(run), r"rows of /statistics +40")
        samples = Run(run).samples
        self.assertEqual(samples["overlap_counts"].values.shape, (60, 750))

    def test_a_run_without_rows_beside_one_that_has_them(self):
        runs = self.with_rows("one"), self.run_of("two", 60)
        self.assertIn("two without rows of /statistics: all is measured of snapshots", self.report(*runs, "--no-write"))


class WithoutConfiguration(Folder):
    """Runs whose case has no system/reportDict, or one that does not fit."""

    def bare(self, name, *given, domain=None, mesh=None, **how):
        run = self.run_of(name, *given, **how)
        os.remove(os.path.join(run, "system/reportDict"))
        if mesh is None:
            os.remove(os.path.join(run, "system/blockMeshDict"))
        if domain is not None:
            with h5py.File(os.path.join(run, "results.h5"), "r+") as file:
                file["meta"].attrs["domain"] = numpy.array(domain, dtype=float)
        return run

    def test_windows_and_cells_are_the_vessels(self):
        """The vessel is wider than the spheres' box and higher: 0.2 m across, five windows, as high as wide, about z = 0.185 + 0.005 m,
        the mean height; a start-up of 2 s of the pressure drop is left out."""
        run = self.bare("one", 200, domain=[[0, 0, 0], [0.2, 0.1, 0.8]])
        with h5py.File(os.path.join(run, "results.h5"), "r+") as file:
            file["series/pressure_drop"][:40] += 1000
        text = self.report(run)
        found = re.search(r"(?m)^from ([0-9.]+) to 9.95 s \(start-up found by MSER-5: [a-z ]+ settles last\); 5 windows over x = 0 to 0.2 m, "
                         r"z = ([0-9.]+) to ([0-9.]+) m, front slice of 0.001 m", text)
        self.assertTrue(found, text)
        start, low, high = map(float, found.groups())
        self.assertGreaterEqual(start, 2.0)
        self.assertLess(start, 5.0)
        self.assertAlmostEqual(high - low, 0.04, delta=1e-4)
        self.assertAlmostEqual((high + low) / 2, 0.185, delta=0.01)  # 3,000 places, uniform over 0.36 m
        self.assertIn("voidage is of 50 x 25 x 200 cells in the gas mesh's domain, as there is no", text)
        with h5py.File(os.path.join(run, "results.h5"), "r") as file:
            numpy.testing.assert_allclose(file["profiles/window_centre"], [0.02, 0.06, 0.1, 0.14, 0.18])
            self.assertGreater(file["profiles"].attrs["from"], start - 1e-9)

    def test_without_gas_the_box_about_the_spheres(self):
        text = self.report(self.bare("one", 60), "--from", 1)
        self.assertIn("in the box about all spheres", text)
        self.assertNotIn("outside the mesh", text)

    def test_a_mesh_that_is_no_uniform_box(self):
        for old, new, says in (
            ("simpleGrading (1 1 1)", "simpleGrading (1 1 2)", "graded"),
            ("blocks (hex", "blocks (hex (0 1 2 3 4 5 6 7) (1 1 1) simpleGrading (1 1 1) hex", "2 blocks"),
            ("(0 $depth $height)", "(0.1 $depth $height)", "no upright box"),
        ):
            with self.subTest(new):
                run = self.run_of("one", 30)
                self.write("one", "system/blockMeshDict", MESH_DICT.replace(old, new))
                self.assertRegex(self.report(run, "--no-write"), f"note: voidage is of .* cells in the box about all spheres, as .*{says}")
                own = REPORT_DICT.replace("voidage {", "voidage { low (0 0 0); high (0.2 0.1 0.4); cells (4 2 8);")
                self.write("one", "system/reportDict", own)
                self.assertNotIn("voidage is of", self.report(run, "--no-write"))

    def test_a_start_beyond_the_end(self):
        """cases/sscp1 says `from 10`; its first second is reported all the same, nothing of it is trusted, and all is told."""
        run = self.run_of("one", 21)
        for name in ("parameters", "system/couplingDict", "system/blockMeshDict"):
            shutil.copy(os.path.join(CASES, "sscp1", name), os.path.join(run, name))
        text = self.report(run)
        self.assertIn("from 0.5 to 1 s (the latter half, as start-up is not known to be over)", text)
        self.assertRegex(text, r"note: `from` = 10 s of statistics of system/couplingDict is after what there is in all runs, which ends at 1 s")
        self.assertRegex(text, r"A: (\d+) of \1 means have no error that is to be trusted; .* all at [0-9.]+ s")
        self.assertRegex(text, r"bed height \[m\] +0.3 \+- 0 \?")
        self.assertIn("from 0.3 to 1 s (--from)", self.report(run, "--from", 0.3))

    def test_windows_elsewhere(self):
        run = self.run_of("one", 60)
        with h5py.File(os.path.join(run, "results.h5"), "r+") as file:
            file["meta"].attrs["domain"] = [[0, 0, 0], [0.2, 0.1, 0.4]]
        self.write("one", "system/reportDict", REPORT_DICT.replace("centre 0.15", "centre 5"))
        text = self.report(run, "--no-write")
        self.assertRegex(text, r"z = 4.95 to 5.05 m is outside the gas mesh's domain, 0 to 0.4 m; the default is taken")
        self.write("one", "system/reportDict", REPORT_DICT.replace("right $width", "right 0.3"))
        text = self.report(run, "--no-write")
        self.assertRegex(text, r"x = 0 to 0.3 m is partly outside the gas mesh's domain, 0 to 0.2 m\n")
        self.assertIn("2 windows over x = 0 to 0.3 m", text)

    def test_one_snapshot_and_none(self):
        text = self.report(self.bare("one", 1, results=False), "--no-write")
        self.assertRegex(text, r"overlapping pairs per sphere +0.003333 \+- \?")
        self.assertIn("one sample only", text)
        for name in ("none", "empty", "bare"):
            run = self.bare(name, 60)
            os.remove(os.path.join(run, "particles.h5"))
            if name != "none":
                with h5py.File(os.path.join(run, "particles.h5"), "w") as file:
                    if name == "empty":
                        file.create_group("snapshots")
            text = self.report(run)
            self.assertRegex(text, "pressure drop .Pa. +[0-9]")
            self.assertIn("no snapshots were recorded", text)
            self.assertNotIn("overlaps below", text)

    def test_runs_of_other_lengths(self):
        """The longest start-up counts for all; where it ends after the shortest run, that is told."""
        long, short = self.bare("long", 300), self.bare("short", 150, seed=4)
        self.assertRegex(self.report(long, short, "--no-write"), r"^from [0-9.]+ to 7.45 s \(start-up found by MSER-5")
        with h5py.File(os.path.join(long, "results.h5"), "r+") as file:
            file["series/pressure_drop"][:80] += 1000
        text = self.report(long, short, "--no-write", "--from", 4)
        self.assertIn("from 4 to 7.45 s", text)
        shorter = self.bare("shorter", 60, seed=5)
        text = self.report(long, shorter, "--no-write")
        self.assertRegex(text, r"note: long: start-up not known to be over: it ends at [0-9.]+ s, what all runs have at 2.95 s")
        self.assertRegex(text, r"B against A: 0 agree, 0 differ, \d+ not judged")

    def test_what_one_run_says_holds_for_all(self):
        self.bare("a", 60), self.run_of("b", 60), self.bare("c", 60)
        a, b, c = (os.path.join(self.root, name) for name in "abc")
        text = self.report(a, b, c, "--no-write", "--from", 1)
        self.assertIn("note: a and c without a block `statistics`: measured as b says", text)
        alone = self.report(b, "--no-write", "--from", 1)
        self.assertEqual(text.split("; ")[1].splitlines()[0], alone.split("; ")[1].splitlines()[0])  # the same windows

    def test_a_script_gets_the_same_numbers_without_a_report(self):
        run = self.bare("one", 60)
        with open(os.path.join(run, "results.h5"), "rb") as file:
            before = file.read()
        computed = interphase.Run(run).statistics
        with open(os.path.join(run, "results.h5"), "rb") as file:
            self.assertEqual(file.read(), before)
        self.report(run)
        stored = interphase.Run(run).statistics
        self.assertEqual(list(computed), list(stored))
        self.assertIn("profiles/means/pressure_drop", stored)
        for name, each in stored.items():
            numpy.testing.assert_array_equal(computed[name].values, each.values, name)
            self.assertEqual((computed[name].unit, list(computed[name].attributes)), (each.unit, list(each.attributes)))
        with h5py.File(os.path.join(run, "results.h5"), "r+") as file:  # the run goes on
            for name, values in [(name, data[()]) for name, data in file["series"].items()]:
                del file["series"][name]
                file["series"][name] = numpy.append(values, values[-1] + (0.05 if name == "time" else 100))
        later = interphase.Run(run).statistics["profiles/means/pressure_drop"]
        self.assertNotEqual(later.values, stored["profiles/means/pressure_drop"].values)

    def test_vessels_that_differ(self):
        a, b = self.bare("a", 60, domain=[[0, 0, 0], [0.2, 0.1, 0.4]]), self.bare("b", 60, domain=[[0, 0, 0], [0.3, 0.1, 0.4]])
        text = self.report(a, b, "--no-write", "--from", 1)
        self.assertIn("note: the runs' vessels differ (0.2 x 0.1 x 0.4 m; 0.3 x 0.1 x 0.4 m)", text)
        self.assertIn("x = 0 to 0.3 m", text)

    def test_sizes_far_apart(self):
        run = self.bare("one", 30)
        with h5py.File(os.path.join(run, "particles.h5"), "r+") as file:
            for group in file["snapshots"].values():
                group["diameter"][5] = 0.01
        self.assertIn("overlaps are not measured: diameters of 0.001 to 0.01 m", self.report(run, "--no-write", "--from", 1))
        self.write("one", "system/reportDict", "overlaps { }")
        self.assertIn("overlaps below", self.report(run, "--no-write", "--from", 1))

    def test_the_help_has_every_key(self):
        for block, keys in KEYS.items():
            for key in keys:
                self.assertRegex(report_tool.DETAILS, rf"(?m)^ +{key}( \[|  )", f"{block}/{key}")


class Refused(Folder):
    def refused(self, *given, says):
        message = self.report(*given, code=2)
        for words in [says] if isinstance(says, str) else says:
            self.assertRegex(message, words)
        return message

    def test_no_such_run(self):
        self.refused(os.path.join(self.root, "none"), says="no such folder")
        os.makedirs(os.path.join(self.root, "empty"))
        self.refused(os.path.join(self.root, "empty"), says="neither particles.h5 nor results.h5")

    def test_no_results(self):
        run = self.run_of("one", 30, results=False)
        self.refused(run, says=["no results.h5", "--no-write"])
        self.assertIn("note: one: no /series", self.report(run, "--no-write"))

    def test_a_run_that_goes_on_is_left_alone(self):
        run = self.run_of("one", 30, ended=False)
        path = os.path.join(run, "results.h5")
        before = os.stat(path).st_mtime_ns
        self.refused(run, says=["has not recorded its end", "--no-write"])
        holder = subprocess.Popen([sys.executable, "-c", f"f = open({path!r}, 'rb'); print(1, flush=True); input()"],
                                  stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        try:
            holder.stdout.readline()
            self.refused(run, says=[f"process {holder.pid} has it open", "still going"])
        finally:
            holder.communicate("\n")
        self.assertEqual(os.stat(path).st_mtime_ns, before)
        self.report(run, "--no-write")
        self.write("one", "run.json", json.dumps({"exit_code": 1}))
        self.report(run)

    def test_no_snapshots_in_the_range(self):
        run = self.run_of("one", 10)
        self.refused(run, "--from", 0.41, "--until", 0.44, says="no snapshots from 0.41 to 0.44")
        self.refused(run, "--from", 2, "--until", 1, says="is after --until")

    def test_no_such_scene_file(self):
        self.refused(self.run_of("one", 30), "--scene", os.path.join(self.root, "scene"), says="no such file")

    def test_runs_that_measure_different_things(self):
        a, b = self.run_of("a", 30), self.run_of("b", 30)
        self.write("b", "system/reportDict", REPORT_DICT.replace("centre 0.15", "centre 0.2"))
        self.refused(a, b, says=r"do not measure the same \(windows")

    def test_unknown_and_bad_entries_are_told_with_their_line(self):
        run = self.run_of("one", 30)
        for old, new, *says in (
            ("frontDepth", "frontDept", "line 3: windows/frontDept is unknown: did you mean 'frontDepth'"),
            ("overlaps {", "overlap {", "overlap is unknown: did you mean 'overlaps'"),
            ("from 1", "start 1", "start is unknown"),
            ("count 2", "count 2.5", "windows/count = 2.5: a whole number"),
            ("$width", "$widht", r"\$widht is not in this file or .*parameters"),
            ("right $width", "right -1", "is not right of"),
            ("(50 90)", "(50 100)", "between 0 and 100"),
            ("(50 90)", "(90 50)", "must ascend"),
            ("(0.0025 0.01)", "0.01", "a list of numbers in parentheses"),
            ("windows {", "windows 5; other {", "other is unknown|windows must be a block"),
            ("from 1;", "from { }", "from must be a value"),
            ("from 1;", "from 1", "line"),
            ("highest 1", "highest 0.2", "is not above voidage/lowest"),
        ):
            with self.subTest(new):
                self.assertIn(old, REPORT_DICT)
                self.write("one", "system/reportDict", REPORT_DICT.replace(old, new, 1))
                self.refused(run, says=list(says))

    def test_bad_options(self):
        run = self.run_of("one", 30)
        self.refused(run, "--every", 0, says="above 0")
        self.refused(run, "--from", "now", says="'now' is not a time in s")
        self.refused(run, "--out", "picture.gif", says=r"\.png")
        self.refused(run, "--confidence", 95, says="between 0 and 1")
        self.refused(says="Usage")

    def test_particles_that_are_not_finite(self):
        run = self.run_of("one", 30)
        with h5py.File(os.path.join(run, "particles.h5"), "r+") as file:
            file["snapshots/000025/velocity"][3] = numpy.nan
        self.refused(run, says=["000025", "velocity holds NaN", "--until"])
