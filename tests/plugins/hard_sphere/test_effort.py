# SPDX-License-Identifier: GPL-3.0-or-later
"""Passes and margin that a step gets where the script does not say them: enough to hold a bed at steps longer than those that the
least effort bears; by gravity, wherever the script names it. And a word on overlaps that tell of too few."""

import re

import numpy

import bed
import support

from hard_spheres import HardSphereTest, Scene, Spheres

GRAVITY = "fix gravity all gravity 9.81 vector 0 0 -1\n"
TDHS = "fix hs all tdhs {words}\n"
FLOOR = "primitive type 2 zplane 0.0"
DIAMETER, STEP = 0.01, 2e-3


class Told(HardSphereTest):
    def told(self, fixes, positions=((0.1, 0.1, 0.005),), step=STEP, **more):
        scene = Scene(Spheres(DIAMETER, positions), (0, 0, -0.01), (0.2, 0.2, 0.2), walls=(FLOOR,), fixes=fixes, **more)
        return self.run_scene(scene, step, 3).text

    def effort(self, fixes, **more):
        """(passes, margin over the smallest diameter)"""
        found = re.search(r"(\d+) passes over the contacts of a step, margin (\S+) of", self.told(fixes, **more))
        return int(found[1]), float(found[2])

    def test_gravity_before_or_after(self):
        self.assertEqual(self.effort(GRAVITY + TDHS), self.effort(TDHS + GRAVITY))

    def test_grows_with_what_gravity_does_in_a_step(self):
        """Nothing without gravity, more in longer steps, and no end of it in none."""
        efforts = [self.effort(TDHS)] + [self.effort(TDHS + GRAVITY, step=step) for step in (1e-4, 1e-3, 2e-3, 2e-2)]
        for less, more in zip(efforts, efforts[1:]):
            self.assertLessEqual(less, more)
            self.assertLessEqual(less[1], more[1])
        self.assertLess(efforts[1][0], efforts[3][0])
        self.assertLess(efforts[1][1], efforts[3][1])
        self.assertGreaterEqual(efforts[0][0], 2, "fix tdhs refuses less")
        self.assertLessEqual(efforts[-1][1], 1, "and more than a diameter")

    def test_the_script_has_the_last_word(self):
        self.assertEqual(self.effort(TDHS + GRAVITY, words="passes 4 margin 0.03"), (4, 0.03))

    def test_deep_overlap(self):
        apart, close = ((0.1, 0.1, 0.005), (0.111, 0.1, 0.005)), ((0.1, 0.1, 0.005), (0.106, 0.1, 0.005))
        self.assertNotIn("deepest overlap", self.told(TDHS, apart))
        self.assertRegex(self.told(TDHS, close), r"deepest overlap was 0\.4.* of the smallest diameter\. .*`passes` \(now \d+\)")

    def test_values_have_names(self):
        """v_hs_... shows what f_hs[...] does, and a variable of the script stays as it is."""
        names = ("pairs", "binary_collisions", "cluster_contacts", "shortened_steps", "search", "walls", "contacts", "integration",
                 "communication")  # fmt: skip
        scene = Scene(
            Spheres(DIAMETER, ((0.1, 0.1, 0.005), (0.1099, 0.1, 0.005))), (0, 0, -0.01), (0.2, 0.2, 0.2), walls=(FLOOR,),
            fixes="variable hs_walls equal 42\n" + TDHS, thermo="step atoms " + " ".join(f"v_hs_{n} f_hs[{k}]" for k, n in enumerate(names, 1)),
        )  # fmt: skip
        row = dict(zip(names, self.run_scene(scene, STEP, 3).thermo()[-1][2:].reshape(-1, 2)))
        self.assertEqual(row["pairs"][0], 1)
        self.assertEqual(row.pop("walls")[0], 42)
        for name, (named, counted) in row.items():
            self.assertEqual(named, counted, name)


class Bed(support.ProgramTest):
    """720 spheres, 20 layers, poured and left alone for a second at three times the collision time of the soft ones."""

    def overlaps(self, words):
        d = bed.DIAMETER
        lying = bed.Bed(6 * d, 6 * d).equal(720, d).pour(self.root, 1.0, 3 * bed.collision_time(d), words=words)
        return numpy.percentile(lying.overlaps(), 97), lying.height[-1] / d

    def test_is_held(self):
        """What is tolerated is 0.003 d: seen are 0.0030 with the usual effort, 0.0101 with that of the shortest steps, with
        which the bed sinks by half a diameter."""
        usual, height = self.overlaps("")
        least, sunk = self.overlaps("passes 3 margin 0.01")
        self.assertLess(usual, 0.005)
        self.assertGreater(least, 1.5 * usual)
        self.assertGreater(height, sunk)
