# SPDX-License-Identifier: GPL-3.0-or-later
"""What fix ave/time wrote is read with times, by the run's own solid step."""

import os
import tempfile
import types
import unittest

import numpy

from interphase import InputError, ave_time


class AveTime(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.run_ = types.SimpleNamespace(path=room.name, meta={"solid_step": 2e-4})

    def write(self, text):
        with open(os.path.join(self.run_.path, "torque.txt"), "w", encoding="utf-8") as file:
            file.write(text)

    def test_times_and_columns(self):
        self.write("# Time-averaged data for fix torque\n# TimeStep f_blades[6] f_blades[3]\n10 0 1\n20 -3.5e-06 2\n")
        time, values = ave_time.read(self.run_, "torque.txt")
        numpy.testing.assert_allclose(time, [2e-3, 4e-3])
        numpy.testing.assert_allclose(values, [[0, 1], [-3.5e-6, 2]])

    def test_none_where_there_is_none(self):
        self.assertIsNone(ave_time.read(self.run_, "torque.txt"))

    def test_what_is_no_table_is_named(self):
        self.write("10 zero\n")
        with self.assertRaisesRegex(InputError, r"torque\.txt: no table of numbers, as fix ave/time writes it"):
            ave_time.read(self.run_, "torque.txt")

    def test_a_run_that_does_not_tell_its_step(self):
        self.write("10 1\n")
        self.run_.meta = {}
        with self.assertRaisesRegex(InputError, "does not tell the solid step"):
            ave_time.read(self.run_, "torque.txt")


if __name__ == "__main__":
    unittest.main()
