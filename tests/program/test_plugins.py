# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 1200
"""Plug-ins, through interphase (entry `plugins` of system/couplingDict) and through interphase-liggghts (option -plugin), on one
rank and on two: what fits is loaded and does its work; what does not is refused with one message that names the library,
what was found, what was expected and what to do, before anything has moved.

The plug-ins are those of tests/engines/liggghts/plugins. The scene: two spheres at rest in a box; the fix test/kick adds a
known velocity to them every step.
"""

import math
import os
import re
import subprocess
from unittest import mock

import h5py
import interphase
import numpy
import support

RANKS = (1, 2)
RUNNER = os.path.join(support.BUILD, "interphase-liggghts")
PLUGINS = os.path.join(support.BUILD, "tests", "plugins")
DIAMETER, DENSITY = 0.01, 1000.0
STEP = 1e-4
GAS_STEP = 1e-3
STEPS = 20

SCENE = f"""
units           si
atom_style      granular
atom_modify     map array sort 0 0
boundary        f f f
newton          off
communicate     single vel yes
processors      * 1 1
region          box block 0 1 0 1 0 1 units box
create_box      1 box
create_atoms    1 single 0.25 0.5 0.5 units box
create_atoms    1 single 0.75 0.5 0.5 units box
set             group all diameter {DIAMETER} density {DENSITY}
neighbor        0.01 bin
"""
KICK = "fix kick all test/kick 0.5 0.25 -0.125\n"
MOVE = "fix move all nve/sphere\n"
DUMP = (f'dump state all custom {STEPS} dem/state id vx vy vz\n'
        'dump_modify state sort id format "%d %.17g %.17g %.17g"\n')  # fmt: skip

CONTROL = f"""
FoamFile {{ version 2.0; format ascii; class dictionary; object controlDict; }}
application interphase; startFrom startTime; startTime 0; stopAt endTime; endTime {STEPS * STEP!r}; deltaT {GAS_STEP!r};
writeControl adjustableRunTime; writeInterval 1; timePrecision 10;
"""
COUPLING = """
FoamFile {{ version 2.0; format ascii; class dictionary; object couplingDict; }}
method {method};
{plugins}
particles {{ script "dem/in.liggghts"; {step} }}
gas {{ model none; }}
{more}
"""


def environment(**changes):
    return {"INTERPHASE_PLUGIN_PATH": PLUGINS, **changes}


class PluginTest(support.ProgramTest):
    def native(self, plugins, ranks=1, script=SCENE + KICK + MOVE, **changes):
        folder = os.path.join(self.root, f"native{len(os.listdir(self.root))}")
        end = f"timestep {STEP!r}\nrun {STEPS}\n"
        support.write(os.path.join(folder, "dem/in.liggghts"), script + DUMP + end)
        support.write(os.path.join(folder, "notes.so"), "a text\n")
        command = [RUNNER, *[word for name in plugins for word in ("-plugin", name)], "-in", "dem/in.liggghts"]
        if ranks > 1:
            command = ["mpirun", "-np", str(ranks), "--oversubscribe", *command]
        done = subprocess.run(
            command, cwd=folder, env=support.environment(**environment(**changes)), stdin=subprocess.DEVNULL,
            capture_output=True, text=True, errors="replace", timeout=60,
        )  # fmt: skip
        return support.Finished(folder, done.returncode, done.stdout, done.stderr)

    def coupled(self, plugins, ranks=1, script=SCENE + KICK + MOVE, method="PLUGIN", step=f"solidStep {STEP!r};", more="",
                **changes):  # fmt: skip
        """`plugins`: names for the entry of couplingDict, or the entry as it is to be written."""
        folder = os.path.join(self.root, f"coupled{len(os.listdir(self.root))}")
        entry = plugins if isinstance(plugins, str) else f"plugins ({' '.join(f'{chr(34)}{name}{chr(34)}' for name in plugins)});"
        support.write(os.path.join(folder, "dem/in.liggghts"), script + DUMP)
        support.write(os.path.join(folder, "notes.so"), "a text\n")
        support.write(os.path.join(folder, "system/controlDict"), CONTROL)
        support.write(os.path.join(folder, "system/couplingDict"),
                      COUPLING.format(method=method, plugins=entry, step=step, more=more))  # fmt: skip
        support.write(os.path.join(folder, "system/decomposeParDict"), f"numberOfSubdomains {ranks}; method simple;")
        for rank in range(ranks if ranks > 1 else 0):
            os.makedirs(os.path.join(folder, f"processor{rank}"))
        return support.execute(folder, ranks, timeout=60, **environment(**changes))

    def solid_step(self, *given, **how):
        done = self.coupled(*given, **how)
        self.assertEqual(done.code, 0, done.text)
        return done.meta["solid_step"]

    def refused(self, done, *expected):
        self.assertGreater(done.code, 0, done.text)
        self.assertEqual(len(re.findall(r"^interphase(?:-liggghts)?: error:", done.text, re.M)), 1,
                         f"one message, of one rank:\n{done.text}")  # fmt: skip
        self.assertEqual(done.text.count("remedy:"), 1, done.text)
        self.assertFalse(os.path.exists(done.path("dem/state")), "something has moved")
        for pattern in expected:
            self.assertRegex(done.text, pattern)

    def everywhere_refused(self, plugins, *expected):
        for ranks in RANKS:
            with self.subTest(ranks=ranks, program="interphase-liggghts"):
                self.refused(self.native(plugins, ranks), *expected, "where:  option -plugin")
            with self.subTest(ranks=ranks, program="interphase"):
                self.refused(self.coupled(plugins, ranks), *expected, "where:  system/couplingDict, plugins")


class Loading(PluginTest):
    def assert_kicked(self, done):
        """Twenty kicks, exact to the last bit: the components are sums of powers of two."""
        self.assertEqual(done.code, 0, done.text)
        last = [line.split() for line in support.read(done.path("dem/state")).splitlines()[-2:]]
        expected = [STEPS * component for component in (0.5, 0.25, -0.125)]
        for row in last:
            self.assertEqual([float(word) for word in row[1:]], expected)

    def test_by_name(self):
        for ranks in RANKS:
            with self.subTest(ranks=ranks):
                self.assert_kicked(self.native(["kick"], ranks))
                self.assert_kicked(self.coupled(["kick"], ranks))

    def test_by_word_instead_of_text(self):
        self.assert_kicked(self.coupled("plugins (kick);"))

    def test_by_absolute_path(self):
        file = os.path.join(PLUGINS, "libkick.so")
        self.assert_kicked(self.native([file], INTERPHASE_PLUGIN_PATH=None))
        self.assert_kicked(self.coupled([file], INTERPHASE_PLUGIN_PATH=None))

    def test_by_path_from_the_case_on(self):
        os.symlink(os.path.join(PLUGINS, "libkick.so"), os.path.join(self.root, "mine.so"))
        self.assert_kicked(self.native(["../mine.so"], INTERPHASE_PLUGIN_PATH=None))
        self.assert_kicked(self.coupled(["../mine.so"], INTERPHASE_PLUGIN_PATH=None))

    def test_by_path_with_a_variable(self):
        self.assert_kicked(self.coupled(["$INTERPHASE_PLUGIN_PATH/libkick.so"]))

    def test_several(self):
        script = SCENE + KICK + "fix hasty all test/hasty 0 0 0\n" + MOVE
        self.assert_kicked(self.native(["kick", "hasty"], script=script))

    def test_beside_a_built_in_method(self):
        """DEM may use plug-ins, too: not every fix is a collision."""
        self.assert_kicked(self.coupled(["kick"], method="DEM"))

    def test_the_run_tells_which(self):
        done = self.coupled(["kick"])
        self.assertRegex(done.out, r"plug-ins +kick \(.*/libkick\.so: test/kick\)")
        self.assertRegex(done.meta["plugins"], r"kick \(.*/libkick\.so: test/kick\)")

    def test_no_plug_in_is_liggghts_as_it_is(self):
        done = self.native([], script=SCENE + MOVE)
        self.assertEqual(done.code, 0, done.text)
        self.assertIn(f"{STEPS} steps with 2 atoms", done.text)

    def test_errors_of_liggghts_end_it_as_in_the_packaged_program(self):
        for ranks in RANKS:
            with self.subTest(ranks=ranks):
                done = self.native(["kick"], ranks, script=SCENE + KICK + "fix move all nve/spere\n")
                self.assertEqual(done.code, 1, done.text)
                self.assertIn('ERROR: Invalid fix style: "nve/spere"', done.text)

    def test_help(self):
        done = subprocess.run([RUNNER, "-h"], env=support.environment(), capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0)
        self.assertIn("-plugin NAME_OR_PATH", done.stdout)


class Misfits(PluginTest):
    def test_another_interface(self):
        self.everywhere_refused(["other_interface"], r"libother_interface\.so is built for version 4711", "this program has version [1-9]",
                                "build the plug-in anew")  # fmt: skip

    def test_another_liggghts_compiler_and_mpi(self):
        self.everywhere_refused(["other_build"], r"libother_build\.so", r"LIGGGHTS: 3\.7\.0, this program: \d", "compiler: GCC 4, this program",
                                r"MPI: MPICH 3\.1, this program", "build the plug-in anew")  # fmt: skip

    def test_another_layout_of_classes(self):
        self.everywhere_refused(["other_sizes"], r"libother_sizes\.so", r"size of bigint \[bytes\]: 4, this program: 8",
                                r"size of Fix \[bytes\]: \d+, this program: \d+")  # fmt: skip

    def test_another_state_of_the_solid_stress(self):
        """Longer by a number; as long, but with two members changed about: either would write beside what it means."""
        self.everywhere_refused(["longer_state"], r"liblonger_state\.so", r"size of StressState \[bytes\]: \d+, this program: \d+")
        self.everywhere_refused(["swapped_state"], r"libswapped_state\.so is built against something else than this program "
                                r"\(members of StressState \(fingerprint\): -?\d+, this program: -?\d+\)")  # fmt: skip

    def test_other_functions_of_the_solid_stress(self):
        """Two of them changed about: the coupler would call one in place of the other."""
        self.everywhere_refused(["other_functions"], r"libother_functions\.so is built against something else than this program "
                                r"\(functions of SolidStress \(fingerprint\): -?\d+, this program: -?\d+\)")  # fmt: skip

    def test_the_good_one_beside_it_does_not_help(self):
        self.everywhere_refused(["kick", "other_sizes"], r"libother_sizes\.so")


class NoPlugins(PluginTest):
    def test_a_text(self):
        self.everywhere_refused(["./notes.so"], r"/notes\.so cannot be loaded", "file too short|invalid ELF header", "shared library")

    def test_a_library_like_any_other(self):
        self.everywhere_refused(["no_entry"], r"libno_entry\.so is no plug-in", "interphase_plugin", "INTERPHASE_PLUGIN")

    def test_an_entry_that_describes_nothing(self):
        self.everywhere_refused(["empty_entry"], r"libempty_entry\.so is no plug-in")

    def test_an_undefined_symbol(self):
        self.everywhere_refused(["undefined_symbol"], r"libundefined_symbol\.so cannot be loaded", r"forgotten::function\(double\)",
                                "define it")  # fmt: skip

    def test_a_library_that_it_needs(self):
        self.everywhere_refused(["needs_gone"], r"libneeds_gone\.so cannot be loaded", r"libgone\.so", "LD_LIBRARY_PATH")

    def test_a_file_that_is_not_there(self):
        self.everywhere_refused(["./nowhere.so"], r"nowhere\.so` is not there \(/.*/nowhere\.so\)", "absolute or from")

    def test_a_folder(self):
        self.everywhere_refused(["./dem"], r"dem` is a folder")

    def test_a_name_that_is_not_there(self):
        self.everywhere_refused(["kik"], r"no plug-in `kik`: no libkik\.so in " + re.escape(PLUGINS), "/plugins, .*/lib/interphase/plugins",
                                r"did you mean `kick`\?", "INTERPHASE_PLUGIN_PATH")  # fmt: skip

    def test_a_file_name_instead_of_a_name(self):
        self.everywhere_refused(["libkick.so"], r"write its path with a slash, such as `\./libkick\.so`")

    def test_on_one_rank_only(self):
        """As on machines whose disks differ: the message names the rank."""
        folder = os.path.join(self.root, "apart")
        support.write(os.path.join(folder, "in.liggghts"), SCENE + KICK + MOVE + "run 1\n")
        start = [RUNNER, "-plugin", "kick", "-in", "in.liggghts"]
        command = ["mpirun", "--oversubscribe", "-np", "1", *start, ":", "-np", "1", "env", "INTERPHASE_PLUGIN_PATH=/nowhere", *start]
        done = subprocess.run(
            command, cwd=folder, env=support.environment(**environment()), capture_output=True, text=True, timeout=60
        )
        self.refused(support.Finished(folder, done.returncode, done.stdout, done.stderr),
                     r"no libkick\.so in /nowhere", r"where:  option -plugin, on rank 1 \(\S+\)")  # fmt: skip

    def test_an_option_without_value(self):
        done = subprocess.run([RUNNER, "-plugin"], env=support.environment(), capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertIn("nothing follows the last -plugin", done.stderr)


class Styles(PluginTest):
    def test_twice_the_same_library(self):
        self.everywhere_refused(["kick", "kick"], r"libkick\.so is given twice", "name it once")

    def test_a_style_of_another_plug_in(self):
        self.everywhere_refused(["kick", "kick_again"], r"`test/kick` of the plug-in kick_again \(.*\) is brought by the plug-in kick \(",
                                "leave one")  # fmt: skip

    def test_a_style_of_liggghts(self):
        self.everywhere_refused(["takes_move"], "`nve/sphere`", "one of LIGGGHTS's own styles", "another name")

    def test_a_style_of_the_coupler(self):
        self.everywhere_refused(["takes_ours"], "`interphase/fluid`", "kept for the coupler")

    def test_a_style_that_no_script_could_name(self):
        self.everywhere_refused(["blank_style"], "`two words`")


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
