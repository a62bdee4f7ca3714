#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The law is what its source says, of spheres alone and of spheres that touch others (these are taken one by one, those eight at a time);
momentum stays, to round-off, on 1 and 2 ranks; what is not a number of the law is refused.
"""

import unittest

from scenes import FRICTION, RESTITUTION, run, sphere
from throws import restitutions

YIELD = 0.5  # m/s, as in scenes.py
RANKS = (1, 2)


def expected(speed):
    return RESTITUTION * max(1.0, speed / YIELD) ** -0.25


class Law(unittest.TestCase):
    SPEEDS = (0.05, 0.3, 0.5, 1.0, 3.0)  # m/s

    def test_restitution(self):
        for beside_a_wall in (False, True):
            for speed, found in zip(self.SPEEDS, restitutions(self.SPEEDS, 0.004, beside_a_wall)):
                with self.subTest(speed=speed, beside_a_wall=beside_a_wall):
                    self.assertAlmostEqual(found, expected(speed), delta=1e-6)  # single precision

    def test_momentum_of_two_spheres(self):
        """They meet off their line of centres at x = 0.05 m, where two ranks meet, too."""
        for ranks in RANKS:
            with self.subTest(ranks=ranks):
                states = run(sphere(1, 0.010, 2000, (0.040, 0.05, 0.050), (1, 0, 0)) +
                             sphere(2, 0.014, 1000, (0.061, 0.05, 0.056), (-1, 0, 0)) + "run 2000\n", ranks)  # fmt: skip
                before, after = states[0], states[-1]
                self.assertNotAlmostEqual(after[0]["omegay"], 0, msg="friction turns them")
                for axis in ("vx", "vy", "vz"):
                    change = sum(s["mass"] * s[axis] for s in after) - sum(s["mass"] * s[axis] for s in before)
                    self.assertAlmostEqual(change, 0, delta=1e-14 * before[0]["mass"])

    def test_friction(self):
        """Fast along the floor it slips all the time: friction takes mu times the impulse of the floor."""
        states = run(sphere(1, 0.010, 2000, (0.02, 0.05, 0.006), (3, 0, -0.2)) + "run 1500\n")
        before, after = states[0][0], states[-1][0]
        impulse = after["vz"] - before["vz"]
        self.assertAlmostEqual(after["vz"], 0.2 * expected(0.2), delta=1e-9)
        self.assertAlmostEqual(before["vx"] - after["vx"], FRICTION * impulse, delta=1e-9)


class Numbers(unittest.TestCase):
    def test_refused(self):
        with self.assertRaisesRegex(AssertionError, "yieldSpeed is -1"):
            run("fix yields all property/global yieldSpeed peratomtypepair 1 -1.0\nrun 1\n")


if __name__ == "__main__":
    unittest.main()
