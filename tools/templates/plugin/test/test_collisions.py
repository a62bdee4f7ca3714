#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the law promises, on 1 and 2 ranks: momentum and angular momentum stay, to round-off; the speed after a collision is
`coefficientRestitution` times that before; what is inserted while the run goes on collides like all others.
"""

import unittest

from scenes import FRICTION, GRAVITY, RESTITUTION, run, sphere

RANKS = (1, 2)


def momentum(state, k):
    return sum(s["mass"] * s["v" + "xyz"[k]] for s in state)


def spin_about_y(state):
    """Angular momentum about the axis y [kg m2/s]."""
    return sum(s["mass"] * (s["z"] * s["vx"] - s["x"] * s["vz"] + 0.4 * s["radius"] ** 2 * s["omegay"]) for s in state)


class Collisions(unittest.TestCase):
    def test_two_spheres(self):
        """They meet off their line of centres at x = 0.05 m, where two ranks meet, too."""
        for ranks in RANKS:
            with self.subTest(ranks=ranks):
                states = run(sphere(1, 0.010, 2000, (0.040, 0.05, 0.050), (1, 0, 0)) +
                             sphere(2, 0.014, 1000, (0.061, 0.05, 0.056), (-1, 0, 0)) + "run 2000\n", ranks)  # fmt: skip
                before, after = states[0], states[-1]
                self.assertNotAlmostEqual(after[0]["omegay"], 0, msg="friction turns them")
                scale = before[0]["mass"] * 1.0  # kg m/s
                for k in range(3):
                    self.assertAlmostEqual(momentum(before, k), momentum(after, k), delta=1e-14 * scale)
                # the 9 % of the radius by which they overlap turn with them; the rest is round-off of 2000 steps
                self.assertAlmostEqual(spin_about_y(before), spin_about_y(after), delta=1e-12 * scale * 0.1)

    def test_restitution_between_spheres(self):
        for ranks in RANKS:
            with self.subTest(ranks=ranks):
                states = run(sphere(1, 0.010, 2000, (0.040, 0.05, 0.05), (1, 0, 0)) +
                             sphere(2, 0.014, 1000, (0.061, 0.05, 0.05), (-1, 0, 0)) + "run 2000\n", ranks)  # fmt: skip
                closing, parting = [s[1]["vx"] - s[0]["vx"] for s in (states[0], states[-1])]
                self.assertAlmostEqual(parting / closing, -RESTITUTION, delta=0.005)  # a step is 1/200 of the collision

    def test_sliding_on_the_floor(self):
        """Fast along the floor it slips all the time: friction takes mu times the impulse of the floor, and turns the sphere."""
        states = run(sphere(1, 0.010, 2000, (0.02, 0.05, 0.006), (3, 0, -0.2)) + "run 1500\n")
        before, after = states[0][0], states[-1][0]
        impulse = after["vz"] - before["vz"]
        self.assertAlmostEqual(after["vz"], 0.2 * RESTITUTION, delta=0.001)
        self.assertAlmostEqual(before["vx"] - after["vx"], FRICTION * impulse, delta=0.02 * FRICTION * impulse)
        turned = 0.4 * after["radius"] ** 2 * after["omegay"] / after["radius"]  # m/s, of impulse per mass
        self.assertAlmostEqual(turned, FRICTION * impulse, delta=0.02 * FRICTION * impulse)

    def test_inserted_later(self):
        """The box is empty when the run starts. A sphere that comes then falls, and rises again by e^2 of its height."""
        insertion = """
fix             one all particletemplate/sphere 10007 atom_type 1 density constant 2000 radius constant 0.004
fix             sizes all particledistribution/discrete 10009 1 one 1.0
region          spot block 0.04 0.06 0.045 0.055 0.04 0.0502 units box
fix             feed all insert/pack seed 10037 distributiontemplate sizes insert_every once overlapcheck yes all_in yes &
                particles_in_region 1 region spot
run             17000
"""
        for ranks in RANKS:
            with self.subTest(ranks=ranks):
                heights = [state[0]["z"] - 0.004 for state in run(GRAVITY + insertion, ranks) if state]
                lowest = heights.index(min(heights))
                # the floor gives way by 2 % of the fall, and states are 1 ms apart
                self.assertAlmostEqual(max(heights[lowest:]) / heights[0], RESTITUTION**2, delta=0.02)


if __name__ == "__main__":
    unittest.main()
