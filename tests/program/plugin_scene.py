# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene for the plug-ins of tests/engines/liggghts/plugins: two spheres at rest in a box; the fix test/kick adds a known velocity to them every step. It runs
through interphase (entry `plugins` of system/couplingDict) or through interphase-liggghts (option -plugin)."""

import os
import re
import subprocess

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
