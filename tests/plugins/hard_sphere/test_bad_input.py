# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 300
"""What a user may get wrong with fix tdhs and wall/tdhs: one message that names the value and says what to do, and nothing moves."""

import dataclasses

from hard_spheres import HardSphereTest, Scene, Spheres

FLOOR = "primitive type 2 zplane 0.0"
STEEL = "fix E all property/global youngsModulus peratomtype 1e7 1e7\nfix nu all property/global poissonsRatio peratomtype 0.3 0.3\n"
MODEL = "gran model hertz tangential history"
TDHS = "fix hs all tdhs {words}\n"


class BadInput(HardSphereTest):
    def refused(self, *patterns, ranks=1, files=None, **changes):
        scene = dataclasses.replace(Scene(Spheres(0.01, [[0.1, 0.1, 0.02]]), (0, 0, -0.01), (0.2, 0.2, 0.2), walls=(FLOOR,)), **changes)
        done = self.execute(scene, 1e-4, 5, ranks=ranks, files=files)
        self.assertNotEqual(done.code, 0, done.text)
        self.assertEqual(len(done.text.split("ERROR")), 2, f"one message:\n{done.text}")
        for pattern in patterns:
            self.assertRegex(done.text, pattern)
        self.assertNotRegex(done.text, "Loop time")
        return done

    def test_the_scene_without_a_mistake(self):
        self.run_scene(Scene(Spheres(0.01, [[0.1, 0.1, 0.02]]), (0, 0, -0.01), (0.2, 0.2, 0.2), walls=(FLOOR,)), 1e-4, 5)

    def test_coefficients(self):
        for given, patterns in (
            ({"e": 1.2}, ("coefficientRestitution is 1.2", "0 to 1")),
            ({"e": -0.1}, ("coefficientRestitution is -0.1", "0 to 1")),
            ({"et": 1.01}, ("tangentialRestitution is 1.01", "0 to 1")),
            ({"mu": -0.3}, ("coefficientFriction is -0.3", "0 or more")),
            ({"e": [[0.9, 1.5], [1.5, 0.9]]}, ("coefficientRestitution is 1.5", "types 1 and 2")),
        ):
            with self.subTest(given):
                self.refused(*patterns, **given)

    def test_missing_property(self):
        for name in ("coefficientRestitution", "tangentialRestitution", "coefficientFriction"):
            with self.subTest(name):
                self.refused(name, "tdhs", "property/global", properties={name: None})

    def test_property_of_another_kind(self):
        self.refused("coefficientRestitution", "peratomtypepair", properties={"coefficientRestitution": "scalar 0.9"})

    def test_words_of_the_fix(self):
        for words, patterns in (
            ("pases 4", ("unknown word 'pases'", "known: passes, margin")),
            ("passes", ("'passes' needs a value",)),
            ("passes four", ("'passes four'", "no number")),
            ("passes 1", ("passes 1", "at least 2")),
            ("passes 2.5", ("passes 2.5", "whole number")),
            ("passes nan", ("passes nan",)),
            ("passes 1e30", ("passes 1e30",)),
            ("margin -0.1", ("margin -0.1", "0 to 1")),
            ("separation 2", ("separation 2", "0 to 1")),
            ("tolerated_overlap 1", ("tolerated_overlap 1", "0 to 1")),
            ("resting_speed -1", ("resting_speed -1", "not below 0")),
            ("margin nan", ("margin nan", "0 to 1")),
        ):
            with self.subTest(words):
                self.refused(*patterns, words=words)

    def test_company(self):
        for lines, patterns in (
            (TDHS + "fix other all nve/sphere\n", ("other", "nve/sphere", "Remove one")),
            (TDHS + "fix two all tdhs\n", ("two|hs", "tdhs", "Remove one")),
            (TDHS + STEEL + f"fix ground all wall/{MODEL} primitive type 2 zplane 0.0\n", ("ground", "wall/gran", "wall/tdhs")),
            (TDHS + STEEL + f"pair_style {MODEL}\npair_coeff * *\n", ("pair_style", "Remove the pair_style")),
        ):
            with self.subTest(lines):
                self.refused(*patterns, fixes=lines)

    def test_wall_without_the_fix(self):
        """A wall that nothing heeds would let spheres fall through."""
        self.refused("wall0", "tdhs", fixes="fix other all nve/sphere\n", thermo="step atoms ke")

    def test_walls(self):
        for wall, patterns in (
            ("", ("wall0", "no kind of wall", "primitive type T")),
            ("sphere", ("'sphere' is no kind of wall", "primitive type T")),
            ("primitive type 2 wplane 0.0", ("'wplane' is no primitive wall", "xplane")),
            ("primitive type 2 zsphere 0.0", ("'zsphere' is no primitive wall", "xplane")),
            ("primitive type 2 zplane low", ("'low' is no number",)),
            ("primitive type 2 zplane 0.0 1.0", ("zplane takes 1 number, not 2",)),
            ("primitive type 2 zcylinder 0.1 0.0", ("zcylinder takes 3 numbers, not 2",)),
            ("primitive type 2 zcylinder -0.1 0.0 0.0", ("radius is -0.1", "above 0")),
            ("primitive type 3 zplane 0.0", ("type 3 is none of the 2 types",)),
            ("primitive type 0 zplane 0.0", ("type 0 is none of the 2 types",)),
            ("primitive type 1.5 zplane 0.0", ("type 1.5",)),
            ("primitive type 2 zplane nan", ("nan",)),
            ("mesh n_meshes 1 meshes floor", ("no fix mesh/surface 'floor'",)),
            ("mesh n_meshes 1 meshes coefficientFriction", ("no fix mesh/surface 'coefficientFriction'",)),
            ("mesh n_meshes 2 meshes floor", ("n_meshes is 2, but 1",)),
            ("mesh meshes floor", ("too few words", "n_meshes N")),
        ):
            with self.subTest(wall):
                self.refused("wall0", *patterns, walls=(wall,))

    def test_one_message_on_two_ranks(self):
        self.refused("coefficientRestitution is 1.2", e=1.2, ranks=2)
        self.refused("unknown word 'pases'", words="pases 4", ranks=2)
