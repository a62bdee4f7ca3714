# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 900
"""A run that is stopped and goes on from its last checkpoint is the run that was not stopped, to the last bit: all methods, one and two ranks,
for 20 gas steps. And what a resumed run refuses or tells."""

import os
import shutil

import numpy

import support
import test_populations
import vessel
from resumed_run import ResumedMethods, parts, states
from vessel import WIDTH


class Resume(ResumedMethods, support.ProgramTest):
    stop, end = 0.02, 0.04

    def test_second_order_in_time(self):
        """The scheme looks at two steps before, and conditions look at theirs."""
        straight, stopped = self.ready("TDHS")
        for folder in (straight, stopped):
            self.set_entry(folder, "system/fvSchemes", "ddtSchemes/default", "backward")
        self.compare(straight, stopped)

    def test_steps_that_follow_the_flow(self):
        """From a checkpoint of the straight run: one that stops takes other steps to its end."""
        straight, other = self.ready("DEM")
        for folder in (straight, other):
            control = os.path.join(folder, "system/controlDict")
            support.write(control, support.read(control) + "\nadjustTimeStep yes; maxCo 0.1; maxDeltaT 1e-3;\n")
        whole = self.run_case(straight)
        first, last = sorted(os.listdir(os.path.join(straight, "checkpoints")), key=float)
        shutil.copytree(os.path.join(straight, "checkpoints", first), os.path.join(other, "checkpoints", first))
        shutil.copytree(os.path.join(straight, "snapshots"), os.path.join(other, "snapshots"))
        for records in ("results.h5", "particles.h5"):  # to the end: what comes after the checkpoint is made anew
            shutil.copy(os.path.join(straight, records), other)
        done = self.run_case(other, options=["-resume"])
        self.expect_equal([os.path.join(folder, "checkpoints", last) for folder in (straight, other)], whole, done)
        steps = numpy.diff(whole.column("ledger/time"))
        self.assertGreater(steps.max() / steps.min(), 1.2)  # they do follow it

    def test_random_numbers_of_an_inlet(self):
        """They go on; after each checkpoint those of the start would come again."""
        straight, stopped = self.ready("TDHS")
        for folder in (straight, stopped):
            self.edit(folder, "0/U", r"^        type    fixedValue;$",
                      "type turbulentInlet; fluctuationScale (0.1 0.1 0.1); referenceField uniform (0 0 0.8);")  # fmt: skip
        self.compare(straight, stopped)
        drawn = [parts(states(os.path.join(straight, "checkpoints", f"{time:g}"), 1)[0]) for time in (self.stop, self.end)]
        (name,) = (name for name in drawn[0] if "/random " in name)
        self.assertNotEqual(drawn[0][name], drawn[1][name])

    def test_without_gas(self):
        straight, stopped = self.ready("CGPM", **{"system/couplingDict:gas/model": "none", "system/couplingDict:gas/coupling": "oneWay"})
        self.compare(straight, stopped)

    def test_a_stream_through_a_face_and_an_outlet(self):
        """A mesh draws places with random numbers of its own, another deletes."""
        self.count = 0
        for method in ("TDHS", "DEM"):
            with self.subTest(method=method):
                root = os.path.join(self.root, method)
                lines, _ = vessel.bed(6, above=4)
                fixes = test_populations.spheres() + test_populations.STREAM + test_populations.outlet()
                folder = vessel.case(root, lines, fixes)
                test_populations.write_plane(os.path.join(folder, "dem/face.stl"), 0.085, 0.01, WIDTH - 0.01)
                test_populations.write_plane(os.path.join(folder, "dem/outlet.stl"), 0.01)
                self.compare(*self.copies(folder, method))

    def test_is_asked_for_and_refused(self):
        folder, _ = self.ready("TDHS")
        self.edit(folder, "system/couplingDict", r"^checkpoint .*$", "checkpoint { wallInterval 0; }")
        self.set_entry(folder, "system/controlDict", "endTime", self.stop)
        nothing = support.execute(folder, options=["-resume"])
        self.assertEqual(nothing.code, 1)
        self.assertIn("there is no checkpoint to go on from", nothing.err)

        support.write(os.path.join(folder, "checkpoint"), "")  # as `touch checkpoint`
        self.run_case(folder)
        self.assertFalse(os.path.exists(os.path.join(folder, "checkpoint")))
        (name,) = os.listdir(os.path.join(folder, "checkpoints"))
        self.assertAlmostEqual(float(name), vessel.GAS_STEP, delta=1e-9)  # after the first step

        self.set_entry(folder, "system/controlDict", "endTime", self.end)
        self.edit(folder, "parameters", "inletVelocity( +)0.8", "inletVelocity 0.9")
        other = support.execute(folder, options=["-resume"])
        self.assertEqual(other.code, 1)
        self.assertIn("the case is not as it was when checkpoints/0.001 was written", other.err)
        self.assertIn("parameters, inletVelocity: 0.9, and was 0.8", other.err)
        self.assertIn("-resume", other.err)

    def test_plug_ins_built_anew_matter_where_their_fixes_are(self):
        built = os.path.join(self.root, "built")
        shutil.copytree(os.path.join(support.BUILD, "plugins"), built, ignore=lambda _, names: [name for name in names if not name.endswith(".so")])
        for method, refused in (("DEM", False), ("TDHS", True)):
            with self.subTest(method=method):
                folder, _ = self.ready(method)
                self.set_entry(folder, "system/controlDict", "endTime", self.stop)
                self.run_case(folder, INTERPHASE_PLUGIN_PATH=built)
                with open(os.path.join(built, "libhard_sphere.so"), "ab") as file:
                    file.write(b"\0")  # behind all that is read of a library
                self.set_entry(folder, "system/controlDict", "endTime", self.end)
                again = support.execute(folder, options=["-resume"], INTERPHASE_PLUGIN_PATH=built)
                self.assertEqual(again.code, 1 if refused else 0, again.err)
                self.assertEqual("plug-in hard_sphere is another build" in again.err, refused)
                self.assertNotIn("mp_pic is another", again.err)

    def test_goes_on_before_what_is_torn(self):
        folder, _ = self.ready("TDHS")
        self.edit(folder, "system/couplingDict", "^checkpoint .*$", "checkpoint { interval 0.005; }")
        self.set_entry(folder, "system/controlDict", "endTime", self.stop)
        self.run_case(folder)
        self.assertEqual(sorted(os.listdir(os.path.join(folder, "checkpoints"))), ["0.015", "0.02"])
        newest = os.path.join(folder, "checkpoints/0.02/rank0.state")
        with open(newest, "r+b") as stream:
            stream.seek(os.path.getsize(newest) // 2)
            byte = stream.read(1)[0]
            stream.seek(-1, os.SEEK_CUR)
            stream.write(bytes([byte ^ 4]))
        done = self.run_case(folder, options=["-resume"])
        self.assertIn("checkpoints/0.02 is no whole checkpoint: rank0.state is not as it was written", done.err)
        self.assertIn("the run goes on from checkpoints/0.015", done.err)
        numpy.testing.assert_allclose(done.column("ledger/time"), vessel.GAS_STEP * numpy.arange(1, 21), atol=1e-9)
        numpy.testing.assert_allclose(done.column("parts/time"), [0, 0.015], atol=1e-9)
        series = done.column("series/time")
        self.assertEqual(series[0], 0, "the start has a row")
        self.assertTrue((numpy.diff(series) > 0).all(), "and none is there twice")
        self.assertEqual(len(done.snapshots()), 2)  # of start and end; that of the first part's end has made way

    def test_tools_run_goes_on(self):
        case, folder = vessel.numbered(self.bed("TDHS"), "TDHS"), os.path.join(self.root, "run")
        coupling = os.path.join(case, "system/couplingDict")
        support.write(coupling, support.read(coupling) + f"\ncheckpoint {{ interval {self.stop}; }}\n")

        def tools_run(*words):
            return support.tool("run", case, "--out", folder, "--no-picture", *words)

        early = tools_run("--resume")
        self.assertEqual(early.returncode, 2)
        self.assertIn("holds no run of tools/run", early.stderr)
        first = tools_run("--until", str(self.stop))
        self.assertEqual(first.returncode, 0, first.stdout + first.stderr)
        more = tools_run("--resume", "--until", str(self.end))
        self.assertEqual(more.returncode, 0, more.stdout + more.stderr)
        self.assertIn(f"Reached t = {self.end} s", more.stdout)
        self.assertIn(f"Reached t = {self.end} s", support.read(folder, "log.interphase-2"))
        self.assertEqual(tools_run("--resume", "--overwrite").returncode, 2)

    def test_of_a_run_at_its_end_adds_nothing(self):
        folder, _ = self.ready("TDHS")
        self.set_entry(folder, "system/controlDict", "endTime", self.stop)
        done = self.run_case(folder)
        before = done.table("series")
        snapshots = sorted(done.snapshots())
        again = self.run_case(folder, options=["-resume"])
        self.assertIn(f"Reached t = {self.stop} s", again.out)
        for name, column in before.items():
            self.assertEqual(column.tobytes(), again.column(f"series/{name}").tobytes(), name)
        self.assertEqual(sorted(again.snapshots()), snapshots)

    def test_what_moves_is_told(self):
        """A scene whose state cannot be held runs on, without checkpoints."""
        folder, _ = self.ready("DEM")
        script = os.path.join(folder, "dem/in.liggghts")
        support.write(script, support.read(script) + "fix squeeze all deform 1 z scale 1.0\n")
        self.set_entry(folder, "system/controlDict", "endTime", self.stop)
        done = self.run_case(folder)
        self.assertIn("a checkpoint cannot hold fix squeeze (deform)", done.err)
        self.assertFalse(os.path.exists(os.path.join(folder, "checkpoints")))
