# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 1200
"""What couplingDict makes of methods whose collisions a plug-in brings, and of methods and counters of which the coupler knows nothing but what the plug-in
says."""

import math
import os
import subprocess
from unittest import mock

import h5py
import interphase
import numpy
import support
from plugin_scene import RANKS, DIAMETER, DENSITY, STEP, GAS_STEP, STEPS, SCENE, KICK, MOVE, CONTROL, COUPLING, environment, PluginTest


class Methods(PluginTest):
    """What couplingDict makes of methods whose collisions a plug-in brings."""

    HARD = (f"fix kn all property/global kn peratomtypepair 1 800.0\n"
            f"fix e all property/global coefficientRestitution peratomtypepair 1 0.84\n")  # fmt: skip

    @staticmethod
    def collision_time():
        m = DENSITY * math.pi / 6 * DIAMETER**3
        return math.sqrt(m / 2 / 800 * (math.pi**2 + math.log(0.84) ** 2))

    def test_none_is_named(self):
        for method, name in (("TDHS", "hard_sphere"), ("CGHS", "hard_sphere"), ("MPPIC", "mp_pic"), ("KICKED", "counts_less")):
            for plugins in ("", "plugins (kick);"):
                with self.subTest(method, plugins=plugins):
                    self.refused(self.coupled(plugins, method=method), f"`method {method};` is of the plug-in {name}, which `plugins` does not name",
                                 rf"add `plugins \({name}\);`", r"couplingDict, line \d")  # fmt: skip
        self.refused(self.coupled("", method="PLUGIN"), "`method PLUGIN;` takes its collisions from a plug-in", r"add `plugins \(NAME\);`")

    def test_one_that_nobody_brings(self):
        self.refused(self.coupled(["kick"], method="KICK"), "`method KICK;` names nothing that is there", "choose one of DEM, CGPM, PLUGIN")
        self.refused(self.coupled(["own_method"], method="KICKER"), "did you mean `KICKED`?")

    def test_the_entry_is_no_list(self):
        for entry in ("plugins kick;", "plugins { kick; }", "plugins (kick 3);"):
            with self.subTest(entry):
                self.refused(self.coupled(entry), "is no list of names", r"write `plugins \(", "couplingDict")

    def test_weights(self):
        self.refused(self.coupled(["kick", "hard_sphere"], method="TDHS", more="weight 8;"), "`weight 8;` with method TDHS", "method CGHS")
        for method in ("CGHS", "MPPIC", "PLUGIN"):
            done = self.coupled(["kick", "hard_sphere", "mp_pic"], method=method, more="weight 8;")
            self.assertEqual(done.code, 0, done.text)

    def test_step_of_mp_pic(self):
        """The gas step, or what is given; nothing derives from collisions, which it does not have."""
        self.assertAlmostEqual(self.solid_step(["kick", "mp_pic"], method="MPPIC", step=""), GAS_STEP, delta=1e-12)
        self.assertAlmostEqual(self.solid_step(["kick", "mp_pic"], method="MPPIC"), STEP, delta=1e-12)
        for entry in ("stepsPerCollision 4;", "largestOverlap 0.02; impactSpeed 1;"):
            with self.subTest(entry):
                self.refused(self.coupled(["kick", "mp_pic"], method="MPPIC", step=entry), f"{entry.split()[0]} with method MPPIC", "solidStep")

    def test_a_script_without_the_plug_in_s_fix(self):
        self.refused(self.coupled(["kick"], script=SCENE + MOVE), "no fix of a plug-in is in the script", "one of these styles: test/kick")

    def test_collisions_of_a_plug_in_beside_a_pair_style(self):
        pair = ("fix kn all property/global kn peratomtypepair 1 800.0\nfix kt all property/global kt peratomtypepair 1 0.0\n"
                "fix gn all property/global gamman_abs peratomtypepair 1 0.0\nfix gt all property/global gammat_abs peratomtypepair 1 0.0\n"
                "pair_style gran model hooke/stiffness absolute_damping on\npair_coeff * *\n")  # fmt: skip
        for method in ("TDHS", "MPPIC"):
            with self.subTest(method):
                self.refused(self.coupled(["kick", "hard_sphere", "mp_pic"], method=method, script=SCENE + pair + KICK + MOVE), "pair style gran", "count twice")

    def test_step_of_hard_spheres(self):
        """t_c of the DEM whose stiffness and restitution the script gives, cut to divide the gas step."""
        script = SCENE + self.HARD + KICK + MOVE
        for method in ("TDHS", "CGHS"):
            for entry, parts in (("", 1), ("stepsPerCollision 4;", 4), ("stepsPerCollision 0.5;", 0.5)):
                with self.subTest(method=method, entry=entry):
                    longest = self.collision_time() / parts
                    expected = GAS_STEP / math.ceil(GAS_STEP / longest)
                    self.assertAlmostEqual(self.solid_step(["kick", "hard_sphere"], method=method, script=script, step=entry), expected, delta=1e-9)

    def test_step_of_a_user_s_own_method(self):
        """As careful as DEM where nothing is said, but any other number of steps will do."""
        script = SCENE + self.HARD + KICK + MOVE
        expected = GAS_STEP / math.ceil(GAS_STEP / (self.collision_time() / 20))
        self.assertAlmostEqual(self.solid_step(["kick"], script=script, step=""), expected, delta=1e-9)
        self.assertAlmostEqual(self.solid_step(["kick"], script=script, step="stepsPerCollision 0.01;"), GAS_STEP, delta=1e-9)

    def test_step_from_the_largest_overlap(self):
        """2 % of 10 mm at 0.5 m/s are 0.4 ms, cut to a third of the gas step."""
        self.assertAlmostEqual(self.solid_step(["kick", "hard_sphere"], method="TDHS", step="largestOverlap 0.02; impactSpeed 0.5;"), GAS_STEP / 3,
                               delta=1e-9)  # fmt: skip

    def test_steps_that_are_contradicted_or_incomplete(self):
        for step, method, expected in (
            ("largestOverlap 0.02;", "TDHS", "largestOverlap is given alone"),
            ("impactSpeed 1;", "TDHS", "impactSpeed is given alone"),
            ("largestOverlap 0.02; impactSpeed 1; solidStep 1e-4;", "TDHS", "both largestOverlap and solidStep are given"),
            ("largestOverlap 0.02; impactSpeed 1; stepsPerCollision 1;", "CGHS", "both largestOverlap and stepsPerCollision are given"),
            ("largestOverlap 2; impactSpeed 1;", "TDHS", r"`largestOverlap 2;`.*between 0 and 1"),
            ("largestOverlap 0.02; impactSpeed 1;", "DEM", "largestOverlap with method DEM"),
            ("stepsPerCollision 0;", "TDHS", r"`stepsPerCollision 0;`.*above 0"),
            ("stepsPerCollision 5;", "DEM", r"`stepsPerCollision 5;`.*at least 10"),
            ("solidStep 2e-3;", "TDHS", r"solid step of 0\.002 s is longer than the gas step of 0\.001 s"),
            ("", "TDHS", "(?s)no stiffness and restitution.*largestOverlap.*coefficientRestitution"),
        ):
            with self.subTest(step=step, method=method):
                self.refused(self.coupled(["kick", "hard_sphere"], method=method, step=step), expected)

    def test_restitution_above_one(self):
        script = SCENE + self.HARD.replace("0.84", "1.2") + KICK + MOVE
        self.refused(self.coupled(["kick", "hard_sphere"], method="TDHS", script=script, step=""), r"coefficientRestitution is 1\.2", "from 0 to 1")

    def test_the_limit_that_a_fix_tells(self):
        """test/hasty bears 2e-6 s."""
        script = SCENE + self.HARD + "fix hasty all test/hasty 0 0 0\n" + MOVE
        for step in ("", "stepsPerCollision 1;", "largestOverlap 0.02; impactSpeed 0.5;"):
            with self.subTest(step):
                self.assertAlmostEqual(self.solid_step(["hasty"], script=script, step=step), 2e-6, delta=1e-12)
        self.refused(self.coupled(["hasty"], script=script), r"solid step of 0\.0001 s is longer than the 2e-06 s")
        self.refused(self.coupled(["nonsense_limit"], script=script.replace("test/hasty", "test/nonsense"), step=""),
                     "solid step of at most -1 s", "solid_step_limit")  # fmt: skip


class OwnMethods(PluginTest):
    """A plug-in that brings a method and counters, KICKED of own_method: the coupler knows nothing of it but what it says of itself."""

    SCRIPT = SCENE + "fix kick all test/own 0.5 0.25 -0.125\n" + MOVE

    def test_it_is_one_like_any_other(self):
        for ranks in RANKS:
            with self.subTest(ranks=ranks):
                done = self.coupled(["own_method"], ranks, method="KICKED", script=self.SCRIPT)
                self.assertEqual(done.code, 0, done.text)
                self.assertEqual(done.meta["method"], "KICKED")

    def test_it_says_what_a_solid_step_is(self):
        script = Methods.HARD + self.SCRIPT[len(SCENE):]
        expected = GAS_STEP / math.ceil(GAS_STEP / (Methods.collision_time() / 5))
        self.assertAlmostEqual(self.solid_step(["own_method"], method="KICKED", script=SCENE + script, step=""), expected, delta=1e-9)

    def test_it_says_what_it_tracks(self):
        self.refused(self.coupled(["own_method"], method="KICKED", script=self.SCRIPT, more="weight 8;"),
                     "`weight 8;` with method KICKED, which tracks real particles", "set `weight 1;`")  # fmt: skip

    def test_its_counters(self):
        """Two particles, one on each of two ranks, get twenty kicks of 0.573 m/s."""
        fastest = STEPS * math.sqrt(0.5**2 + 0.25**2 + 0.125**2)
        for ranks in RANKS:
            with self.subTest(ranks=ranks):
                done = self.coupled(["own_method"], ranks, method="KICKED", script=self.SCRIPT, more="records { interval 1e-3; }")
                self.assertRegex(done.out, rf"kicks given +{2 * STEPS} +look at it\n")
                self.assertRegex(done.out, r"fastest kicked particle +11\.5 m/s +look at it\n")
                with h5py.File(done.path("results.h5")) as results:
                    rows = results["counters"]
                    self.assertEqual(list(rows["time"]), list(results["series/time"]))
                    self.assertEqual((rows["kicks"][0], rows["kicks"][-1], rows.attrs["kicks"]), (0, 2 * STEPS, 2 * STEPS))
                    self.assertAlmostEqual(rows["fastest"][-1], fastest, delta=1e-12 * fastest)
                    self.assertEqual(rows["fastest"].attrs["unit"], "m/s")

    def changed(self, lines, ranks):
        """A run whose fix kick gives ten kicks, then the commands `lines`, and ten more steps."""
        step = f"solidStep {STEP!r}; commands {{ change {{ time {GAS_STEP!r}; lines ({lines}); }} }}"
        return self.coupled(["own_method", "other_counter"], ranks, method="DEM", script=self.SCRIPT, step=step, more="records { interval 1e-3; }")

    def test_counters_of_fixes_that_come_and_go(self):
        """Each fix kicks two particles in each of ten steps. What fixes have counted that are no more stays."""
        more, other = "fix more all test/own 0.5 0.25 -0.125", "fix other all test/other 0.5 0.25 -0.125"
        for lines, kicks, others, of_each in (
            ('"unfix kick"', 20, None, 10),
            (f'"unfix kick" "{more}"', 40, None, 20),
            (f'"{more}"', 60, None, 30),
            (f'"unfix kick" "{other}"', 20, 20, 20),
        ):
            for ranks in RANKS:
                with self.subTest(lines, ranks=ranks):
                    done = self.changed(lines, ranks)
                    self.assertEqual(done.code, 0, done.text)
                    self.assertRegex(done.out, rf"kicks given +{kicks} +look at it\n")
                    counters = done.table("counters")
                    self.assertEqual(counters["kicks"].tolist(), [0, 20, kicks])
                    self.assertAlmostEqual(counters["fastest"][-1], of_each * math.sqrt(0.5**2 + 0.25**2 + 0.125**2), delta=1e-12)
                    self.assertEqual("other_kicks" in counters, others is not None)
                    if others:  # not counted before it was there
                        numpy.testing.assert_array_equal(counters["other_kicks"], [math.nan, math.nan, others])

    def test_counters_of_fixes_that_are_gone_when_a_run_goes_on(self):
        for ranks in RANKS:
            with self.subTest(ranks=ranks):
                folder = self.changed('"unfix kick"', ranks).folder
                control = os.path.join(folder, "system/controlDict")
                support.write(control, CONTROL.replace(f"endTime {STEPS * STEP!r}", f"endTime {STEPS * STEP + GAS_STEP!r}"))
                done = support.execute(folder, ranks, timeout=60, options=["-resume"], **environment())
                self.assertEqual(done.code, 0, done.text)
                self.assertEqual(done.column("counters/kicks").tolist(), [0, 20, 20, 20])
                self.assertEqual(done.column("counters/fastest").tolist()[1:], 3 * [done.column("counters/fastest")[1]])

    def test_without_counters_there_is_no_table(self):
        with h5py.File(self.coupled(["kick"]).path("results.h5")) as results:
            self.assertNotIn("counters", results)

    def test_the_program_tells(self):
        done = subprocess.run([support.PROGRAM, "-help", "methods", "own_method"], cwd=self.root, env=support.environment(**environment()), capture_output=True,
                              text=True, timeout=60)  # fmt: skip
        self.assertRegex(done.stdout, r"\| `KICKED` \| `own_method` \| particles \| \| single \| t_c/5 \| no \| kicks \|")
        self.assertNotIn("TDHS", done.stdout)
        done = subprocess.run([support.PROGRAM, "-help", "methods", "nowhere"], cwd=self.root, env=support.environment(**environment()), capture_output=True,
                              text=True, timeout=60)  # fmt: skip
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, "there is no plug-in `nowhere`(.|\n)*where:  command line")
        done = subprocess.run([support.PROGRAM, "-help", "counts", "own_method"], cwd=self.root, env=support.environment(**environment()), capture_output=True,
                              text=True, timeout=60)  # fmt: skip
        self.assertIn("## fastest kicked particle\n\n`fastest`. The speed of the fastest.\n\n- Look at it above 5 m/s.", done.stdout)

    def test_tools_know_it(self):
        """`kicked` is a method of a case that names the plug-in, and tracks particles."""
        folder = os.path.join(self.root, "case")
        support.write(os.path.join(folder, "system/controlDict"), CONTROL)
        support.write(os.path.join(folder, "system/couplingDict"), COUPLING.format(method="DEM", plugins="plugins (own_method);", step="", more="weight 8;"))
        with mock.patch.dict(os.environ, support.environment(**environment())):
            changed = interphase.Case(folder).set(method="kicked")
            self.assertEqual((changed.method, changed.weight), ("KICKED", 1))
            self.assertTrue(changed.method_of(None).of_particles)
            with self.assertRaisesRegex(interphase.InputError, "method 'kickers' is unknown: did you mean"):
                interphase.Case(folder).set(method="kickers")

    def test_two_of_a_name(self):
        self.everywhere_refused(["own_method", "same_method"],
                                r"the method `KICKED` of the plug-in same_method \(.*\) is brought by the plug-in own_method \(.*\) already", "leave one")  # fmt: skip

    def test_a_name_of_liggghts(self):
        self.everywhere_refused(["takes_dem"], "the method `DEM` of the plug-in takes_dem .* has a name that is LIGGGHTS's own")

    def test_names_that_nobody_could_write(self):
        self.everywhere_refused(["no_word"], "the method `two words` .* is none that a case could name")
        self.everywhere_refused(["no_counter"], "counts something as ``, which is no word")
        self.everywhere_refused(["same_counters"], "counts something as `fastest`, which is there twice")

    def test_a_fix_that_tells_other_counters(self):
        for ranks in RANKS:
            done = self.coupled(["counts_less"], ranks, method="KICKED")
            self.refused(done, r"fix kick \(test/kick\) counts 1 things, and its plug-in counts_less names 2", "INTERPHASE_COUNTERS")
