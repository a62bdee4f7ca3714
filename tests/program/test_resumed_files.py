# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 1
# timeout: 600
"""What a run wrote into files of its script and its function objects is there after a resume: dumps go on without seam, other files are
kept beside those that go on."""

import glob
import os
import re
import shutil

import numpy

import support
from resumed_run import ResumedRun

DUMPS = """\
dump whole all custom 100 dem/whole.txt id type x y z fx fy fz
dump some all xyz 100 dem/some.xyz
dump each all custom 100 dem/each.*.txt id type x y z
"""
PRINTS = """\
variable n equal atoms
compute energy all ke
fix words all print 100 "$n" file dem/words.txt screen no
fix mean all ave/time 20 5 100 c_energy file dem/mean.txt
"""
LIMITED = """\
group none id 0
fix slow none nve/limit absolute 0.001
"""
FUNCTIONS = """\
functions
{
    flow { type surfaceFieldValue; libs (fieldFunctionObjects); writeControl timeStep; writeInterval 3; writeFields no; log no;
           regionType patch; name outlet; operation sum; fields (voidagePhi); }
    mean { type fieldAverage; libs (fieldFunctionObjects); fields (p { mean on; prime2Mean off; base time; }); }
    probes { type probes; libs (sampling); fields (p pMean); probeLocations ((0.02 0.01 0.05)); }
    seldom { type probes; libs (sampling); writeControl runTime; writeInterval 0.003; fields (p); probeLocations ((0.02 0.01 0.05)); }
    off { type fieldAverage; enabled no; }
}
"""


class ResumedFiles(support.ProgramTest):
    stop, end = 0.01, 0.02
    bed, copies, ready, resumed = ResumedRun.bed, ResumedRun.copies, ResumedRun.ready, ResumedRun.resumed

    def pair(self, lines):
        """The case twice: one to run through and one to be stopped, at a step that dumps: gas steps are of 200 solid steps."""
        folders = self.ready("DEM")
        for folder in folders:
            script = os.path.join(folder, "dem/in.liggghts")
            support.write(script, support.read(script) + lines)
            self.edit(folder, "system/couplingDict", r"^ +variables", "    solidStep 5e-6; variables")
        return folders

    def equal(self, folders, name):
        with open(os.path.join(folders[0], name), "rb") as first, open(os.path.join(folders[1], name), "rb") as second:
            self.assertTrue(first.read() == second.read(), name)

    def test_dumps_go_on(self):
        """To the last byte as in a run that was not stopped, which has the same numbers."""
        folders = straight, stopped = self.pair(DUMPS)
        self.run_case(straight)
        self.resumed(stopped)
        names = [os.path.relpath(path, straight) for path in glob.glob(os.path.join(straight, "dem/each.*"))]
        self.assertEqual(len(names), 4000 // 100 + 1)
        for name in ("dem/whole.txt", "dem/some.xyz", *names):
            self.equal(folders, name)
        for log, words in (("dem/log.liggghts", r"^dump whole "), ("log.openfoam", "Operating solver in PISO mode")):
            self.assertEqual(len(re.findall(words, support.read(stopped, log), re.M)), 2, log)  # of both parts
        # the line of the start is of the particles that were kept
        (atoms,) = re.findall(r"^ +2000 +(\d+)", support.read(stopped, "dem/log.liggghts"), re.M)
        self.assertIn(f"ITEM: NUMBER OF ATOMS\n{atoms}\n", support.read(stopped, "dem/each.2000.txt"))

    def test_dumps_beyond_the_checkpoint(self):
        """What a part of the run that is lost wrote after its last checkpoint is put aside."""
        folders = straight, stopped = self.pair(DUMPS)
        self.run_case(straight)
        self.set_entry(stopped, "system/controlDict", "endTime", self.stop)
        self.run_case(stopped)
        for name, torn in (("dem/whole.txt", "ITEM: TIMESTEP\n2050\nITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS id\n1\n"),
                           ("dem/some.xyz", "1\nAtoms. Timestep: 2050\n1 0 0 0\n3\nAtoms. Timestep: 2100\n1 0")):  # fmt: skip
            with open(os.path.join(stopped, name), "a", encoding="utf-8") as stream:
                stream.write(torn)
        self.set_entry(stopped, "system/controlDict", "endTime", self.end)
        done = self.run_case(stopped, options=["-resume"])
        for name, dump in (("dem/whole.txt", "whole (custom)"), ("dem/some.xyz", "some (xyz)")):
            self.equal(folders, name)
            self.assertIn(f"dump {dump} goes on at t = 0.01 s; later frames are in {name}-beyond-0.01", done.err)
            self.assertIn("2050", support.read(stopped, name + "-beyond-0.01"))

    def test_a_refused_resume_leaves_all_as_it_was(self):
        _, stopped = self.pair(DUMPS + PRINTS)
        self.set_entry(stopped, "system/controlDict", "endTime", self.stop)
        self.run_case(stopped)
        names = sorted(os.listdir(os.path.join(stopped, "dem")))
        before = [support.read(stopped, "dem", name) for name in names if name != "log.liggghts"]
        self.edit(stopped, "constant/transportProperties", r"^mu .*$", "mu 2e-5;")
        self.assertEqual(support.execute(stopped, options=["-resume"]).code, 1)
        self.assertEqual(sorted(os.listdir(os.path.join(stopped, "dem"))), names)
        self.assertTrue(before == [support.read(stopped, "dem", name) for name in names if name != "log.liggghts"])

    def test_other_files_stay(self):
        straight, stopped = self.pair(PRINTS + LIMITED)
        self.run_case(straight)
        done = self.resumed(stopped)
        self.assertIn("what mean (ave/time: sums), slow (nve/limit: how often it has limited) of dem/in.liggghts remember begins anew", done.err)
        for name in ("dem/words.txt", "dem/mean.txt"):
            rows = [[line for line in support.read(stopped, file).splitlines() if line[0] != "#"] for file in (name + "-until-0.01", name)]
            self.assertEqual(rows[0] + rows[1], [line for line in support.read(straight, name).splitlines() if line[0] != "#"], name)
            self.assertIn(name + "-until-0.01", done.err)

    def test_what_is_written_may_change(self):
        """Told by name, and as it is now from there on; so may comments and layout."""
        _, stopped = self.pair("")
        self.set_entry(stopped, "system/controlDict", "endTime", self.stop)
        self.run_case(stopped)
        self.set_entry(stopped, "system/controlDict", "endTime", self.end)
        self.set_entry(stopped, "system/controlDict", "writeInterval", 0.004)
        self.edit(stopped, "system/couplingDict", "^    interval .*$", "    interval 0.002;")
        self.edit(stopped, "constant/transportProperties", "$", "// seen again\n")
        script = os.path.join(stopped, "dem/in.liggghts")
        support.write(script, support.read(script).replace("thermo          100000", "thermo 1000 # more often") + DUMPS)
        done = self.run_case(stopped, options=["-resume"])
        self.assertRegex(done.err, r"the case has changed, and is taken as it is now:\n(    .*\n)*"
                                   r"    dem/in.liggghts: `dump [^`]*` is new, .*`thermo 1000` is new, `thermo 100000` is gone\n(    .*\n)*"
                                   r"    system/controlDict, writeInterval: 0.004, and was 0.1\n(    .*\n)*"
                                   r"    system/couplingDict, records/interval: 0.002, and was 0.001\n")  # fmt: skip
        self.assertNotIn("transportProperties", done.err)
        written = {float(name) for name in os.listdir(stopped) if re.fullmatch(r"0\.\d+", name)}
        self.assertEqual(written, {0.01, 0.012, 0.016, 0.02})
        steps = numpy.diff(done.column("series/time"))
        self.assertAlmostEqual(steps[0], 0.001, delta=1e-9)
        self.assertAlmostEqual(steps[-1], 0.002, delta=1e-9)
        self.assertEqual(re.findall(r"ITEM: TIMESTEP\n(\d+)", support.read(stopped, "dem/whole.txt"))[:2], ["2100", "2200"])

    def rows(self, folder, name):
        """Those of all parts: numbers."""
        files = glob.glob(os.path.join(folder, "postProcessing", name))
        lines = [line for file in sorted(files, key=lambda path: float(path.split("/")[-2])) for line in support.read(file).splitlines()]
        return [[float(word) for word in line.split()] for line in lines if not line.lstrip().startswith("#")]

    def test_function_objects(self):
        straight, stopped = self.pair("")
        for folder in (straight, stopped):
            control = os.path.join(folder, "system/controlDict")
            support.write(control, support.read(control).split("// OpenFOAM's function objects")[0] + FUNCTIONS)
            self.set_entry(folder, "system/controlDict", "writeInterval", self.stop)
        self.run_case(straight)
        done = self.resumed(stopped)
        self.assertIn("what mean (fieldAverage) of system/controlDict", done.err)
        self.assertEqual(support.read(stopped, "log.openfoam").count("FOAM Warning"), 0)
        for name, count in (("flow/*/surfaceFieldValue.dat", 6), ("probes/*/p", 20), ("seldom/*/p", 6)):
            self.assertEqual(self.rows(stopped, name), self.rows(straight, name), name)
            self.assertEqual(len(self.rows(stopped, name)), count, name)
        # means are those since the resume; the file has six digits
        pressures = [row[1] for row in self.rows(stopped, "probes/*/p")][10:]
        self.assertAlmostEqual(self.rows(stopped, "probes/*/pMean")[-1][1], sum(pressures) / 10, delta=1e-6 * pressures[-1])

        shutil.rmtree(os.path.join(stopped, "checkpoints/0.02"))
        again = self.run_case(stopped, options=["-resume"])
        self.assertIn("what function objects wrote from t = 0.01 s on is in postProcessing-beyond-0.01/", again.err)
        for file in ("probes/0.01/p", "flow/0.01/surfaceFieldValue.dat"):
            self.assertEqual(support.read(stopped, "postProcessing", file), support.read(stopped, "postProcessing-beyond-0.01", file))
