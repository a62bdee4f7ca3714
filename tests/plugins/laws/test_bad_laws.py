# SPDX-License-Identifier: GPL-3.0-or-later
"""A law that answers what is none, or a script that does not give it its numbers: one message with the value and where, and nothing moves."""

import dataclasses
import os

from hard_spheres import HardSphereTest, Spheres
from law_scenes import law_scene

BAD = os.path.join("tests", "plugins", "libbad_laws.so")
ONE = Spheres(0.01, [[0.1, 0.1, 0.02]])
FLOOR = ("primitive type 2 zplane 0.0",)


class BadLaws(HardSphereTest):
    def scene(self, law, **changes):
        return dataclasses.replace(law_scene(law, ONE, (0, 0, -0.01), (0.2, 0.2, 0.2), walls=FLOOR, e=0.9), **changes)

    def refused(self, scene, *patterns, ranks=1):
        done = self.execute(scene, 1e-4, 5, ranks=ranks)
        self.assertNotEqual(done.code, 0, done.text)
        self.assertEqual(len(done.text.split("ERROR")), 2, f"one message:\n{done.text}")
        for pattern in patterns:
            self.assertRegex(done.text, pattern)
        self.assertNotRegex(done.text, "Loop time")

    def test_answers(self):
        self.run_scene(self.scene("right", plugin=BAD), 1e-4, 5)
        for law, patterns in (
            ("gains_energy", ("Fix tdhs/gains_energy: between types 1 and 1 the law answers a restitution of 1.07783 at an approach of 1.77828 m/s",
                              "effective mass of .* kg", "from 0 to 1")),
            ("no_answer_at_rest", ("restitution of -?nan at an approach of 0 m/s",)),
            ("pushes_friction", ("friction of -0.9", "from 0 on")),
            ("without_range", ("attraction of 0.001 N, but a range of 0; say how far it reaches",)),
            ("too_far", ("range of 1 m; it must be a number from 0 to the smallest diameter, 0.01 m",)),
            ("no_force_at_contact", ("attraction of inf N at a gap of 0 m",)),
        ):  # fmt: skip
            for ranks in (1, 2):
                with self.subTest(law, ranks=ranks):
                    self.refused(self.scene(law, plugin=BAD), *patterns, ranks=ranks)

    def test_numbers_of_the_materials(self):
        properties = {"coefficientRollingFriction": "peratomtypepair 2 0.1 0.1 0.1 0.1", "contactModulus": "peratomtypepair 2 1e7 1e7 1e7 1e7"}
        for law, changed, patterns in (
            ("rolling", {"coefficientRollingFriction": None}, ("fix tdhs/rolling|Fix tdhs/rolling", "does not say the coefficientRollingFriction")),
            ("rolling", {"coefficientRollingFriction": "peratomtypepair 2 0.1 -0.1 -0.1 0.1"}, ("coefficientRollingFriction is -0.1", "types 1 and 2", "0 or more")),
            ("viscoelastic", {"contactModulus": "peratomtypepair 2 0 0 0 0"}, ("contactModulus is 0.0", "give 1 or more")),
            ("viscoelastic", {}, ("does not say the dissipativeTime",)),
        ):
            with self.subTest(law, changed=changed):
                self.refused(self.scene(law, properties=properties | changed), *patterns)

    def test_two_laws(self):
        """One fix moves the particles; walls are another one's."""
        properties = {"coefficientRollingFriction": "peratomtypepair 2 0.1 0.1 0.1 0.1"}
        scene = self.scene("rolling", properties=properties, fixes="fix hs all {style} {words}\nfix two all tdhs/viscoelastic\n")
        self.refused(scene, "moves the particles itself, but fix two|hs", "Remove one")
        scene = self.scene("rolling", properties=properties, fixes="fix hs all {style} {words}\nfix lid all wall/tdhs/cohesive primitive type 1 zplane 0.1\n")
        self.refused(scene, "lid", "there is no fix tdhs/cohesive that heeds this wall")
