# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 4
# timeout: 600
"""When checkpoints are written: at the end, by the wall clock, when a signal or a file asks, before the limit of wall-clock time. A run
is not changed by one that it was asked for, and says how it goes on."""

import os
import shutil
import signal
import time

import support
import vessel
from resumed_run import ResumedScene, parts, states

FOR_EVER = 1000  # [s], simulated
DISK, WALL_LIMIT = 6, 8


def checkpoints(folder):
    path = os.path.join(folder, "checkpoints")
    return sorted((name for name in os.listdir(path) if not name.startswith(".")), key=float) if os.path.isdir(path) else []


class Checkpoints(ResumedScene, support.ProgramTest):
    end = 0.02

    def scene(self, method="TDHS", ranks=1, end=None, checkpoint=""):
        folder = vessel.prepared(self, self.bed(method), method, ranks, end or self.end, weight=self.weight(method))
        if checkpoint:
            path = os.path.join(folder, "system/couplingDict")
            support.write(path, support.read(path) + f"\ncheckpoint {{ {checkpoint} }}\n")
        return folder

    def started(self, folder, ranks=1, options=()):
        program = support.start(folder, ranks, options)
        self.addCleanup(program.stdout.close)
        self.addCleanup(program.stderr.close)
        while "t = 0 " not in (line := program.stdout.readline()):
            self.assertTrue(line, "ended before its first step")
        return program

    def wait_for(self, condition, program):
        for _ in range(3000):
            if condition():
                return
            self.assertIsNone(program.poll(), "the run has ended")
            time.sleep(0.01)
        self.fail("nothing came within 30 s")

    def stopped(self, program, number=signal.SIGUSR2):
        program.send_signal(number)
        out, err = program.communicate(timeout=60)
        return program.returncode, out, err

    def goes_on(self, folder, ranks=1):
        newest = float(checkpoints(folder)[-1])
        self.set_entry(folder, "system/controlDict", "endTime", newest + 2 * vessel.GAS_STEP)
        done = self.run_case(folder, ranks, options=["-resume"])
        self.assertIn("the run goes on from checkpoints/", done.err)

    def test_one_at_the_end_by_default(self):
        folder = self.scene()
        done = self.run_case(folder)
        self.assertIn("checkpoints  every 600 s of wall time, and at the end", done.out)
        self.assertEqual(checkpoints(folder), [f"{self.end:g}"])
        again = support.execute(folder, options=[])
        self.assertEqual(again.code, 1)
        self.assertIn("-resume goes on from its last checkpoint", again.err)
        self.run_case(folder, options=["-overwrite"])
        self.assertEqual([name for name in os.listdir(folder) if name.startswith("checkpoints")], ["checkpoints"])

    def test_none_where_none_are_wanted(self):
        folder = self.scene(checkpoint="wallInterval 0;")
        done = self.run_case(folder)
        self.assertIn("checkpoints  none but asked for", done.out)
        self.assertEqual(checkpoints(folder), [])

    def test_by_the_wall_clock(self):
        folder = self.scene(end=FOR_EVER, checkpoint="wallInterval 0.2;")
        program = self.started(folder)
        self.wait_for(lambda: len(checkpoints(folder)) == 2, program)
        self.assertEqual(self.stopped(program)[0], 128 + signal.SIGUSR2)
        self.goes_on(folder)

    def test_asked_by_a_signal(self):
        """Of mpirun, which hands SIGUSR1 on to all; the run goes on."""
        for ranks in (1, 4):
            with self.subTest(ranks=ranks):
                folder = self.scene("CGHS", ranks, FOR_EVER, "wallInterval 0;")
                program = self.started(folder, ranks)
                program.send_signal(signal.SIGUSR1)
                self.wait_for(lambda: len(checkpoints(folder)) == 1, program)  # noqa: B023
                code, out, err = self.stopped(program)
                self.assertEqual(code, 128 + signal.SIGUSR2, out + err)
                self.assertEqual(len(checkpoints(folder)), 1)  # no other at the end
                self.assertIn("The run can go on from checkpoints/", out)
                self.goes_on(folder, ranks)

    def test_signals_that_end_leave_one(self):
        for number, ranks in ((signal.SIGINT, 1), (signal.SIGTERM, 1), (signal.SIGUSR2, 4)):
            with self.subTest(signal=number):
                folder = self.scene("TDHS", ranks, FOR_EVER)
                code, out, err = self.stopped(self.started(folder, ranks), number)
                self.assertEqual(code, 128 + number, out + err)
                self.assertEqual(len(checkpoints(folder)), 1)
                self.goes_on(folder, ranks)

    def test_before_the_limit_of_wall_time(self):
        for ranks in (1, 4):
            with self.subTest(ranks=ranks):
                folder = self.scene("CGHS", ranks, FOR_EVER)
                done = support.execute(folder, ranks, options=["-wallLimit", "3"])
                self.assertEqual(done.code, WALL_LIMIT, done.text)
                self.assertIn("Stopped by its limit of wall-clock time", done.out)
                self.assertEqual(len(checkpoints(folder)), 1)
                self.goes_on(folder, ranks)
        refused = support.execute(self.scene("DEM"), options=["-wallLimit", "-1"])
        self.assertEqual(refused.code, 1)
        self.assertIn("give the seconds that the run may take, above 0", refused.err)

    def test_one_that_is_asked_for_changes_nothing(self):
        """To the last bit: looking at a run does not disturb it."""
        for method, ranks in (("DEM", 1), ("CGPM", 2), ("TDHS", 2), ("MPPIC", 1)):
            with self.subTest(method=method, ranks=ranks):
                plain = self.scene(method, ranks)
                asked = self.copied(plain, f"asked-{method}")
                support.write(os.path.join(asked, "checkpoint"), "")  # as `touch checkpoint`
                for folder in (plain, asked):
                    self.run_case(folder, ranks)
                self.assertEqual(checkpoints(asked), [f"{vessel.GAS_STEP:g}", f"{self.end:g}"])
                for pair in zip(*(states(os.path.join(folder, "checkpoints", f"{self.end:g}"), ranks) for folder in (plain, asked))):
                    expected, found = map(parts, pair)
                    self.assertEqual([name for name in expected if expected[name] != found[name]], [])

    def test_a_disk_without_room_for_one(self):
        """The two before stay, and the run goes on from them when there is room again."""
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                made = self.scene("TDHS", ranks, FOR_EVER, "interval 0.005;")
                folder = os.path.join(self.small_disk("16m"), "case")
                shutil.copytree(made, folder)
                program = self.started(folder, ranks)
                self.wait_for(lambda: len(checkpoints(folder)) == 2, program)  # noqa: B023
                filler = support.fill_disk(folder, free=50000)  # a checkpoint takes 300,000 bytes
                while "checkpoint of t = " not in (line := program.stderr.readline()):
                    self.assertTrue(line, "nothing was said of a checkpoint")
                self.assertIn("could not be written", line)
                kept = checkpoints(folder)
                self.assertEqual(len(kept), 2)
                self.stopped(program)  # the end has room for its fields, or not
                self.assertTrue(set(kept) & set(checkpoints(folder)))
                os.remove(filler)
                self.goes_on(folder, ranks)

    def test_a_disk_that_snapshots_fill(self):
        """What is there can be read, and the run goes on where there is room."""
        made = self.scene("TDHS", 2, FOR_EVER, "interval 0.005;")
        self.set_entry(made, "system/couplingDict", "records/snapshotInterval", vessel.GAS_STEP)
        folder = os.path.join(self.small_disk("12m"), "case")
        shutil.copytree(made, folder)
        full = support.execute(folder, 2)
        self.assertEqual(full.code, DISK, full.text)
        self.assertIn("the disk is full", full.err.rstrip().split("interphase: error:")[-1])
        with full.results() as results:
            self.assertEqual({len(column[:]) for column in results["ledger"].values()}, {len(results["ledger/time"])})
        snapshots = full.snapshots()
        self.assertGreater(len(snapshots), 10)
        counts = [len(each["id"]) for _, each in sorted(snapshots.items())]
        self.assertEqual(counts, sorted(counts))  # spheres are poured in, none is lost
        elsewhere = os.path.join(self.root, "elsewhere")
        shutil.copytree(folder, elsewhere)
        self.goes_on(elsewhere, 2)

    def test_files_that_are_cut_short(self):
        folder = self.scene("CGHS", 2, checkpoint="interval 0.01;")
        self.run_case(folder, 2)
        for file in ("rank1.state", "manifest"):
            with self.subTest(file=file):
                newest = os.path.join(folder, "checkpoints", checkpoints(folder)[-1], file)
                with open(newest, "r+b") as stream:
                    stream.truncate(os.path.getsize(newest) // 2)
                done = self.run_case(folder, 2, options=["-resume"])
                self.assertIn("is no whole checkpoint", done.err)
                self.assertIn("the run goes on from checkpoints/0.01;", done.err)

    def test_an_error_says_how_it_goes_on(self):
        """Before its cause, which stays the last thing on the screen."""
        folder = self.scene("TDHS", checkpoint="interval 0.005;")
        script = os.path.join(folder, "dem/in.liggghts")
        failing = os.path.join(support.BUILD, "tests", "plugins")
        support.write(script, support.read(script) + "fix broken all test/fail all -1 60\n")
        self.edit(folder, "system/couplingDict", r"plugins     \(hard_sphere mp_pic\)", "plugins (hard_sphere mp_pic fail)")
        done = support.execute(folder, INTERPHASE_PLUGIN_PATH=failing + os.pathsep + os.path.join(support.BUILD, "plugins"))
        self.assertNotEqual(done.code, 0)
        self.assertIn("The run can go on from checkpoints/0.0", done.err)
        self.assertLess(done.err.index("The run can go on"), done.err.index("interphase: error"))

    def test_tools_run_with_a_limit(self):
        case, folder = vessel.numbered(self.bed("TDHS"), "TDHS"), os.path.join(self.root, "run")

        def tools_run(*words):
            return support.tool("run", case, "--out", folder, "--no-picture", *words)

        first = tools_run("--until", str(FOR_EVER), "--wall-limit", "3")
        self.assertEqual(first.returncode, WALL_LIMIT, first.stdout + first.stderr)
        self.assertIn(f"--out {folder} --resume", first.stderr)
        newest = float(checkpoints(folder)[-1])
        more = tools_run("--resume", "--until", str(newest + 2 * vessel.GAS_STEP))
        self.assertEqual(more.returncode, 0, more.stdout + more.stderr)
        self.assertEqual(tools_run("--wall-limit", "0").returncode, 2)
