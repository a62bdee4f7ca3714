# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 600
"""A run that fails: every rank is gone within seconds, the cause is the last thing on the screen, the exit code says which
kind. The failures are those of a fix, tests/engines/liggghts/plugins/fail.cpp, in the 55th solid step of 200."""

import os
import re
import shutil
import subprocess

import gas_box
import support

PLUGINS = os.path.join(support.BUILD, "tests", "plugins")
DIVERGED, LIGGGHTS, OPENFOAM, DISK, INTERNAL = 3, 4, 5, 6, 7

# Ranks that are left alone wait 3 s for the others, mpirun kills what does not go after another one. The rest is a busy
# machine: without an end the run would go on for ever.
SECONDS = 30


class Failing(support.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.sound = gas_box.write(os.path.join(cls.shared, "sound"), end=0.02)
        support.must(cls.sound, "decomposePar")

    def scene(self, how=None, rank=-1, step=55):
        folder = self.copied(self.sound, f"case{len(os.listdir(self.root))}")
        if how:
            self.edit(folder, "system/couplingDict", r"^method DEM;", "method DEM; plugins (fail);")
            path = os.path.join(folder, "dem/in.liggghts")
            support.write(path, support.read(path) + f"fix broken all test/fail {how} {rank} {step}\n")
        return folder

    def execute(self, folder, ranks, **changes):
        return support.execute(folder, ranks, SECONDS, INTERPHASE_PLUGIN_PATH=PLUGINS, **changes)

    def ends_with_cause(self, done, code, *expected, own_lines=r"  \||  (where|when|remedy|rank|disk): +"):
        """The message is the only one, with nothing behind it."""
        self.assertEqual(done.code, code, done.text)
        self.assertEqual(len(re.findall(r"^interphase: error:", done.err, re.M)), 1, done.text)
        message = done.err[done.err.index("interphase: error:"):].rstrip("\n").split("\n")
        for line in message[1:]:
            self.assertRegex(line, f"^({own_lines})", "not of the message:\n" + done.text)
        for pattern in expected:
            self.assertRegex("\n".join(message), pattern)

    def fails(self, how, code, *expected, cases=((-1, 1), (-1, 2), (0, 2), (1, 2))):
        """`cases`: which rank fails, of how many."""
        for rank, ranks in cases:
            with self.subTest(how=how, rank=rank, ranks=ranks):
                alone = [rf"\n  rank:   {rank}, which of 0 to 1 failed first"] if rank >= 0 else []
                self.ends_with_cause(self.execute(self.scene(how, rank), ranks), code, *expected, *alone)

    def test_error_of_all_ranks(self):
        """Called on one rank only, LIGGGHTS's Error::all waits for the others without end."""
        self.fails("all", LIGGGHTS, r"\n  \| ERROR: told to fail by all ", r"when:   in the gas step from t = 0.005 s to 0.006 s")

    def test_error_of_one_rank(self):
        self.fails("one", LIGGGHTS, r"\n  \| ERROR on proc \d: told to fail by one ")

    def test_end_without_an_error(self):
        self.fails("exit", LIGGGHTS, "LIGGGHTS stopped", cases=((-1, 1), (1, 2)))
        self.fails("abort", LIGGGHTS, "LIGGGHTS stopped", cases=((1, 2),))

    def test_exception(self):
        self.fails("throw", INTERNAL, "told to fail by an exception", cases=((-1, 2), (1, 2)))

    def test_number_that_is_not_finite(self):
        done = self.execute(self.scene("nan"), 2)
        self.ends_with_cause(done, DIVERGED, r"particle 1 .* is not finite", r"when:   in the gas step from t = 0.005 s to 0.006 s")

    @support.unless_sanitized
    def test_rank_that_dies(self):
        """mpirun has the last word, and it is the cause; the code is the signal's."""
        for how, name, code in (("kill", r"signal 9 \(Killed\)", 137), ("segv", r"signal 11 \(Segmentation fault\)", 139)):
            with self.subTest(how=how):
                done = self.execute(self.scene(how, 1), 2)
                self.assertEqual(done.code, code, done.text)
                self.assertRegex(done.err.rstrip("-\n").split("\n")[-1], r"process rank 1 .* on " + name)

    def test_error_of_openfoam_on_one_rank(self):
        folder = self.scene()
        os.remove(os.path.join(folder, "processor1/0/U"))
        self.ends_with_cause(self.execute(folder, 2), OPENFOAM, r"cannot find file .*processor1/0/U", r"\n  rank:   1, ")

    def test_error_of_openfoam_on_all_ranks(self):
        folder = self.scene()
        self.edit(folder, "system/fvSolution", "solver PCG", "solver PCGG")
        self.ends_with_cause(self.execute(folder, 2), OPENFOAM, "PCGG", own_lines="  |Valid|4|$")

    def case_on_small_disk(self):
        case = os.path.join(self.small_disk("3m"), "case")
        shutil.copytree(self.sound, case)
        self.edit(case, "system/controlDict", r"endTime 0\.02;", "endTime 1000;")
        return case

    def test_disk_that_is_full_of_fields(self):
        """OpenFOAM says nothing of fields that it could not write."""
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                case = self.case_on_small_disk()
                self.edit(case, "system/controlDict", "writeInterval 1000000;", "writeInterval 1;")
                self.ends_with_cause(self.execute(case, ranks), DISK, "disk")

    def test_disk_that_another_fills(self):
        """Nothing is due but lines of LIGGGHTS's log and progress; that a file is there still says little."""
        case = self.case_on_small_disk()
        script = os.path.join(case, "dem/in.liggghts")
        support.write(script, support.read(script) + "thermo 10\n")
        program = support.start(case, 2)
        self.addCleanup(lambda: program.poll() is None and program.kill())
        while "t = 0 " not in (line := program.stdout.readline()):
            self.assertTrue(line, "ended before its first step")
        support.fill_disk(case)
        out, err = program.communicate(timeout=SECONDS)
        self.ends_with_cause(support.Finished(case, program.returncode, out, err), DISK, "the disk is full", "(remedy: |disk: +)make room")

    @support.unless_sanitized
    def test_script(self):
        """LIGGGHTS adds a joke to every fifth error, from memory that it has freed; here it would to each."""
        always = os.path.join(self.root, "always.so")
        subprocess.run(["cc", "-shared", "-fPIC", "-x", "c", "-", "-o", always], input="int rand(void) { return 0; }", text=True, check=True)
        folder = self.scene()
        self.edit(folder, "dem/in.liggghts", "nve/sphere", "nve/spere")
        done = self.execute(folder, 1, LD_PRELOAD=always)
        self.ends_with_cause(done, LIGGGHTS, r"\n  \| fix move all nve/spere\n  \| ERROR: .*\(\S+\.cpp:\d+\)\n  remedy: the line before ERROR")
        log = support.read(folder, "dem/log.liggghts")
        self.assertRegex(log.rstrip("\n").split("\n")[-1], r"^ERROR: ")  # nothing follows

    @support.unless_sanitized
    def test_script_without_gas(self):
        """interphase-liggghts says the same, without the joke, on any number of ranks."""
        always = os.path.join(self.root, "always.so")
        subprocess.run(["cc", "-shared", "-fPIC", "-x", "c", "-", "-o", always], input="int rand(void) { return 0; }", text=True, check=True)
        folder = self.scene()
        script = support.read(folder, "dem/in.liggghts")
        support.write(os.path.join(folder, "wrong.in"), script.replace("fix move all nve/sphere", "fix move all move/mesh"))
        support.write(os.path.join(folder, "quits.in"), script + "quit\n")
        runner = os.path.join(support.BUILD, "interphase-liggghts")
        for ranks in (1, 2):
            def run(name):
                command = [*(() if ranks == 1 else ("mpirun", "-np", str(ranks), "--oversubscribe")), runner, "-in", name]
                return subprocess.run(command, cwd=folder, env=support.environment(LD_PRELOAD=always), capture_output=True, timeout=60)

            done = run("wrong.in")
            self.assertEqual(done.returncode, 1)  # as the packaged program
            text = done.stderr.decode("ascii")  # no bytes of other memory
            self.assertRegex(text, r"interphase-liggghts: error: LIGGGHTS stopped:\n  \| ERROR: .*\(\S+\.cpp:\d+\)\n  remedy: .*\n")
            self.assertRegex(support.read(folder, "log.liggghts").rstrip("\n").split("\n")[-1], "^ERROR: ")
            quits = run("quits.in")
            self.assertEqual((quits.returncode, quits.stderr.decode("ascii").count("ERROR")), (1, 0))  # likewise

    def test_script_that_quits(self):
        folder = self.scene()
        self.edit(folder, "dem/in.liggghts", "^fix move", "quit\nfix move")
        self.ends_with_cause(self.execute(folder, 2), LIGGGHTS, "ERROR: the script asked LIGGGHTS to quit")
