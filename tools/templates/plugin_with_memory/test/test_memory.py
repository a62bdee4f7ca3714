#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a law that remembers can do and one without memory cannot: hold still on a slope, by the spring along the surfaces."""

import math
import unittest

from scenes import FRICTION, run, sphere

G = 9.81


def slope(angle):
    """A resting pair of spheres that may not turn, on a floor that is tilted by tan(angle) = `angle`."""
    c, s = 1 / math.hypot(1, angle), angle / math.hypot(1, angle)
    return (sphere(1, 0.01, 2000, (0.05, 0.05, 0.00499), (0, 0, 0)) + f"fix gravity all gravity {G} vector {s} 0.0 {-c}\n"
            "unfix move\nfix move all nve\n")  # nve turns nothing: what rolls down is not held by friction  # fmt: skip


class Memory(unittest.TestCase):
    def test_it_holds_below_the_friction_angle(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                states = run(slope(0.9 * FRICTION) + "run 20000\n", ranks)
                middle, end = states[len(states) // 2][0], states[-1][0]
                self.assertAlmostEqual(middle["x"], end["x"], delta=1e-7)  # m; the spring still swings a little

    def test_it_slides_above(self):
        states = run(slope(1.5 * FRICTION) + "run 10000\n")
        start, end = states[len(states) // 2][0], states[-1][0]
        c = 1 / math.hypot(1, 1.5 * FRICTION)
        acceleration = G * c * (1.5 - 1) * FRICTION
        self.assertAlmostEqual(end["vx"] - start["vx"], acceleration * 0.05, delta=0.01 * acceleration * 0.05)


if __name__ == "__main__":
    unittest.main()
