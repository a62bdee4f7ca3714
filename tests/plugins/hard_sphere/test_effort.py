#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How many passes and what margin a step gets: from gravity, wherever the script says it, unless the script says them itself. And a
word on overlaps that tell of too few."""

import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

from hard_spheres import HardSphereTest, Scene, Spheres  # noqa: E402

GRAVITY = "fix gravity all gravity 9.81 vector 0 0 -1\n"
TDHS = "fix hs all tdhs {words}\n"
FLOOR = "primitive type 2 zplane 0.0"
DIAMETER, STEP = 0.01, 2e-3  # g dt^2/d = 3.9e-3: 150 times its root is 9.4, 15 times itself 0.0589


class Effort(HardSphereTest):
    def told(self, fixes, positions=((0.1, 0.1, 0.005),), **more):
        scene = Scene(Spheres(DIAMETER, positions), (0, 0, -0.01), (0.2, 0.2, 0.2), walls=(FLOOR,), fixes=fixes, **more)
        return self.run_scene(scene, STEP, 3).text

    def test_gravity_before_or_after(self):
        for fixes in (GRAVITY + TDHS, TDHS + GRAVITY):
            with self.subTest(fixes):
                self.assertRegex(self.told(fixes), r"9 passes over the contacts of a step, margin 0\.0588")

    def test_without_gravity(self):
        self.assertRegex(self.told(TDHS), r"3 passes over the contacts of a step, margin 0\.01 ")

    def test_the_script_has_the_last_word(self):
        self.assertRegex(self.told(TDHS + GRAVITY, words="passes 4 margin 0.03"), r"4 passes .* margin 0\.03 ")

    def test_deep_overlap(self):
        apart, close = ((0.1, 0.1, 0.005), (0.111, 0.1, 0.005)), ((0.1, 0.1, 0.005), (0.106, 0.1, 0.005))
        self.assertNotIn("deepest overlap", self.told(TDHS, apart))
        self.assertRegex(self.told(TDHS, close), r"deepest overlap was 0\.4.* of the smallest diameter\. .*`passes` \(now 3\)")


if __name__ == "__main__":
    unittest.main()
