# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 1200
"""Plug-ins, through interphase (entry `plugins` of system/couplingDict) and through interphase-liggghts (option -plugin), on one
rank and on two: what fits is loaded and does its work; what does not is refused with one message that names the library,
what was found, what was expected and what to do, before anything has moved."""

import os
import re
import subprocess

import support
from plugin_scene import RANKS, RUNNER, PLUGINS, STEPS, SCENE, KICK, MOVE, environment, PluginTest


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
