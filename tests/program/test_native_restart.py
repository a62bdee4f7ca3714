# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 300
"""What people know works, too: gas from OpenFOAM's time folder (startFrom latestTime), particles from LIGGGHTS's restart file (read_restart)
of the same time."""

import os
import re
import shutil

import numpy

import support
import vessel

TIME, END = 0.02, 0.03  # [s]
SOLID_STEP = 5e-6  # [s]
STEP = round(TIME / SOLID_STEP)


class NativeRestart(support.ProgramTest):
    def first(self, ranks=1):
        """A run that wrote its gas and its particles at TIME, and a case that is to start from there."""
        lines, _ = vessel.bed(6)
        folder = vessel.prepared(self, vessel.case(self.root, particles=lines), "DEM", ranks, END)
        self.edit(folder, "system/couplingDict", r"^ +variables", f"    solidStep {SOLID_STEP}; variables")
        self.set_entry(folder, "system/controlDict", "writeInterval", TIME)
        self.edit(folder, "system/couplingDict", r"snapshotInterval .*$", f"snapshotInterval {TIME};")
        script = os.path.join(folder, "dem/in.liggghts")
        support.write(script, support.read(script) + f"restart {STEP // 2} dem/restart.*\ndump each all custom {STEP} dem/each.txt id type\n")
        whole = self.run_case(folder, ranks)

        later = self.copied(folder, "later")
        for name in ("results.h5", "particles.h5", "particles.xdmf"):
            os.remove(os.path.join(later, name))
        shutil.rmtree(os.path.join(later, "snapshots"))
        self.set_entry(later, "system/controlDict", "startFrom", "latestTime")
        text = support.read(later, "dem/in.liggghts")
        start, end = text.index("region "), text.index("include ")
        support.write(os.path.join(later, "dem/in.liggghts"), text[:start] + f"read_restart dem/restart.{STEP}\n" + text[end:])
        for folder in ["", *(f"processor{rank}" for rank in range(ranks) if ranks > 1)]:
            for name in os.listdir(os.path.join(later, folder)):
                if re.fullmatch(r"[0-9.]+", name) and float(name) > TIME:
                    shutil.rmtree(os.path.join(later, folder, name))
        return whole, later

    def check(self, ranks):
        whole, later = self.first(ranks)
        done = self.run_case(later, ranks)
        self.assertNotIn("no time", done.err)
        expected, found = whole.snapshots(), done.snapshots()
        (before,) = (time for time in expected if abs(time - TIME) < 1e-9)
        self.assertEqual(min(found), TIME)
        for name in ("position", "velocity", "angular_velocity"):  # LIGGGHTS writes doubles
            self.assertEqual(expected[before][name].tobytes(), found[TIME][name].tobytes(), name)
        first, second = whole.table("series"), done.table("series")
        self.assertEqual(second["time"][0], TIME)  # the start, as the first step finds it
        self.assertEqual(second["lowest_voidage"][0], second["lowest_voidage"][1])
        row = int(numpy.argmin(abs(first["time"] - second["time"][1])))
        self.assertEqual(second["lowest_voidage"][1], first["lowest_voidage"][row])
        # the two files lack what a step owes the next and how far particles had relaxed: 0.8 % of the first drop, then 0.3 %
        for later_row, share in ((0, 0.02), (1, 0.01)):
            drop = first["pressure_drop"][row + later_row]
            self.assertAlmostEqual(second["pressure_drop"][1 + later_row], drop, delta=share * drop)
        self.assert_books_close(done, ("momentum", "volume", "gas_volume", "solids"), 1e-13)
        frames = re.findall(r"ITEM: TIMESTEP\n(\d+)", support.read(later, "dem/each.txt"))
        self.assertEqual(frames, ["0", str(STEP)])  # the earlier run's own, and the start's

    def test_one_rank(self):
        self.check(1)

    def test_two_ranks(self):
        self.check(2)

    def test_times_that_differ_are_refused(self):
        _, later = self.first()
        self.edit(later, "dem/in.liggghts", rf"restart\.{STEP}$", f"restart.{STEP // 2}")
        done = support.execute(later)
        self.assertEqual(done.code, 1)
        self.assertIn(f"the gas at t = {TIME} s, the particles at step {STEP // 2}, which is t = {TIME / 2} s", done.err)
        self.assertIn(f"stepAtTimeZero {STEP // 2 - STEP};", done.err)
        self.edit(later, "system/couplingDict", "solidStep", f"stepAtTimeZero {STEP // 2 - STEP}; solidStep")
        self.run_case(later)

    def test_particles_without_a_time_are_told(self):
        whole, later = self.first()
        shutil.copy(whole.path("dem/in.liggghts"), os.path.join(later, "dem/in.liggghts"))
        done = self.run_case(later)
        self.assertEqual(done.err.count(f"the gas starts at t = {TIME} s, and the particles of the script have no time"), 1)
