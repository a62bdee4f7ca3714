# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""What a run leaves that ends before its end: whole records after a kill at any moment, and after SIGINT and SIGTERM closed
records, the gas, a summary and an exit code that names the signal. Records of an earlier run are kept.
"""

import os
import random
import shutil
import signal
import time
import xml.etree.ElementTree as xml

import h5py

import support
from processes import alive, children

KILLS = 10  # of each kind; test_survival_long.py does more


class Bed(support.ProgramTest):
    """A bed of parcels with rows and snapshots in every step, so that a run writes much of its time."""

    PARCELS = 1484

    def bed(self, ranks, until=100):
        folder = self.prepared("sscp1", "bed", ranks, until=until, weight=64, initialPacking=0.3)
        self.set_entry(folder, "system/couplingDict", "records/interval", 0.001)
        self.set_entry(folder, "system/couplingDict", "records/snapshotInterval", 0.001)
        return folder

    def started(self, folder, ranks, steps=0, **changes):
        """The run, once it has recorded its start and so many steps, and its ranks' ids."""
        program = support.start(folder, ranks, **changes)
        deadline = time.monotonic() + 60
        while not os.path.isfile(os.path.join(folder, f"snapshots/{steps:06d}.h5")):
            if program.poll() is not None:
                self.fail(f"the run ended before it began: {program.communicate()}")
            self.assertLess(time.monotonic(), deadline, "the run does not begin")
            time.sleep(0.01)
        return program, [program.pid] if ranks == 1 else children(program.pid)

    @staticmethod
    def forget(folder):
        """The records go; the case may be run anew."""
        for name in os.listdir(folder):
            if name.startswith(("results.h5", "particles.")):
                os.remove(os.path.join(folder, name))
        shutil.rmtree(os.path.join(folder, "snapshots"), ignore_errors=True)

    def check_whole(self, folder):
        """All that is there can be read, and what is named is there. Returns the numbers of rows and of snapshots."""
        with h5py.File(os.path.join(folder, "results.h5"), "r") as file:
            self.assertIn("case", file["meta"].attrs)
            for table in ("series", "ledger"):
                lengths = {len(column[:]) for column in file[table].values()} if table in file else set()
                self.assertLessEqual(len(lengths), 1, f"columns of /{table} of different lengths")
            rows = len(file["ledger/time"]) if "ledger" in file else 0
        with h5py.File(os.path.join(folder, "particles.h5"), "r") as file:
            snapshots = [snapshot.attrs["time"] for snapshot in file["snapshots"].values()]
            for snapshot in file["snapshots"].values():
                self.assertEqual({len(snapshot[name][:]) for name in snapshot}, {self.PARCELS})
                self.assertTrue((snapshot["diameter"][:] > 0).all())
                self.assertEqual(set(snapshot["id"][:]), set(range(1, self.PARCELS + 1)))
        if os.path.exists(os.path.join(folder, "particles.xdmf")):
            scene = xml.parse(os.path.join(folder, "particles.xdmf"))
            named = [float(item.get("Value")) for item in scene.iter("Time")]
            self.assertLess(abs(len(named) - len(snapshots)), 2)
            for item in scene.iter("DataItem"):
                file, data_set = item.text.split(":")
                with h5py.File(os.path.join(folder, file), "r") as of:
                    self.assertEqual(" ".join(map(str, of[data_set].shape)), item.get("Dimensions"))
        return rows, len(snapshots)

    def check_kills(self, ranks, launcher, times):
        """Kills one rank, or mpirun, at random moments."""
        folder = self.bed(ranks)
        moments = random.Random(f"{ranks} {launcher}")
        for kill in range(times):
            self.forget(folder)
            program, processes = self.started(folder, ranks)
            time.sleep(moments.uniform(0, 0.5))
            os.kill(program.pid if launcher else moments.choice(processes), signal.SIGKILL)
            program.communicate(timeout=30)
            self.assertNotEqual(program.returncode, 0)
            # Open MPI ends ranks that have lost it when they next look; ten seconds are what a user may wait
            deadline = time.monotonic() + 10
            while any(map(alive, processes)):
                self.assertLess(time.monotonic(), deadline, "ranks are left")
                time.sleep(0.02)
            with self.subTest(kill=kill):
                rows, snapshots = self.check_whole(folder)
                # a step is long before the next, so each snapshot was made after the rows of its step were on disk
                self.assertGreaterEqual(rows + 1, snapshots)
                self.assertGreater(snapshots, 0)


class Kills(Bed):
    def test_of_the_only_rank(self):
        self.check_kills(1, False, KILLS)

    def test_of_one_rank_of_two(self):
        self.check_kills(2, False, KILLS)

    def test_of_mpirun(self):
        self.check_kills(2, True, 3)


class Signals(Bed):
    def check_ended(self, folder, name):
        rows, snapshots = self.check_whole(folder)
        with h5py.File(os.path.join(folder, "results.h5"), "r") as file:
            last = float(file["meta"].attrs["simulated_time"])
            self.assertEqual(file["meta"].attrs["stopped_by"], name)
            self.assertIn("wall_time", file["meta"].attrs)
            self.assertEqual(file["ledger/time"][-1], last)
        self.assertEqual(rows + 1, snapshots)  # the start has a snapshot and no row
        beside = [file for file in os.listdir(folder) if file.endswith((".next", ".kept")) or ".part" in file]
        self.assertEqual(beside, [])
        gas = os.path.join(folder, "processor0" if os.path.isdir(os.path.join(folder, "processor0")) else "")
        times = [float(entry) for entry in os.listdir(gas) if entry[0].isdigit()]
        self.assertAlmostEqual(max(times), last, places=6)

    def check_signal(self, ranks, number, to, name=None, code=None, **changes):
        folder = self.bed(ranks)
        program, processes = self.started(folder, ranks, 3, **changes)
        os.kill(program.pid if to == "launcher" else processes[-1], number)
        out, err = program.communicate(timeout=30)
        name = name or signal.Signals(number).name
        self.assertRegex(out, rf"Stopped by {name} at t = \S+ s of 100 s")
        self.assertRegex(out, "balances")
        self.assertNotIn("error", err.replace("errorcode", ""))
        self.assertEqual(program.returncode, code or 128 + number, out + err)
        self.check_ended(folder, name)

    def test_one_rank_alone(self):
        self.check_signal(1, signal.SIGINT, "rank")
        shutil.rmtree(os.path.join(self.root, "bed"))
        self.check_signal(1, signal.SIGTERM, "rank")

    def test_one_rank_of_two(self):
        self.check_signal(2, signal.SIGTERM, "rank")

    def test_mpirun_hands_on_sigusr2(self):
        self.check_signal(2, signal.SIGUSR2, "launcher")

    def test_mpirun_ends_ranks_by_sigterm_and_gives_them_a_second(self):
        """For SIGINT and SIGTERM mpirun itself has an exit code of its own."""
        self.check_signal(
            2, signal.SIGINT, "launcher", "SIGTERM", 1, OMPI_MCA_odls_base_sigkill_timeout="4")

    def test_a_second_one_ends_at_once(self):
        folder = self.bed(1)
        program, processes = self.started(folder, 1, 3)
        os.kill(program.pid, signal.SIGSTOP)  # both wait for it
        os.kill(program.pid, signal.SIGINT)
        os.kill(program.pid, signal.SIGTERM)
        os.kill(program.pid, signal.SIGCONT)
        out, _ = program.communicate(timeout=30)
        self.assertIn(program.returncode, (-signal.SIGTERM, -signal.SIGINT))  # the kernel chooses which comes first
        self.assertNotIn("Stopped by", out)
        self.check_whole(folder)


class AnotherStart(Bed):
    def test_does_not_wait_for_what_a_killed_run_holds(self):
        """Open MPI's semaphore of a file that several ranks open bears the file's name without its folder; a run that is killed leaves it
        taken. Here is one of every name that a run without names of its own would use."""
        held = [f"/dev/shm/sem.OMPIO_{number:06d}.h5{ending}" for number in range(3) for ending in ("", ".part")]
        if not os.path.isdir("/dev/shm") or any(map(os.path.exists, held)):
            self.skipTest("no place for semaphores")
        for path in held:
            with open(path, "wb") as file:
                file.write(bytes(32))  # its value is 0
            self.addCleanup(os.remove, path)
        for ranks in (1, 2):
            shutil.rmtree(os.path.join(self.root, "bed"), ignore_errors=True)
            self.run_case(self.bed(ranks, until=0.002), ranks, timeout=60)

    def test_keeps_the_records_unless_told_otherwise(self):
        folder = self.bed(1, until=0.003)
        self.run_case(folder)
        kept = {name: support.read(folder, name) for name in ("results.h5", "particles.h5", "log.openfoam")}
        program = support.start(folder)
        _, err = program.communicate(timeout=60)
        self.assertEqual(program.returncode, 1)
        self.assertRegex(err, r"records of an earlier run.*results\.h5 \(4 rows, to t = 0\.003 s\)")
        self.assertRegex(err, r"particles\.h5 \(\d snapshots\)")
        self.assertRegex(err, "-overwrite replaces them")
        self.assertEqual({name: support.read(folder, name) for name in kept}, kept)

        self.set_entry(folder, "system/controlDict", "endTime", 0.002)
        program = support.start(folder, 1, ["-overwrite"])
        out, err = program.communicate(timeout=60)
        self.assertEqual(program.returncode, 0, out + err)
        self.assertEqual(self.check_whole(folder), (2, 3))
        self.assertEqual(len(os.listdir(os.path.join(folder, "snapshots"))), 3)

    def test_may_follow_one_that_came_to_no_step(self):
        folder = self.bed(1, until=0.002)
        with h5py.File(os.path.join(folder, "results.h5"), "w") as file:
            file.create_group("meta")
            file["series/time"] = [0.0]  # its start
        program = support.start(folder)
        out, err = program.communicate(timeout=60)
        self.assertEqual(program.returncode, 0, out + err)
