#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 400
"""Interphase terms in the whole program: a light sphere rises in a liquid as the closed solution says, and a suspension with every term
keeps its books closed on one rank and on two."""

import os
import subprocess
import unittest

import numpy

import interphase
import support

G = 9.81


class Terms(support.ProgramTest):
    def ran(self, name, case, until, ranks=1, **settings):
        """The run's folder."""
        out = os.path.join(self.root, name)
        words = [word for key, value in settings.items() for word in ("--set", f"{key.replace('__', ':')}={value}")]
        done = subprocess.run(
            [os.path.join(support.TOOLS, "run"), os.path.join(support.SOURCE, "cases", case), "--no-picture", "--quiet", "--out", out,
             "--until", str(until), "--ranks", str(ranks), *words], stdin=subprocess.DEVNULL, capture_output=True, text=True,
            env=support.environment(INTERPHASE_BIN=support.PROGRAM), timeout=300,
        )  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return out

    def rise(self, name, forces):
        """(times, upward velocities) of a sphere of 500 kg/m3 in a liquid so viscous that drag is Stokes' to 0.2 %."""
        out = self.ran(name, "settling", 0.05, diameter=2e-3, particleDensity=500, gasDensity=1000, gasViscosity=0.1, startHeight=1,
                       **{"system/couplingDict__forces": forces, "system/couplingDict__particles/solidStep": 2e-5,
                          "system/couplingDict__records/snapshotInterval": 1e-3, "system/controlDict__deltaT": 2e-4})  # fmt: skip
        return zip(*((each.time, each.velocities[0, 2]) for each in interphase.Run(out).snapshots))

    def test_a_light_sphere_rises_as_the_closed_solution_says(self):
        mass, displaced = 500, 1000  # per volume
        rate = 18 * 0.1 / (2e-3) ** 2
        terminal = (displaced - mass) * G / rate
        for forces, added in (("(virtualMass)", displaced / 2), ("()", 0)):
            with self.subTest(forces):
                tau = (mass + added) / rate  # 2.2 ms, and 1.1 without
                time, velocity = (numpy.array(values) for values in self.rise(f"added{added:g}", forces))
                exact = terminal * (1 - numpy.exp(-time / tau))
                # LIGGGHTS's first half kick is by the weight alone, g dt too low at the most; drag's 0.15 Re^0.687
                reynolds = displaced * exact * 2e-3 / 0.1
                tolerance = 0.01 * exact + G * 2e-5 + exact * 0.15 * reynolds**0.687
                numpy.testing.assert_array_less(numpy.abs(velocity - exact)[time > 0], tolerance[time > 0])

    def test_all_of_them_keep_the_books_closed(self):
        for ranks in (1, 2):
            out = self.ran(f"all{ranks}", "suspension", 0.04, ranks, solidFraction=0.3,
                           **{"system/couplingDict__forces": "(virtualMass viscousStress saffmanMeiLift)"})  # fmt: skip
            ledger = {name: each.values for name, each in interphase.Run(out).ledger.items()}
            self.assertLess(ledger["momentum_residual"].max(), 1e-12)
            self.assertLess(ledger["volume_residual"].max(), 1e-12)
            self.assertLess(ledger["gas_volume_residual"].max(), 1e-12)
            self.assertEqual(ledger["steps_alternating"][-1], 0)
            self.assertIn("beyond_lift_range", ledger)


if __name__ == "__main__":
    unittest.main()
