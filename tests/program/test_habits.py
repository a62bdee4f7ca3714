# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""What users of the two engines are used to keeps working under the coupler: OpenFOAM's function objects, LIGGGHTS's
dumps, thermo output and computes; and a bare launcher is enough: no OpenFOAM environment, an exit code to rely on."""

import os
import re
import signal
import time

import numpy

import support

FUNCTIONS = """
functions
{
    points { type probes; libs (sampling); fields (U p); probeLocations ((0.1143 0.0381 0.6)); writeControl timeStep; }
    mean   { type fieldAverage; libs (fieldFunctionObjects); writeControl writeTime;
             fields (U { mean on; prime2Mean off; base time; }); }
}
"""

SCRIPT = """
compute energy all ke
fix series all ave/time 40 1 40 c_energy file dem/energy.txt
dump states all custom 40 dem/states.dump id x y z
dump_modify states format "%d %.17g %.17g %.17g"
thermo 40
"""


class Habits(support.ProgramTest):
    def scene(self, ranks):
        folder = self.prepared("sscp1", ranks=ranks, until=0.02, weight=64)
        path = os.path.join(folder, "system/controlDict")
        text = re.sub(r"\nfunctions\s*\{.*?\n\}\n", "\n", support.read(path), flags=re.S)
        support.write(path, text + FUNCTIONS)
        script = os.path.join(folder, "dem/in.liggghts")
        support.write(script, support.read(script) + SCRIPT)
        return folder

    def check(self, ranks):
        done = self.run_case(self.scene(ranks), ranks)

        probe = support.read(done.path("postProcessing/points/0/U"))
        rows = [line for line in probe.splitlines() if line and not line.startswith("#")]
        self.assertEqual(len(rows), 20)  # one a gas step
        # above the bed the gas rises with nearly the superficial velocity; the bed at the start lets it through evenly
        rise = float(re.findall(r"[-\d.e+]+", rows[-1])[-1])
        self.assertGreater(rise, 1.5)
        self.assertLess(rise, 3.0)
        place = "processor0/0.02" if ranks > 1 else "0.02"
        self.assertTrue(os.path.isfile(done.path(place, "UMean")))

        steps = round(0.02 / done.meta["solid_step"])
        energy = numpy.loadtxt(done.path("dem/energy.txt"))
        self.assertEqual(energy[-1, 0], steps // 40 * 40)
        last = done.last()
        dump = support.read(done.path("dem/states.dump")).split("ITEM: TIMESTEP\n")[-1]
        self.assertEqual(int(dump.split("\n")[0]), steps // 40 * 40)
        if steps % 40 == 0:
            body = numpy.array([line.split() for line in dump.split("\n")[8:] if line], float)
            body = body[numpy.argsort(body[:, 0])]
            numpy.testing.assert_array_equal(body[:, 1:], last["position"])  # 17 digits: the same doubles
        self.assertRegex(support.read(done.path("dem/log.liggghts")), r"\n\s*40\s+1484")  # thermo's line of step 40

    def test_one_rank(self):
        self.check(1)

    def test_two_ranks(self):
        self.check(2)

    def test_no_openfoam_environment_is_needed(self):
        folder = self.prepared("settling", until=0.01)
        self.run_case(folder, WM_PROJECT_DIR=None)

    def test_a_run_that_is_stopped_does_not_end_with_zero(self):
        folder = self.prepared("sscp1", until=1)
        program = support.start(folder)
        deadline = time.monotonic() + 60
        while not os.path.isfile(os.path.join(folder, "results.h5")) and time.monotonic() < deadline:
            time.sleep(0.1)
        program.send_signal(signal.SIGTERM)
        program.communicate(timeout=60)
        self.assertNotEqual(program.returncode, 0)
