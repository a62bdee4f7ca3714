# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 300
"""tools/plan: what it refuses before anything runs, which methods it looks at, and what it says where none can be measured."""

import os
import subprocess
import types
import unittest

from interphase import plan_calibration
from interphase.case import Case
from interphase.commands import plan
from interphase.input_error import InputError
from interphase.plan_scene import PlannedScene
from interphase.tree import CASES, TOOLS
from scratch import InFolder, write


def given(method=None, weight=None):
    return types.SimpleNamespace(method=method, weight=weight)


class Refused(InFolder):
    def plan(self, *words, code=2, binary="/bin/false"):
        done = subprocess.run([os.path.join(TOOLS, "plan"), *words], cwd=self.root, env={**os.environ, "INTERPHASE_BIN": binary}, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=120)  # fmt: skip
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done.stderr

    def test_before_anything_runs(self):
        sscp1 = os.path.join(CASES, "sscp1")
        for words, said in (
            (("nowhere",), "no such folder"), ((sscp1, "--method", "CGHX"), "method 'CGHX' is unknown"), ((sscp1, "--weight", "0.5"), "give W >= 1"),
            ((sscp1, "--method", "DEM", "--weight", "8"), "DEM track every particle"), ((sscp1, "--set", "velocty=1"), "did you mean"),
            ((sscp1, "--set", "weight=8"), "give --weight 8"), ((sscp1, "--set", "weight"), "give NAME=VALUE"), ((sscp1, "--until", "0"), "a time in s, above 0"),
            ((sscp1, "--within", "2"), "--within 2: give a time above 0 with its unit"), ((sscp1, "--accuracy", "pressure_drop"), "give a quantity and the share"),
            ((sscp1, "--accuracy", "presure_drop 5%"), "did you mean 'pressure_drop"), ((sscp1, "--ranks", "1000"), "--ranks 1000: there are"),
            ((sscp1, "--calibrate", "-1"), "a number above 0"),
        ):  # fmt: skip
            with self.subTest(words):
                self.assertIn(said, self.plan(*words))

    def test_a_method_without_its_plug_in(self):
        case = os.path.join(self.root, "bed")
        write(os.path.join(case, "system/couplingDict"), "method DEM; weight 1; gas { model none; }\n")
        write(os.path.join(case, "system/controlDict"), "endTime 1; deltaT 1e-3;\n")
        self.assertIn("add `plugins (hard_sphere);`", self.plan(case, "--method", "TDHS"))

    def test_a_program_that_does_not_run(self):
        said = self.plan(os.path.join(CASES, "sscp1"), "--method", "CGPM,CGHS", "--weight", "64", code=1)
        self.assertIn("no method could be measured: CGHS W = 64", said)

    def test_a_weight_that_does_not_fit(self):
        said = self.plan(os.path.join(CASES, "sscp1"), "--method", "CGHS", "--weight", "40000", code=1)
        self.assertIn("change weight or particleCount", said)


class Candidates(unittest.TestCase):
    case = Case(os.path.join(CASES, "sscp1"))

    def test_all_methods_the_cheap_ones_first(self):
        self.assertEqual(plan.candidates(self.case, given()), [("MPPIC", 8), ("CGHS", 8), ("CGPM", 8), ("TDHS", 1), ("DEM", 1)])

    def test_lists(self):
        self.assertEqual(plan.candidates(self.case, given("dem,CGHS", "2,27")), [("CGHS", 27), ("CGHS", 2), ("DEM", 1)])


class Scouts(unittest.TestCase):
    def weights(self, real, diameter, depth, solids=160.0, gas=10.0, until=10.0):
        """With 15 s of a processor, after a method of single particles that costs as much per simulated second."""
        own = types.SimpleNamespace(paces={"solids": types.SimpleNamespace(last=solids), "gas": types.SimpleNamespace(last=gas)},
                                    output=types.SimpleNamespace(row=0.0), gas_step=1e-3, run=types.SimpleNamespace(meta={"weight": 1.0}))  # fmt: skip
        return plan_calibration.scout_weights(PlannedScene(real, diameter, diameter, diameter, 1000.0, depth=depth), own, 15.0, until)

    def test_parcels_are_many_and_narrow_yet_cheap(self):
        self.assertEqual(self.weights(95000, 3.256e-3, 0.0762)[0], 8)  # sscp1
        self.assertEqual(self.weights(17562, 1.545e-3, 0.008), [2])  # a flat bed: parcels of 8 are 0.39 of its depth, of 2 0.24
        self.assertEqual(self.weights(2000, 1e-3, 0.1), [2])  # 250 parcels of 8 are no bed
        self.assertEqual(self.weights(700, 1e-3, 0.1), [])
        self.assertEqual(self.weights(1e6, 1e-3, 0.5)[0], 27)  # 125,000 parcels of 8 are dear

    def test_others_follow_where_the_number_does_not_divide(self):
        self.assertEqual(self.weights(95000, 3.256e-3, 0.0762), [8, 27, 64, 2])

    def test_parcels_of_two_where_they_come_to_the_end(self):
        """Twice 6/2^1.5 s and 3 of the gas are 7.2 s for a simulated second, of which 15 s allow 2.1."""
        self.assertEqual(self.weights(3380, 1e-3, 0.06, solids=6.0, gas=3.0, until=2.0)[0], 2)
        self.assertEqual(self.weights(3380, 1e-3, 0.06, solids=6.0, gas=3.0, until=2.2)[0], 8)


class Times(unittest.TestCase):
    def test_a_gas_step_that_is_no_number(self):
        self.assertEqual(plan_calibration.gas_step(Case(os.path.join(CASES, "periodic-duct"))), 2e-3)  # by a name of `parameters`
        with self.assertRaisesRegex(InputError, "deltaT .* is no number"):
            plan_calibration.gas_step(Case(os.path.join(CASES, "sscp1")).set({"system/controlDict:deltaT": "$nothing"}))


if __name__ == "__main__":
    unittest.main()
