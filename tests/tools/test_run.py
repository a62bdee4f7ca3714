# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/run: what it refuses, what it writes into the run's folder, what it executes and how it ends.

Shell scripts stand in for interphase and OpenFOAM's programs, so no engine is needed.
"""

import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import time

from interphase import case_folder, ending, foam_file, launch, run_folder
from interphase.commands import run
from interphase.input_error import InputError
from interphase.tree import REPOSITORY
from scratch import InFolder, read, write


PARAMETERS = """// The scene's numbers
method    CGPM;   // DEM | CGPM
weight    8;      // real particles per parcel
velocity  2.19;   /* m/s */
endTime   1;
gasModel  pimple;
"""

COUPLING = """FoamFile { version 2.0; format ascii; class dictionary; object couplingDict; }
#include "$FOAM_CASE/parameters"
method      $method;
weight      ${weight};
particles { script "dem/in.liggghts"; variables { diameter 0.003; } }
gas     { model $gasModel; coupling twoWay; }
drag       { law BVK; }   // law Ergun;
"""

CONTROL = """#include "$FOAM_CASE/parameters"
application   interphase;
endTime       $endTime;
writeInterval 0.05; // s
functions { probe { type probes; fields (p U); } }
"""


class Bench(InFolder):
    """A folder with a case, fake programs on PATH, and a way to call tools/run there."""

    def setUp(self):
        super().setUp()
        self.case = os.path.join(self.root, "bed")
        self.out = os.path.join(self.root, "out")
        write(os.path.join(self.case, "parameters"), PARAMETERS)
        write(os.path.join(self.case, "system/couplingDict"), COUPLING)
        write(os.path.join(self.case, "system/controlDict"), CONTROL)
        write(os.path.join(self.case, "system/blockMeshDict"), "vertices ();\n")
        write(os.path.join(self.case, "dem/in.liggghts"), "units si\n")
        self.programs = os.path.join(self.root, "programs")
        self.calls = os.path.join(self.root, "calls")
        for name in ("blockMesh", "decomposePar", "reconstructPar"):
            self.program(name, "")
        self.program("mpirun", 'while [ "${1#-}" != "$1" ]; do [ "$1" = -np ] && shift; shift; done; exec "$@"')
        self.binary = self.program("interphase", "echo progress 50%; echo summary")

    def program(self, name, body):
        path = os.path.join(self.programs, name)
        write(path, f'#!/bin/sh\necho "{name} $*" >> "{self.calls}"\n{body}\n', executable=True)
        return path

    def environment(self, **changes):
        environment = {**os.environ, "PATH": self.programs + os.pathsep + os.environ["PATH"], "INTERPHASE_BIN": self.binary}
        environment.pop("WM_PROJECT_DIR", None)
        return {**environment, **changes}

    def arguments(self, *given, out=True):
        return [os.path.join(REPOSITORY, "tools/run"), *given, *(["--out", self.out] if out else [])]

    def run_tool(self, *given, out=True, environment=None, cwd=None):
        return subprocess.run(
            self.arguments(*given, out=out), env=environment or self.environment(), cwd=cwd or self.root,
            stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60,
        )

    def succeed(self, *given, **how):
        done = self.run_tool(*given, **how)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done

    def refused(self, *given, **how):
        done = self.run_tool(*given, **how)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        self.assertFalse(os.path.exists(self.calls), "a program was started before the refusal")
        return done.stderr

    def name_plugins(self, plugins):
        write(os.path.join(self.case, "system/couplingDict"), COUPLING + f"plugins {plugins};\n")

    def called(self):
        return [line.split()[0] for line in read(self.calls).splitlines()] if os.path.exists(self.calls) else []


class Refusals(Bench):
    def test_names_what_was_looked_for_in_a_folder_that_is_no_case(self):
        os.mkdir(os.path.join(self.root, "empty"))
        self.assertIn("there is no system/couplingDict in it", self.refused("empty"))

    def test_a_folder_that_does_not_exist(self):
        message = self.refused("nowhere")
        self.assertIn("nowhere: no such folder", message)
        self.assertIn("case", message)

    def test_an_unknown_parameter_gets_the_nearest_name(self):
        message = self.refused("bed", "--set", "velocty=3")
        self.assertIn("did you mean 'velocity'?", message)
        self.assertIn("bed/parameters", message)

    def test_an_unknown_parameter_far_from_all_lists_them(self):
        self.assertIn("valid names: method, weight, velocity", self.refused("bed", "--set", "zzzz=3"))

    def test_an_unknown_key_of_the_coupling_gets_the_nearest_that_the_program_knows(self):
        for name in ("mapping/widht", "system/couplingDict:mapping/widht"):
            with self.subTest(name):
                message = self.refused("bed", "--set", name + "=0.01")
                self.assertIn("did you mean 'mapping/width'", message)
                self.assertIn("bed/system/couplingDict", message)
        self.assertIn("did you mean 'particles/variables/diameter'", self.refused("bed", "--set", "particles/variables/diamter=1"))

    def test_only_the_coupling_gets_entries_that_a_case_does_not_mention(self):
        self.assertIn("no entry 'maxCo'", self.refused("bed", "--set", "system/controlDict:maxCo=0.5"))

    def test_an_unknown_file_gets_the_nearest_name(self):
        message = self.refused("bed", "--set", "system/controldict:writeInterval=1")
        self.assertIn("did you mean 'system/controlDict'", message)

    def test_a_file_outside_the_case(self):
        self.assertIn("not inside the case", self.refused("bed", "--set", "../bed/parameters:velocity=1"))

    def test_a_dictionary_is_no_value(self):
        message = self.refused("bed", "--set", "system/couplingDict:drag=Ergun")
        self.assertIn("'drag' is a dictionary", message)
        self.assertIn("law", message)

    def test_a_value_cannot_smuggle_in_entries(self):
        self.assertIn("no single value", self.refused("bed", "--set", "velocity=1; weight 2"))

    def test_a_setting_without_value(self):
        self.assertIn("KEY=VALUE", self.refused("bed", "--set", "velocity"))

    def test_dem_with_parcels(self):
        message = self.refused("bed", "--method", "DEM", "--weight", "8")
        self.assertIn("--weight 8 does not go with method DEM", message)

    def test_the_same_by_set(self):
        self.assertIn("does not go with", self.refused("bed", "--set", "method=DEM", "--set", "weight=8"))

    def test_weights_below_one_and_no_numbers(self):
        for weight in ("0.5", "-8", "nan", "inf"):
            with self.subTest(weight):
                self.assertIn("at least 1 real particle", self.refused("bed", "--weight=" + weight))
        self.assertIn("no number", self.refused("bed", "--weight", "many"))

    def test_methods_of_plug_ins_without_one(self):
        for method, name in (("TDHS", "hard_sphere"), ("cghs", "hard_sphere"), ("mp-pic", "mp_pic"), ("PLUGIN", "NAME")):
            with self.subTest(method):
                message = self.refused("bed", "--method", method)
                self.assertIn("the case names none", message)
                self.assertIn(f"add `plugins ({name});` to its system/couplingDict", message)

    def test_hard_spheres_with_parcels(self):
        self.name_plugins("(hard_sphere)")
        message = self.refused("bed", "--method", "TDHS", "--weight", "8")
        self.assertIn("--weight 8 does not go with method TDHS", message)
        self.assertIn("--method CGHS for parcels", message)

    def test_a_mistyped_method(self):
        self.assertIn("did you mean 'CGPM'?", self.refused("bed", "--method", "CGMP"))

    def test_an_end_that_is_no_time(self):
        for until in ("soon", "0", "-1"):
            with self.subTest(until):
                self.assertIn("--until", self.refused("bed", "--until=" + until))

    def test_contradicting_options(self):
        self.assertIn("contradicts", self.refused("bed", "--until", "2", "--set", "system/controlDict:endTime=3"))

    def test_no_ranks(self):
        self.assertIn("--ranks 0", self.refused("bed", "--ranks", "0"))

    def test_a_path_with_spaces(self):
        message = self.refused("bed", "--out", os.path.join(self.root, "a b"), out=False)
        self.assertIn("OpenFOAM bears no ' ' in a path", message)
        self.assertIn("--out", message)

    def test_a_run_inside_its_case_or_around_it(self):
        for place in (self.case, os.path.join(self.case, "run"), self.root):
            with self.subTest(place):
                self.assertIn("must lie apart", self.refused("bed", "--overwrite", "--out", place, out=False))

    def test_a_broken_dictionary_names_file_and_line(self):
        write(os.path.join(self.case, "system/couplingDict"), "method DEM;\ndrag { law BVK;\n")
        message = self.refused("bed")
        self.assertIn("system/couplingDict: line 2", message)

    def test_a_binary_that_is_none(self):
        message = self.refused("bed", environment=self.environment(INTERPHASE_BIN="/no/such/interphase"))
        self.assertIn("INTERPHASE_BIN=/no/such/interphase", message)


class Folders(Bench):
    def test_an_earlier_run_stays_unless_told(self):
        self.succeed("bed")
        write(os.path.join(self.out, "results.h5"), "precious")
        again = self.run_tool("bed")
        self.assertEqual(again.returncode, 2)
        self.assertIn("--overwrite", again.stderr)
        self.assertEqual(read(self.out, "results.h5"), "precious")
        self.succeed("bed", "--overwrite")
        self.assertFalse(os.path.exists(os.path.join(self.out, "results.h5")))

    def test_files_that_are_no_run_stay_even_when_told(self):
        write(os.path.join(self.out, "thesis.tex"), "precious")
        self.assertIn("no run of tools/run", self.refused("bed", "--overwrite"))
        self.assertEqual(read(self.out, "thesis.tex"), "precious")

    def test_an_empty_folder_is_taken(self):
        os.mkdir(self.out)
        self.succeed("bed")

    def test_what_an_earlier_run_left_in_the_case_is_not_copied(self):
        write(os.path.join(self.case, "processor0/1/U"), "")
        write(os.path.join(self.case, "results.h5"), "old")
        write(os.path.join(self.case, "README.md"), "# bed")
        self.succeed("bed")
        self.assertFalse(os.path.exists(os.path.join(self.out, "processor0")))
        self.assertFalse(os.path.exists(os.path.join(self.out, "results.h5")))
        self.assertTrue(os.path.exists(os.path.join(self.out, "README.md")))

    def test_default_names(self):
        name = run_folder.default_folder
        self.assertEqual(name("/c/bed", "CGPM", 8.0, 1), os.path.join(REPOSITORY, "runs/bed-CGPM-w8"))
        self.assertEqual(name("/c/bed", "DEM", 1.0, 4), os.path.join(REPOSITORY, "runs/bed-DEM-w1-4ranks"))


class Settings(Bench):
    def test_values_change_and_all_else_stays(self):
        self.succeed("bed", "--set", "velocity=3.28", "--set", "system/couplingDict:drag/law=Gidaspow",
                     "--set", "system/controlDict:functions/probe/fields=(U)")
        self.assertEqual(read(self.out, "parameters"), PARAMETERS.replace("2.19", "3.28"))
        self.assertEqual(read(self.out, "system/couplingDict"), COUPLING.replace("law BVK", "law Gidaspow"))
        self.assertEqual(read(self.out, "system/controlDict"), CONTROL.replace("(p U)", "(U)"))
        self.assertEqual(read(self.case, "parameters"), PARAMETERS, "the case itself stays as it is")

    def test_what_the_program_knows_and_the_case_does_not_mention_is_added(self):
        self.succeed("bed", "--set", "mapping/width=0.01", "--set", "drag/selfDisturbance=left", "--set", "system/couplingDict:mapping/type=kernel",
                     "--set", "drag/law=Ergun")
        self.assertEqual(read(self.out, "system/couplingDict"),
                         COUPLING.replace("law BVK; }", "law Ergun; selfDisturbance left; }") + "mapping { width 0.01; type kernel; }\n")
        self.assertEqual(read(self.out, "parameters"), PARAMETERS)

    def test_a_weight_that_the_case_does_not_mention_is_added(self):
        write(os.path.join(self.case, "system/couplingDict"), COUPLING.replace("weight      ${weight};\n", ""))
        self.succeed("bed", "--weight", "27")
        self.assertEqual(foam_file.value(read(self.out, "system/couplingDict"), "weight"), "27")

    def test_method_dem_alone_says_weight_one(self):
        self.succeed("bed", "--method", "dem")
        self.assertEqual(read(self.out, "parameters"), PARAMETERS.replace("CGPM; ", "DEM; ", 1).replace("8;", "1;"))

    def test_method_tdhs_alone_says_weight_one(self):
        self.name_plugins("(hard_sphere)")
        self.succeed("bed", "--method", "tdhs")
        self.assertEqual(read(self.out, "parameters"), PARAMETERS.replace("CGPM; ", "TDHS; ", 1).replace("8;", "1;"))

    def test_parcels_of_plug_ins_keep_the_weight_of_the_case(self):
        self.name_plugins("(hard_sphere)")
        for method in ("CGHS", "PLUGIN"):
            self.succeed("bed", "--method", method, "--overwrite")
            self.assertEqual(read(self.out, "parameters"), PARAMETERS.replace("CGPM; ", f"{method}; ", 1))

    def test_plug_ins_outside_the_case_are_found_from_the_run_s_folder(self):
        """Names, absolute paths and files of the case itself, which come along, stay as they are."""
        self.name_plugins('(hard_sphere "../build/libmine.so" "/opt/libyours.so" "lib/libours.so")')
        self.succeed("bed")
        written = foam_file.value(read(self.out, "system/couplingDict"), "plugins")
        self.assertEqual(written, f'(hard_sphere "{self.root}/build/libmine.so" "/opt/libyours.so" "lib/libours.so")')

    def test_cgpm_keeps_the_weight_of_the_case(self):
        self.succeed("bed", "--method", "CGPM")
        self.assertEqual(read(self.out, "parameters"), PARAMETERS)

    def test_weight(self):
        self.succeed("bed", "--weight", "27")
        self.assertIn("weight    27;", read(self.out, "parameters"))

    def test_method_and_weight_written_in_the_coupling_itself(self):
        text = COUPLING.replace("$method", "CGPM").replace("${weight}", "8")
        write(os.path.join(self.case, "system/couplingDict"), text)
        self.succeed("bed", "--method", "DEM")
        self.assertIn("method      DEM;\nweight      1;", read(self.out, "system/couplingDict"))

    def test_until_goes_where_end_time_is_written(self):
        self.succeed("bed", "--until", "0.2")
        self.assertIn("endTime   0.2;", read(self.out, "parameters"))
        shutil.rmtree(self.out)
        write(os.path.join(self.case, "system/controlDict"), CONTROL.replace("$endTime", "1"))
        self.succeed("bed", "--until", "0.2")
        self.assertIn("endTime       0.2;", read(self.out, "system/controlDict"))

    def test_subdomains(self):
        file = os.path.join(self.case, "system/decomposeParDict")
        dictionary = "numberOfSubdomains 2; // ranks\nmethod simple;\nsimpleCoeffs { n (1 2 1); delta 0.001; }\n"
        write(file, dictionary)
        self.succeed("bed", "--ranks", "3")
        self.assertEqual(read(self.out, "system/decomposeParDict"), dictionary.replace("2;", "3;").replace("(1 2 1)", "(1 3 1)"))
        by_macro = "numberOfSubdomains 2;\nmethod simple;\nsimpleCoeffs { n (1 $numberOfSubdomains 1); }\n"
        write(file, by_macro)
        self.succeed("bed", "--ranks", "3", "--overwrite")
        self.assertEqual(read(self.out, "system/decomposeParDict"), by_macro.replace("2;", "3;"))
        write(file, "numberOfSubdomains 2;\nmethod scotch;\n")
        self.succeed("bed", "--ranks", "3", "--overwrite")
        self.assertEqual(read(self.out, "system/decomposeParDict"), "numberOfSubdomains 3;\nmethod scotch;\n")
        os.remove(file)
        self.succeed("bed", "--ranks", "3", "--overwrite")
        self.assertEqual(foam_file.value(read(self.out, "system/decomposeParDict"), "simpleCoeffs/n"), "(3 1 1)")


class Execution(Bench):
    def printed_command(self, done):
        lines = done.stdout.splitlines()
        at = lines.index("running")
        return lines[at + 1].strip(), lines[at + 2].strip()

    def test_serial_order_and_command(self):
        done = self.succeed("bed")
        self.assertEqual(self.called(), ["blockMesh", "interphase"])
        move, line = self.printed_command(done)
        self.assertEqual(move, f"cd {self.out}")
        self.assertTrue(line.endswith(f"{self.binary} -case {self.out}"), line)
        self.assertIn("progress 50%\nsummary\n", done.stdout)
        self.assertEqual(read(self.out, "log.interphase"), "progress 50%\nsummary\n")
        self.assertTrue(os.path.exists(os.path.join(self.out, "bed.foam")))
        self.assertIn(os.path.join(self.out, "bed.foam"), done.stdout)
        self.assertEqual(json.loads(read(self.out, "run.json"))["exit_code"], 0)

    def test_the_printed_command_does_the_same(self):
        move, line = self.printed_command(self.succeed("bed"))
        os.remove(self.calls)
        copied = self.environment()
        subprocess.run(["sh", "-c", f"{move} && {line}"], env=copied, check=True, capture_output=True)
        self.assertEqual(read(self.calls), f"interphase -case {self.out}\n")

    def test_parallel_order_and_command(self):
        self.program("decomposePar", 'mkdir -p "$2/processor0/0" "$2/processor1/0"')
        self.binary = self.program("interphase", 'mkdir -p "$3/processor0/0.5"')
        done = self.succeed("bed", "--ranks", "2")
        self.assertEqual(self.called(), ["blockMesh", "decomposePar", "mpirun", "interphase", "reconstructPar"])
        words = shlex.split(self.printed_command(done)[1])
        words = words[words.index("mpirun"):]
        self.assertEqual(words[:3], ["mpirun", "-np", "2"])
        self.assertEqual(words[-4:], [self.binary, "-parallel", "-case", self.out])

    def test_nothing_to_reconstruct_where_no_later_time_was_written(self):
        self.succeed("bed", "--ranks", "2")
        self.assertNotIn("reconstructPar", self.called())

    def test_oversubscribes_beyond_the_cores(self):
        self.assertIn("--oversubscribe", launch.command("x", "/r", launch.cores() + 1))
        self.assertNotIn("--oversubscribe", launch.command("x", "/r", launch.cores()))

    def test_particles_alone_need_no_mesh(self):
        done = self.succeed("bed", "--ranks", "2", "--set", "gasModel=none")
        self.assertEqual(self.called(), ["mpirun", "interphase"])
        self.assertTrue(os.path.isdir(os.path.join(self.out, "processor1")))
        self.assertFalse(os.path.exists(os.path.join(self.out, "bed.foam")), done.stdout)

    def test_prepare_runs_in_the_copy_with_tools_on_path_before_the_mesh(self):
        write(os.path.join(self.case, "prepare"),
              f'#!/bin/sh\necho prepare >> "{self.calls}"\npwd\ncommand -v picture\ngrep velocity parameters\ntouch dem/bed.data\n',
              executable=True)
        self.succeed("bed", "--set", "velocity=4.38")
        self.assertEqual(self.called(), ["prepare", "blockMesh", "interphase"])
        log = read(self.out, "log.prepare").splitlines()
        self.assertEqual(log[0], os.path.realpath(self.out))
        self.assertEqual(log[1], os.path.join(REPOSITORY, "tools/picture"))
        self.assertIn("4.38", log[2])
        self.assertTrue(os.path.exists(os.path.join(self.out, "dem/bed.data")))

    def test_a_step_that_fails_shows_its_last_lines_and_its_log(self):
        self.program("blockMesh", "echo inconsistent point; exit 7")
        done = self.run_tool("bed")
        self.assertEqual(done.returncode, 1)
        self.assertIn("blockMesh failed (exit code 7)", done.stderr)
        self.assertIn("inconsistent point", done.stderr)
        self.assertIn(os.path.join(self.out, "log.blockMesh"), done.stderr)
        self.assertNotIn("interphase", self.called())

    def test_exit_code_is_the_program_s(self):
        self.binary = self.program("interphase", "echo NaN in U; exit 3")
        done = self.run_tool("bed", "--quiet")
        self.assertEqual(done.returncode, 3)
        self.assertEqual(done.stdout, "")
        self.assertIn("NaN in U", done.stderr)
        self.assertIn(os.path.join(self.out, "log.interphase"), done.stderr)
        self.assertFalse(os.path.exists(os.path.join(self.out, "bed.foam")))

    def test_the_cause_is_the_last_thing_on_the_screen(self):
        """A launcher's banner buries it; where no message of the program is there, the banner is the cause."""
        rule = "-" * 74
        banner = f"{rule}\nmpirun noticed that process rank 1 with PID 0 on node n1 exited on signal 9 (Killed).\n{rule}"
        message = "interphase: error: it broke\n  where:  here\n  remedy: mend it"
        for quiet in ((), ("--quiet",)):
            self.binary = self.program("interphase", f"echo '{message}'; echo '{banner}'; exit 4")
            done = self.run_tool("bed", "--overwrite", *quiet)
            self.assertEqual(done.returncode, 4)
            self.assertIn("(exit code 4: LIGGGHTS ended with an error of its own)", done.stderr)
            self.assertTrue(done.stderr.endswith(f"\n{message}\n"), done.stderr)
        self.binary = self.program("interphase", f"echo '{banner}'; exit 137")
        self.assertRegex(self.run_tool("bed", "--overwrite").stderr, r"killed by SIGKILL[^\0]*\n.*process rank 1 .*\n.*want of memory.*\n$")

    def test_kinds_of_exit_code_are_those_of_the_program(self):
        """The table of tools/run, that of the page, and the program's enum."""
        header = read(REPOSITORY, "coupler/base/exit_code.hpp")
        codes = {int(code) for code in re.findall(r"^ +\w+ = (\d+),", header, re.M)}
        self.assertEqual(codes, {0, *ending.KINDS})
        page = re.findall(r"^\| (\d+) \|", read(REPOSITORY, "tools/CLUSTERS.md"), re.M)
        self.assertEqual({int(code) for code in page} - {130, 137, 139, 143}, codes | {2})

    def test_a_killed_program_is_no_success(self):
        self.binary = self.program("interphase", "kill -SEGV $$")
        done = self.run_tool("bed")
        self.assertEqual(done.returncode, 128 + signal.SIGSEGV)
        self.assertIn("killed by SIGSEGV", done.stderr)

    def test_signals_reach_the_program_and_its_exit_code_comes_back(self):
        for number, name in ((signal.SIGINT, "INT"), (signal.SIGTERM, "TERM")):
            with self.subTest(name):
                self.binary = self.program("interphase", f"trap 'echo stopping on {name}; exit 9' {name}\necho ready\n"
                                                         "while :; do sleep 0.05; done")
                tool = subprocess.Popen(self.arguments("bed", "--overwrite"), env=self.environment(), cwd=self.root,
                                        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                self.addCleanup(tool.kill)
                while "ready" not in (line := tool.stdout.readline()):
                    self.assertTrue(line, "ended before the program was ready")
                time.sleep(0.1)
                tool.send_signal(number)
                out, _ = tool.communicate(timeout=20)
                self.assertEqual(tool.returncode, 9)
                self.assertIn(f"stopping on {name}", out)
                self.assertIn(f"stopping on {name}", read(self.out, "log.interphase"))

    def stopped(self, trap, *options):
        """tools/run on a program that does `trap` on SIGUSR2, asked to stop by SIGINT: exit code, output, errors."""
        self.binary = self.program("interphase", f"trap '{trap}' USR2\necho ready\nwhile :; do sleep 0.05; done")
        self.program("mpirun", 'while [ "$1" != -parallel ]; do last=$1; shift; done; exec "$last" "$@"')
        tool = subprocess.Popen(self.arguments("bed", "--overwrite", "--ranks", "2", *options), env=self.environment(),
                                cwd=self.root, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(tool.kill)
        while "ready" not in (line := tool.stdout.readline()):
            self.assertTrue(line, f"ended before the program was ready: {tool.stderr.read()}" if not line else "")
        time.sleep(0.1)
        tool.send_signal(signal.SIGINT)
        if not trap.endswith("exit 140"):
            time.sleep(0.5)
            tool.send_signal(signal.SIGINT)
        out, err = tool.communicate(timeout=20)
        return tool.returncode, out, err

    def test_mpirun_would_end_the_ranks_so_it_hands_on_sigusr2(self):
        """What there is, is made easy to look at; the exit code is that of the signal that tools/run got."""
        code, out, err = self.stopped('echo stopping; mkdir -p "$3/processor0/0.5"; exit 140')
        self.assertEqual(code, 128 + signal.SIGINT)
        self.assertIn("stopping", out)
        self.assertIn("stopped by SIGINT before its end", err)
        self.assertTrue(os.path.exists(os.path.join(self.out, "bed.foam")))
        self.assertEqual(json.loads(read(self.out, "run.json"))["exit_code"], 130)

    def test_a_second_signal_ends_it_as_it_is(self):
        code, _, err = self.stopped("echo not yet")
        self.assertEqual(code, 128 + signal.SIGINT)
        self.assertIn("stopped before its end", err)
        self.assertFalse(os.path.exists(os.path.join(self.out, "bed.foam")))

    def test_quiet_prints_nothing_on_success(self):
        done = self.succeed("bed", "--quiet", "--no-picture")
        self.assertEqual((done.stdout, done.stderr), ("", ""))
        self.assertIn("summary", read(self.out, "log.interphase"))

    def test_the_engines_environment(self):
        self.binary = self.program("interphase", "env")
        self.succeed("bed")
        seen = read(self.out, "log.interphase").splitlines()
        self.assertIn("WM_PROJECT_DIR=/usr/share/openfoam", seen)
        self.assertIn("OMP_NUM_THREADS=1", seen)
        self.succeed("bed", "--overwrite", environment=self.environment(WM_PROJECT_DIR="/opt/foam"))
        self.assertIn("WM_PROJECT_DIR=/opt/foam", read(self.out, "log.interphase").splitlines())

    def test_works_from_elsewhere(self):
        self.succeed(self.case, cwd="/")

    def test_a_picture_that_fails_is_a_warning(self):
        done = self.succeed("bed")  # the fake program writes no particles.h5
        self.assertIn("warning: picture failed", done.stderr)
        self.assertNotIn("picture", self.succeed("bed", "--overwrite", "--no-picture").stderr)


class Mesh(Bench):
    """A mesh that is there is used; else blockMesh makes one. Which, is told."""

    def finished_mesh(self, end=""):
        for name in ("points", "faces", "owner", "neighbour", "boundary"):
            write(os.path.join(self.case, "constant/polyMesh", name + end), "the user's own")

    def test_none(self):
        os.remove(os.path.join(self.case, "system/blockMeshDict"))
        done = self.run_tool("bed")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, "no constant/polyMesh with points, .*system/blockMeshDict or constant/polyMesh/blockMeshDict.*add a dictionary")

    def test_of_the_dictionary(self):
        self.assertIn("mesh: of system/blockMeshDict, by blockMesh", self.succeed("bed").stdout)

    def test_of_the_dictionary_in_its_old_place(self):
        os.makedirs(os.path.join(self.case, "constant/polyMesh"))
        shutil.move(os.path.join(self.case, "system/blockMeshDict"), os.path.join(self.case, "constant/polyMesh/blockMeshDict"))
        done = self.succeed("bed")
        self.assertEqual(self.called(), ["blockMesh", "interphase"])
        self.assertIn("mesh: of constant/polyMesh/blockMeshDict, by blockMesh", done.stdout)

    def test_of_two_dictionaries(self):
        write(os.path.join(self.case, "constant/polyMesh/blockMeshDict"), "vertices ();")
        done = self.run_tool("bed")
        self.assertEqual(done.returncode, 2)
        self.assertIn("two dictionaries for blockMesh, system/blockMeshDict and constant/polyMesh/blockMeshDict: remove one", done.stderr)

    def test_the_user_s_own_stays(self):
        for end in ("", ".gz"):
            self.finished_mesh(end)
            done = self.succeed("bed", "--overwrite")
            self.assertNotIn("blockMesh", self.called())
            self.assertRegex(done.stdout, r"mesh: constant/polyMesh of the case, as it is; system/blockMeshDict is not looked at \(remove constant/polyMesh")
            self.assertEqual(read(self.out, "constant/polyMesh/points" + end), "the user's own")
            shutil.rmtree(os.path.join(self.case, "constant/polyMesh"))

    def test_a_newer_dictionary_is_told(self):
        self.finished_mesh()
        os.utime(os.path.join(self.case, "constant/polyMesh/points"), (1e9, 1e9))
        self.assertIn("system/blockMeshDict, though it is newer, is not looked at", self.succeed("bed").stdout)

    def test_settings_of_a_mesh_that_is_there(self):
        """... would change nothing."""
        write(os.path.join(self.case, "parameters"), PARAMETERS + "cells 20;\nheight 1;\n")
        write(os.path.join(self.case, "system/blockMeshDict"), "vertices ((0 0 $height)); blocks (${cells});\nscale 1;\n")
        self.succeed("bed", "--set", "cells=40")
        self.finished_mesh()
        for setting in ("cells=40", "height=2", "system/blockMeshDict:scale=2"):
            message = self.refused_now("bed", "--set", setting)
            self.assertRegex(message, "is of the mesh that system/blockMeshDict describes.*remove constant/polyMesh")
        self.succeed("bed", "--overwrite", "--set", "velocity=3")

    def refused_now(self, *given):
        if os.path.exists(self.calls):
            os.remove(self.calls)
        return self.refused(*given)


class CollatedFiles(Bench):
    def test_are_reconstructed(self):
        """Two ranks' parts in one folder: it is not mistaken for an undecomposed case, and its fields are put together."""
        self.program("decomposePar", 'mkdir -p "$2/processors2/0"')
        self.binary = self.program("interphase", 'mkdir -p "$3/processors2/0.5"')
        self.succeed("bed", "--ranks", "2")
        self.assertEqual(self.called(), ["blockMesh", "decomposePar", "mpirun", "interphase", "reconstructPar"])
        self.assertFalse(os.path.exists(os.path.join(self.out, "processor0")))

    def test_are_left_by_a_run(self):
        write(os.path.join(self.case, "processors4/0/U"), "")
        self.succeed("bed")
        self.assertFalse(os.path.exists(os.path.join(self.out, "processors4")))


class Rights(Bench):
    """Somebody who may not write everywhere: a message, or it works, and never a traceback."""

    def setUp(self):
        super().setUp()
        # root may do all: it takes another's place
        self.place = {"user": 65534, "group": 65534, "extra_groups": []} if os.geteuid() == 0 else {}
        self.mine = os.path.join(self.root, "mine")
        os.makedirs(self.mine)
        os.chmod(self.root, 0o755)
        if self.place:
            os.chown(self.mine, 65534, 65534)
        self.out = os.path.join(self.mine, "out")
        self.calls = os.path.join(self.mine, "calls")
        for name in ("blockMesh", "decomposePar", "reconstructPar", "interphase"):
            os.chmod(self.program(name, "echo done"), 0o755)

    def run_as_other(self, *given):
        return subprocess.run(
            self.arguments(*given), env=self.environment(HOME=self.mine), cwd=self.mine, stdin=subprocess.DEVNULL, capture_output=True,
            text=True, timeout=60, **self.place,
        )  # fmt: skip

    def close(self, folder):
        for base, folders, files in os.walk(folder):
            for name in files:
                os.chmod(os.path.join(base, name), 0o444)
            os.chmod(base, 0o555)
        self.addCleanup(self.open, folder)

    @staticmethod
    def open(folder):
        for base, _, _ in os.walk(folder):
            os.chmod(base, 0o755)

    def test_a_read_only_case(self):
        self.close(self.case)
        done = self.run_as_other(self.case, "--set", "velocity=3", "--no-picture")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("velocity  3;", read(self.out, "parameters"))
        self.assertEqual(self.run_as_other(self.case, "--overwrite", "--no-picture").returncode, 0)

    def test_a_case_that_cannot_be_read(self):
        hidden = os.path.join(self.case, "dem/in.liggghts")
        os.chmod(hidden, 0)
        done = self.run_as_other(self.case)
        self.assertEqual(done.returncode, 2)
        self.assertNotIn("Traceback", done.stderr)
        self.assertRegex(done.stderr, "cannot copy .*dem/in.liggghts.*Permission denied.*right to read")

    def test_a_run_s_folder_that_cannot_be_written(self):
        closed = os.path.join(self.root, "closed")
        os.makedirs(closed)
        os.chmod(closed, 0o555)
        self.out = os.path.join(closed, "run")
        done = self.run_as_other(self.case)
        self.assertEqual(done.returncode, 1)
        self.assertNotIn("Traceback", done.stderr)
        self.assertRegex(done.stderr, f"{self.out}: Permission denied.*--out DIR")


class Cases(Bench):
    def test_a_mistyped_case_is_guessed_and_all_are_listed(self):
        write(os.path.join(self.root, "sscp1/system/couplingDict"), "")
        with self.assertRaises(InputError) as caught:
            case_folder.checked_case("/x/ssccp1", self.root)
        self.assertRegex(str(caught.exception), r"did you mean '[^']*sscp1'\?")
        self.assertRegex(str(caught.exception), r"cases here:\n  .*bed\n  .*sscp1")
