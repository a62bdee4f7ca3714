# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 400
"""Interphase terms in the whole program: a light sphere rises in a liquid as the closed solution says, and a suspension with every term
keeps its books closed on one rank and on two."""

import os

import numpy

import support

G = 9.81


class Terms(support.ProgramTest):

    def rise(self, name, forces):
        """(times, upward velocities) of a sphere of 500 kg/m3 in a liquid so viscous that drag is Stokes' to 0.2 %."""
        out = self.ran("settling", os.path.join(self.root, name), until=0.05, diameter=2e-3, particleDensity=500, gasDensity=1000, gasViscosity=0.1, startHeight=1,
                       **{"forces": forces, "particles/solidStep": 2e-5, "records/snapshotInterval": 1e-3, "system/controlDict:deltaT": 2e-4})  # fmt: skip
        return zip(*((each.time, each.velocities[0, 2]) for each in support.Run(out).snapshots))

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
            done = support.Finished(self.ran("suspension", os.path.join(self.root, f"all{ranks}"), ranks, until=0.04, solidFraction=0.3,
                                             forces="(virtualMass viscousStress saffmanMeiLift)"))  # fmt: skip
            self.assert_books_close(done)
            self.assertEqual(done.column("ledger/steps_alternating")[-1], 0)
            self.assertIn("beyond_lift_range", done.run.ledger)
