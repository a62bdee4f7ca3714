# SPDX-License-Identifier: GPL-3.0-or-later
"""A run that is killed at random moments, again and again, and goes on each time, is the run that was not killed: to the last bit, with rows
and snapshots without a seam. Nothing that is older than a second is lost, and nothing is left running."""

import os
import random
import signal
import time

import support
import vessel
from processes import alive, children
from resumed_run import ResumedRun

# What LIGGGHTS itself tells of the step, written out at once: who was how far when.
WITNESS = "variable now equal step*dt\nfix witness all print {every} \"${{now}}\" file witness screen no\n"
PROMISED = 1.0  # [s] on the disk, of the wall clock
LEFT = 10  # [s] within which all ranks are gone


class KilledRun(ResumedRun):
    """With `stop` [s]: the time between two checkpoints."""

    stop = 0.005

    def seen_until(self, folder, program, moment):
        """Waits until `moment`; returns [(by the wall clock, simulated time)] as the witness tells."""
        seen = []
        while time.monotonic() < moment and program.poll() is None:
            lines = support.read(folder, "witness").splitlines() if os.path.exists(os.path.join(folder, "witness")) else []
            if len(lines) > 1:
                seen.append((time.monotonic(), float(lines[-2])))  # the last one may be written just now
            time.sleep(0.02)
        return seen

    def kill(self, folder, ranks, launcher, options, patience):
        """One part of the run: to a random moment after its first checkpoint."""
        program = support.start(folder, ranks, options)
        try:
            begin = time.monotonic()
            before = set(os.listdir(os.path.join(folder, "checkpoints"))) if options else set()
            while not os.path.isdir(os.path.join(folder, "checkpoints")) or not set(
                name for name in os.listdir(os.path.join(folder, "checkpoints")) if name[0] != "."
            ) - before:
                if program.poll() is not None:
                    self.fail(f"the run has ended: {program.communicate()}")
                self.assertLess(time.monotonic() - begin, 120, "no checkpoint comes")
                time.sleep(0.005)
            seen = self.seen_until(folder, program, time.monotonic() + patience)
            processes = [program.pid] if ranks == 1 else children(program.pid)
            os.kill(program.pid if launcher else random.choice(processes), signal.SIGKILL)
            killed = time.monotonic()
            program.communicate(timeout=LEFT + 20)
            while any(map(alive, processes)):
                self.assertLess(time.monotonic(), killed + LEFT, "ranks are left")
                time.sleep(0.02)
        finally:
            program.kill()
            program.stdout.close()
            program.stderr.close()
        rows = support.Finished(folder).column("ledger/time")
        due = max((simulated for moment, simulated in seen if moment < killed - PROMISED), default=0)
        # the step that goes on has no row yet, and the witness speaks of steps of LIGGGHTS within it
        self.assertGreater(rows[-1], due - 1.5 * vessel.GAS_STEP, "rows older than a second are lost")
        return rows[-1]

    def check_killed(self, method, ranks, kills, launcher=False):
        self.end = 1000  # no end but kills
        straight, killed = self.ready(method, ranks)
        for folder in (straight, killed):
            script = os.path.join(folder, "dem/in.liggghts")
            support.write(script, support.read(script) + WITNESS.format(every=1 if method in ("TDHS", "CGHS", "MPPIC") else 20))
        moments = random.Random(f"{method} {ranks}")
        for part in range(kills):
            with self.subTest(method=method, ranks=ranks, part=part):
                self.kill(killed, ranks, launcher, ["-resume"] if part else [], moments.uniform(0, 2.2))
        newest = max(float(name) for name in os.listdir(os.path.join(killed, "checkpoints")) if name[0] != ".")
        self.end = round(newest + self.stop, 9)
        for folder in (straight, killed):
            self.set_entry(folder, "system/controlDict", "endTime", self.end)
        done = self.run_case(killed, ranks, options=["-resume"])
        whole = self.run_case(straight, ranks)
        self.expect_equal([os.path.join(folder, "checkpoints", f"{self.end:.12g}") for folder in (straight, killed)], whole, done, ranks)
        self.assertEqual(len(done.column("parts/time")), kills + 1)
