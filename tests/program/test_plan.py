# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 600
"""tools/plan on a case of water: its numbers are those of the program's own log, and the run that it plans."""

import os
import re
import tempfile
import unittest

import support
from interphase import Case, plan_calibration, plan_scene

CASE = os.path.join(support.SOURCE, "cases", "periodic-duct")


class Plan(unittest.TestCase):
    """A duct of suspension of a solid fraction of 0.3, TDHS, 0.06 s."""

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="interphase-plan-")
        cls.addClassCleanup(cls.scratch.cleanup)
        os.environ["INTERPHASE_BIN"] = support.PROGRAM
        cls.case = Case(CASE).set(method="TDHS")
        cls.run_ = plan_calibration.short_run(cls.case, os.path.join(cls.scratch.name, "run"), 1e9, 0.06, 1)
        cls.calibration = plan_calibration.of_run(cls.run_, cls.case)

    def test_steps_are_those_of_the_log(self):
        with open(os.path.join(self.run_.path, "log.interphase"), encoding="utf-8") as stream:
            gas, solid, of_contact = re.search(r"steps\s+gas (\S+) s, solids (\S+) s = t_c/(\S+)", stream.read()).groups()
        meta = self.run_.meta
        self.assertAlmostEqual(float(meta["gas_step"]), float(gas))
        self.assertAlmostEqual(float(meta["solid_step"]) / float(solid), 1, delta=1e-5)  # its digits in the log
        self.assertAlmostEqual(meta["contact_duration"] / meta["solid_step"] / float(of_contact), 1, delta=1e-5)

    def test_the_scene(self):
        scene = plan_scene.of_run(self.run_)
        self.assertAlmostEqual(scene.sauter, 1e-3)
        self.assertEqual(scene.real, self.run_.meta["real_particles"])
        for cell in (scene.smallest_cell, scene.mean_cell):
            self.assertAlmostEqual(cell, 2.5e-3)
        self.assertAlmostEqual(scene.depth, 0.06)  # of the directions that do not repeat
        self.assertEqual((scene.grain.gas_density, scene.grain.viscosity, scene.grain.gravity), (1000.0, 1e-3, 9.81))
        # closed: what falls displaces what rises; 37 mm/s of fall
        self.assertLess(scene.velocity, 0.02 * 0.037)

    def test_costs_add_up(self):
        """Every second of the processor stands in one phase, and a cost of the time that was measured is what it took."""
        table = self.run_.processor_time
        times = table["gas"].time
        spent = sum(float(table[phase].values[-1] - table[phase].values[0]) for phase in ("solids", "gas", "mapping", "exchange", "waiting"))
        cost = self.calibration.cost(float(times[-1]))
        foretold = sum(value for phase, value in cost.seconds.items() if phase != "output") + self.calibration.setup - float(table["setup"].values[0])
        # the first step, with its rates counted once more for the time that it takes itself: 1 of 30
        self.assertAlmostEqual(foretold / spent, 1, delta=0.05)

    def test_twice_as_long_costs_twice_as_much_output(self):
        output = self.calibration.output
        self.assertEqual(output.intervals[0], 2e-3)
        self.assertGreater(output.snapshot_bytes, 100 * self.run_.meta["particles"])
        step = output.bytes(3.0, 2e-3) - output.bytes(2.0, 2e-3)
        self.assertAlmostEqual((output.bytes(2.0, 2e-3) - output.bytes(1.0, 2e-3)) / step, 1)  # a ratio: the bytes are some 1e8, their round-off is above the seventh place


if __name__ == "__main__":
    unittest.main()
