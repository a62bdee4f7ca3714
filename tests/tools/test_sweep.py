# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 300
"""tools/sweep: which runs it makes, keeps and goes on with, how it ends them, and what it says of their means.

A script stands in for interphase: its pressure drop is 100 times the velocity, plus the seed, plus noise that is known.
"""

import csv
import json
import math
import os
import shutil
import signal
import subprocess
import time
import unittest

from interphase import sweep_figure, sweep_plan, sweep_runs, sweep_table
from interphase.input_error import InputError
from interphase.series import Average
from interphase.tree import TOOLS
from scratch import InFolder, write


PARAMETERS = """method CGPM;
weight 8;
velocity 2;
seed 1;
deed end;     // end | fail | wait | wave
endTime 1;
"""

COUPLING = """#include "$FOAM_CASE/parameters"
method $method;
weight $weight;
particles { script "dem/in.liggghts"; }
gas { model none; }
"""

STAND_IN = """#!/usr/bin/python3
import os, signal, sys, time
import h5py, numpy
from interphase import parameters
folder, resumed = sys.argv[sys.argv.index("-case") + 1], "-resume" in sys.argv
os.chdir(folder)
value = parameters.read("parameters")
until = float(parameters.read("system/controlDict")["endTime"].replace("$endTime", value["endTime"]))
print("t = 0.25      s    25 %", flush=True)
with open("calls", "a") as file:
    file.write("resume\\n" if resumed else "start\\n")
if value["deed"] == "fail":
    print("interphase: error: the bed has burst", flush=True)
    sys.exit(3)
if value["deed"] == "wait" and not resumed:
    os.makedirs("checkpoints/1")
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    open("waits", "w").close()
    time.sleep(60)
    sys.exit(7)
time_ = numpy.linspace(0, until, 201)
noise = numpy.random.default_rng(int(float(value["seed"]) * 1000)).normal(0, 0.5, 201)
drop = 100 * float(value["velocity"]) + float(value["seed"]) + noise * (value["deed"] != "wave")
drop[time_ < until / 2] = -1e6  # what is left out of the mean
with h5py.File("results.h5", "w") as file:
    file.create_group("meta").attrs["version"] = "1"
    for name, unit, values in (("time", "s", time_), ("pressure_drop", "Pa", drop), ("particles", "1", 0 * drop + 10)):
        file.create_dataset("series/" + name, data=values).attrs["unit"] = unit
"""


class Bench(InFolder):
    def setUp(self):
        super().setUp()
        self.case, self.out = os.path.join(self.root, "bed"), os.path.join(self.root, "out")
        write(os.path.join(self.case, "parameters"), PARAMETERS)
        write(os.path.join(self.case, "system/couplingDict"), COUPLING)
        write(os.path.join(self.case, "system/controlDict"), '#include "$FOAM_CASE/parameters"\nendTime $endTime;\n')
        write(os.path.join(self.case, "dem/in.liggghts"), "units si\n")
        self.binary = os.path.join(self.root, "interphase")
        write(self.binary, STAND_IN, executable=True)

    def command(self, *given):
        return [os.path.join(TOOLS, "sweep"), "bed", *given, "--out", self.out]

    def environment(self):
        return {**os.environ, "INTERPHASE_BIN": self.binary, "COLUMNS": "200"}

    def sweep(self, *given, code=0):
        done = subprocess.run(self.command(*given), env=self.environment(), cwd=self.root, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              timeout=120)  # fmt: skip
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done.stdout + done.stderr

    def runs(self):
        """{name: [start, resume, ...]} of the runs that were made."""
        found = {}
        for name in sorted(os.listdir(self.out)):
            calls = os.path.join(self.out, name, "calls")
            if os.path.exists(calls):
                with open(calls, encoding="utf-8") as stream:
                    found[name] = stream.read().split()
        return found

    def rows(self):
        with open(os.path.join(self.out, "sweep.csv"), encoding="utf-8", newline="") as stream:
            return list(csv.DictReader(stream))


class Refused(Bench):
    def test_before_anything_runs(self):
        for given, words in (
            (("--set", "velocty=1,2"), "did you mean 'velocity'"), (("--set", "velocity=1,,2"), "with commas between them"),
            (("--set", "velocity=1,1"), "1 is there twice"), (("--method", "CGPM,CGHX"), "method 'CGHX' is unknown"),
            (("--method", "DEM", "--weight", "8"), "does not go with method DEM"), (("--set", "seed=1,2", "--seeds", "2"), "--seeds and --set seed"),
            (("--seeds", "0"), "--seeds: '0' is not a whole number above 0"), (("--after", "-1"), "is not a time in s, 0 or above"), (("--after", "1"), "the runs end at 1 s"), (("--set", "method=DEM,CGPM"), "give --method DEM,CGPM"),
            (("--jobs", "1000"), "--jobs 1000 of 1 ranks"), (("--until", "2", "--set", "endTime=1,2"), "--until and an end time by --set"),
            (("--set", "mapping/widht=1"), "did you mean 'mapping/width'"), (("--method", "DEM,TDHS"), "plug-in"),
        ):  # fmt: skip
            with self.subTest(given):
                self.assertIn(words, self.sweep(*given, code=2))
                self.assertFalse(os.path.exists(self.out))

    def test_seeds_of_a_case_without_one(self):
        write(os.path.join(self.case, "parameters"), PARAMETERS.replace("seed 1;\n", ""))
        message = self.sweep("--seeds", "2", code=2)
        self.assertIn("has no entry `seed`", message)
        self.assertIn("add `seed 1;`", message)

    def test_another_case_in_the_folder_of_a_sweep(self):
        self.sweep("--set", "velocity=1")
        write(os.path.join(self.case, "dem/in.liggghts"), "units si\n# another scene\n")
        self.assertIn("no longer those that its runs were made of", self.sweep("--set", "velocity=1", code=2))
        shutil.copytree(self.case, os.path.join(self.root, "other"))
        command = self.command("--set", "velocity=1")
        command[1] = "other"
        done = subprocess.run(command, env=self.environment(), cwd=self.root, capture_output=True, text=True, timeout=60)
        self.assertIn("holds a sweep of", done.stderr)

    def test_a_shorter_end_than_that_of_what_is_there(self):
        self.sweep("--set", "velocity=1")
        self.assertIn("a run to t = 1 s, longer than the 0.5 s", self.sweep("--set", "velocity=1", "--until", "0.5", code=2))


class Made(Bench):
    def test_the_product_of_all_lists_with_means_over_seeds(self):
        said = self.sweep("--set", "velocity=1,2", "--method", "DEM,CGPM", "--seeds", "3", "--set", "mapping/width=0.1")
        self.assertEqual(sorted(self.runs()), sorted(f"velocity-{v}_{m}_seed-{s}" for v in (1, 2) for m in ("DEM-w1", "CGPM-w8") for s in (1, 2, 3)))
        with open(os.path.join(self.out, "velocity-1_DEM-w1_seed-2", "system", "couplingDict"), encoding="utf-8") as stream:
            self.assertIn("width 0.1;", stream.read())
        rows = [row for row in self.rows() if row["quantity"] == "pressure_drop"]
        self.assertEqual([(row["velocity"], row["method"], row["runs"], row["unit"]) for row in rows],
                         [(v, m, "3", "Pa") for m in ("DEM", "CGPM") for v in ("1", "2")])  # fmt: skip
        for row in rows:
            # Seeds 1, 2, 3 shift it by as much: mean 2, deviation 1. Noise of a mean over 101 rows: 0.05, of three such means 0.03.
            self.assertAlmostEqual(float(row["mean"]), 100 * float(row["velocity"]) + 2, delta=5 * 0.03)
            self.assertAlmostEqual(float(row["standard_error"]), 1 / math.sqrt(3), delta=0.1)
            self.assertAlmostEqual(float(row["error_within"]), 0.5 / math.sqrt(303), delta=0.015)
        self.assertRegex(said, r"velocity  method  W  runs  pressure_drop \[Pa\]")
        self.assertIn("velocity-1_CGPM-w8_seed-1 recorded the same as velocity-1_DEM-w1_seed-1 to the last bit: what tells them apart changed nothing (and 5", said)
        self.assertNotIn("particles [1]", said, "a constant is no result of a sweep")
        self.assertTrue(os.path.getsize(os.path.join(self.out, "sweep.png")))

    def test_what_is_there_is_kept_and_lists_may_grow(self):
        self.sweep("--set", "velocity=1", "--set", "endTime=2")
        self.sweep("--set", "velocity=1,2,3", "--set", "endTime=2")
        said = self.sweep("--set", "velocity=1,2", "--set", "endTime=2")
        self.assertIn("2 there", said)
        self.assertEqual(list(self.runs().values()), [["start"]] * 3)

    def test_other_fixed_values_are_other_runs(self):
        self.sweep("--set", "velocity=1")
        self.sweep("--set", "velocity=2")
        self.assertEqual(list(self.runs().values()), [["start"]] * 2)
        self.assertAlmostEqual(float(next(row["mean"] for row in self.rows() if row["quantity"] == "pressure_drop")), 201, delta=0.25)  # 5 errors

    def test_a_later_end_goes_on_where_there_is_a_checkpoint(self):
        self.sweep("--set", "velocity=1,2")
        os.makedirs(os.path.join(self.out, "velocity-1_CGPM-w8", "checkpoints", "1"))
        self.sweep("--set", "velocity=1,2", "--until", "2")
        self.assertEqual(list(self.runs().values()), [["start", "resume"], ["start"]])

    def test_seeds_that_change_nothing_count_once(self):
        program = STAND_IN.replace('value = parameters.read("parameters")', 'value = {**parameters.read("parameters"), "seed": "1"}')
        write(self.binary, program, executable=True)
        said = self.sweep("--seeds", "2")
        self.assertIn("CGPM-w8_seed-2 recorded the same as CGPM-w8_seed-1 to the last bit: what tells them apart changed nothing; counted once", said)
        self.assertEqual({row["runs"] for row in self.rows()}, {"1"})


class Holes(Bench):
    def test_a_failed_run_is_one_with_its_cause_and_the_others_go_on(self):
        said = self.sweep("--set", "deed=fail,end", "--set", "velocity=1,2", code=1)
        self.assertIn("failed: deed-fail_velocity-1_CGPM-w8: interphase: error: the bed has burst", said)
        self.assertIn("2 of 4 runs failed; --retry tries them again", said)
        self.assertEqual([(row["deed"], row["runs"]) for row in self.rows() if row["quantity"] in ("", "pressure_drop")],
                         [("fail", "0"), ("fail", "0"), ("end", "1"), ("end", "1")])  # fmt: skip
        self.sweep("--set", "deed=fail,end", "--set", "velocity=1,2", code=1)
        self.assertEqual({name: calls for name, calls in self.runs().items() if "fail" in name and len(calls) > 1}, {})
        # Where its cause is mended, another try is a run from the start
        write(self.binary, STAND_IN.replace('== "fail"', '== "never"'), executable=True)
        said = self.sweep("--set", "deed=fail,end", "--set", "velocity=1,2", "--retry")
        self.assertNotIn("failed:", said)
        self.assertEqual(set(map(tuple, self.runs().values())), {("start",)})

    def test_a_step_before_the_program_too(self):
        write(os.path.join(self.case, "prepare"), "#!/bin/sh\ngrep -q 'velocity 1' parameters && echo no room && exit 1\nexit 0\n", executable=True)
        said = self.sweep("--set", "velocity=1,2", code=1)
        self.assertRegex(said, r"failed: velocity-1_CGPM-w8: prepare failed \(exit code 1\).*no room")
        self.assertEqual(list(self.runs()), ["velocity-2_CGPM-w8"])


class Stopped(Bench):
    def begun(self, *given, waiting=1):
        sweep = subprocess.Popen(self.command(*given), env=self.environment(), cwd=self.root, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, text=True, start_new_session=True)  # fmt: skip
        limit = time.monotonic() + 60
        while time.monotonic() < limit:
            there = [name for name in (os.listdir(self.out) if os.path.isdir(self.out) else []) if os.path.exists(os.path.join(self.out, name, "waits"))]
            if len(there) == waiting:
                return sweep
            time.sleep(0.05)
        sweep.kill()
        self.fail(f"the run did not begin: {sweep.communicate()[0]}")

    def test_in_good_order_and_gone_on_with(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number):
                shutil.rmtree(self.out, ignore_errors=True)
                given = ("--set", "velocity=1,2", "--set", "deed=wait", "--jobs", "1")
                sweep = self.begun(*given)
                sweep.send_signal(number)
                said = sweep.communicate(timeout=60)[0]
                self.assertEqual(sweep.returncode, 130, said)
                self.assertIn("The same command goes on", said)
                with open(os.path.join(self.out, "velocity-1_CGPM-w8", "run.json"), encoding="utf-8") as stream:
                    self.assertEqual(json.load(stream)["exit_code"], 143)
                write(self.binary, STAND_IN.replace('"deed"] == "wait"', '"deed"] == "never"'), executable=True)
                said = self.sweep(*given)
                self.assertIn("1 to go on, 1 to make", said)
                self.assertEqual(list(self.runs().values()), [["start", "resume"], ["start"]])
                write(self.binary, STAND_IN, executable=True)

    def test_by_a_quantity_that_the_runs_do_not_record(self):
        """Seen by the first one: the others are not made."""
        given = ("--set", "velocity=1,2,3", "--jobs", "1")
        said = self.sweep(*given, "--quantity", "presure_drop", code=2)
        self.assertRegex(said, "tools/sweep: error: --quantity presure_drop: .* has no 'presure_drop': did you mean 'pressure_drop'")
        self.assertEqual(list(self.runs().values()), [["start"]])
        self.assertIn("has no 'x'", self.sweep(*given, "--quantity", "x", code=2))  # of a run that is there: none is begun
        self.assertEqual(list(self.runs().values()), [["start"]])
        self.assertIn("1 there, 2 to make", self.sweep(*given, "--quantity", "pressure_drop"))

    def test_two_sweeps_of_one_folder_are_refused_and_a_killed_one_is_taken_up(self):
        given = ("--set", "velocity=1", "--set", "deed=wait", "--jobs", "1")
        sweep = self.begun(*given)
        self.assertIn("another tools/sweep is at work", self.sweep(*given, code=2))
        sweep.kill()
        sweep.wait(timeout=60)
        sweep.stdout.close()  # its run still has it
        again = subprocess.Popen(self.command(*given), env=self.environment(), cwd=self.root, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, text=True, start_new_session=True)  # fmt: skip
        self.assertIn("1 running", again.stdout.readline())
        again.send_signal(signal.SIGTERM)
        said = again.communicate(timeout=60)[0]
        self.assertEqual(again.returncode, 130, said)
        self.assertEqual(list(self.runs().values()), [["start"]])


class Parts(unittest.TestCase):
    def test_lists(self):
        self.assertEqual(sweep_plan.listed("1, 2,(3 4),(a,b)"), ["1", "2", "(3 4)", "(a,b)"])
        for text in ("", "1,", "(1", "1)"):
            with self.subTest(text), self.assertRaises(InputError):
                sweep_plan.listed(text)

    def test_names_that_openfoam_bears(self):
        self.assertEqual(sweep_plan.folder_name(["system/couplingDict:drag/law-BVK", "cells-(2 2 32)", "DEM-w1"]), "drag-law-BVK_cells-2-2-32_DEM-w1")

    def test_errors_of_several_runs(self):
        def of(*means, error=0.1, reason=""):
            return sweep_table._cell("p", [Average(mean, error, "Pa", 50, reason) for mean in means])
        one = of(3.0, reason="it drifts")
        self.assertEqual((one.mean, one.error, one.reason), (3.0, 0.1, "it drifts"))
        near, far = of(3.0, 3.0), of(1.0, 3.0)
        self.assertAlmostEqual(near.error, 0.1 / math.sqrt(2))  # two means that agree by luck are not known exactly
        self.assertAlmostEqual(far.error, math.sqrt(2) / math.sqrt(2))
        three = of(1.0, 2.0, 3.0, error=math.nan, reason="too short")
        self.assertAlmostEqual(three.error, 1 / math.sqrt(3))
        self.assertEqual(three.reason, "", "the scatter of three runs stands by itself")
        self.assertEqual(str(of(3.0, error=math.nan, reason="too short")), "3 +- ?")

    def test_one_run_without_a_mean_leaves_none_of_the_others(self):
        cell = sweep_table._cell("p", [Average(1.0, 0.1, "Pa", 50), InputError("p is not finite in 3 rows")])
        self.assertTrue(math.isnan(cell.mean))
        self.assertIn("not finite", cell.reason)

    def test_the_axis_of_the_figure(self):
        def row(law, velocity, method):
            return sweep_table.Row({"law": law, "velocity": velocity}, method, 1, 1)
        rows = [row(law, velocity, method) for law in ("BVK", "Ergun") for velocity in ("1", "2") for method in ("DEM", "TDHS")]
        name, lines = sweep_figure.lines_of(rows)
        self.assertEqual(name, "velocity")
        self.assertEqual(list(lines), ["DEM, law = BVK", "TDHS, law = BVK", "DEM, law = Ergun", "TDHS, law = Ergun"])
        self.assertEqual([x for x, _ in lines["DEM, law = BVK"]], [1, 2])

    def test_time_left(self):
        self.assertEqual([sweep_runs.duration(each) for each in (39.4, 725, 10930)], ["0:39", "12:05", "3:02:10"])
