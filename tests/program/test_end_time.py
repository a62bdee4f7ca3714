# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""`endTime` changed in system/controlDict while the run goes on: outputs of LIGGGHTS, progress and records follow."""

import os
import re
import time

import gas_box
import support

# Steps of 1e-4 s in gas steps of 1e-3 s.
OUTPUTS = """dump states all custom 30 dem/states.dump id x
restart 60 dem/restart.*
thermo 25
variable every equal stride(0,100000,40)
dump more all custom 10 dem/more.dump id x
dump_modify more every v_every
"""


class EndTime(support.ProgramTest):
    def run_changed(self, before, after, at, ranks=1, more=""):
        """A run to `before` whose control file says `after` from time `at` on [s]."""
        folder = gas_box.write(os.path.join(self.root, f"case{len(os.listdir(self.root))}"), end=before)
        control = os.path.join(folder, "system/controlDict")
        update = (f'functions {{ change {{ type timeActivatedFileUpdate; libs (utilityFunctionObjects); fileToUpdate "{control}"; '
                  f'timeVsFile (({at} "{control}.after")); }} }}\n')  # fmt: skip
        first = support.read(control).replace("runTimeModifiable no", "runTimeModifiable yes") + update
        support.write(control, first)
        support.write(control + ".after", first.replace(f"endTime {before};", f"endTime {after}; {more}"))
        os.utime(control, (time.time() - 100,) * 2)  # OpenFOAM takes files within 10 s of each other for the same
        script = os.path.join(folder, "dem/in.liggghts")
        support.write(script, support.read(script) + OUTPUTS)
        if ranks > 1:
            support.must(folder, "decomposePar")
        return self.run_case(folder, ranks)

    def check(self, done, end):
        """Everything up to `end` [s], as of a run that had it from the start."""
        steps = round(end / 1e-4)
        dump = support.read(done.path("dem/states.dump"))
        self.assertEqual([int(n) for n in re.findall(r"TIMESTEP\n(\d+)", dump)], list(range(0, steps + 1, 30)))
        by_variable = support.read(done.path("dem/more.dump"))
        self.assertEqual([int(n) for n in re.findall(r"TIMESTEP\n(\d+)", by_variable)], list(range(40, steps + 1, 40)))
        restarts = sorted(int(name.split(".")[1]) for name in os.listdir(done.path("dem")) if name.startswith("restart."))
        self.assertEqual(restarts, list(range(60, steps + 1, 60)))
        log = support.read(done.path("dem/log.liggghts"))
        thermo = [int(n) for n in re.findall(r"^ +(\d+) +1 ", log[log.rindex("KinEng"):], re.M)]
        self.assertEqual([n for n in thermo if n % 25 == 0], list(range(0, steps + 1, 25)))
        self.assertEqual(len(set(thermo)), len(thermo))

        shares = [int(n) for n in re.findall(r"^t = .* s +(-?\d+) % .* ETA \d+:\d\d ", done.out, re.M)]
        self.assertEqual(len(shares), len(re.findall("^t = ", done.out, re.M)), done.out)
        self.assertTrue(all(0 <= share <= 100 for share in shares), shares)
        self.assertEqual(shares[-1], 100)
        self.assertAlmostEqual(max(done.snapshots()), end, delta=1e-9)
        self.assertAlmostEqual(done.column("series/time")[-1], end, delta=1e-9)
        return thermo

    def test_raised(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                done = self.run_changed(0.01, 0.03, at=0.005, ranks=ranks)
                self.assertIn("the end is now at t = 0.03 s, no longer at 0.01 s", done.out)
                self.check(done, 0.03)

    def test_lowered(self):
        done = self.run_changed(0.03, 0.01, at=0.005)
        self.check(done, 0.01)

    def test_lowered_to_what_has_passed(self):
        """The run ends after the step in which it learns of it, with its last state on disk."""
        done = self.run_changed(0.03, 0.002, at=0.005)
        reached = max(done.snapshots())
        self.assertGreaterEqual(reached, 0.005 - 1e-9)
        self.assertLess(reached, 0.008)  # a few gas steps later
        self.check(done, round(reached, 6))
        self.assertTrue(os.path.isdir(done.path(f"{reached:.10g}")), os.listdir(done.folder))

    def test_stop_and_write_now(self):
        """OpenFOAM knows no end then until it is there."""
        done = self.run_changed(0.03, 0.03, at=0.005, more="stopAt writeNow;")
        reached = max(done.snapshots())
        self.assertLess(reached, 0.008)
        self.assertTrue(os.path.isdir(done.path(f"{reached:.10g}")), os.listdir(done.folder))
