# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 900
"""Commands of LIGGGHTS at a time of the run (`particles { commands { ... } }`): a floor is taken away and what lay on it falls, a feed ends and begins, velocities are
set; at the gas step that they are for, on any number of ranks, with every method. A run that is stopped before or after them is the run that was not.
"""

import os

import numpy

import support
import vessel
from resumed_run import ResumedMethods

# a feed that ends, a kick, and another feed
COMMANDS = """commands
{
    end     { time 0.01; lines ("unfix pour"); }
    kick    { time 0.0205; lines ("velocity all set 0.05 NULL 0.1 units box" "print kicked"); }
    again   { time 0.03; lines ("fix more all insert/rate/region seed 86028121 distributiontemplate kinds nparticles 100000 particlerate 5000 insert_every 20 overlapcheck yes all_in yes vel constant 0 0 -0.5 region fill"); }
}
"""


def with_commands(folder, commands):
    coupling = os.path.join(folder, "system/couplingDict")
    text = support.read(coupling)
    support.write(coupling, text.replace("particles\n{", "particles\n{\n" + commands, 1))
    assert support.read(coupling) != text


class Resumed(ResumedMethods, support.ProgramTest):
    """Stopped between the second and the third."""

    stop, end = 0.022, 0.044

    def copies(self, case, method, ranks=1, **settings):
        with_commands(case, COMMANDS)
        return super().copies(case, method, ranks, **settings)

    def expect_equal(self, checkpoints, whole, done, ranks=1):
        super().expect_equal(checkpoints, whole, done, ranks)
        self.assert_books_close(whole)
        came = whole.column("ledger/inserted")
        time = whole.column("ledger/time")
        at = {t: came[numpy.searchsorted(time, t - 1e-9)] for t in (0.01, 0.03, 0.044)}
        self.assertGreater(at[0.01], 0)
        self.assertEqual(at[0.03], at[0.01], "nobody comes between the feeds")
        self.assertGreater(at[0.044], at[0.03])
        self.assertRegex(whole.out, r"t = 0\.01 s: end: unfix pour\n")
        self.assertRegex(whole.out, r"t = 0\.021 s: kick: velocity all set")  # the first step that begins at 0.0205 s or later
        self.assertEqual(done.out.count("s: end: unfix pour"), 0, "it has been done")


GATE = """\
units si
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
processors * 1 1
region box block 0 0.08 0 0.04 -2 1 units box
create_box 1 box
create_atoms 1 single 0.02 0.02 {z!r} units box
create_atoms 1 single 0.06 0.02 {z!r} units box
set group all diameter 0.01 density 2000
neighbor 0.01 bin
neigh_modify delay 0
fix kn all property/global kn peratomtypepair 1 800.0
fix en all property/global coefficientRestitution peratomtypepair 1 0.5
fix et all property/global tangentialRestitution peratomtypepair 1 0.5
fix mu all property/global coefficientFriction peratomtypepair 1 0.3
{contacts}
fix gravity all gravity 9.81 vector 0.0 0.0 -1.0
thermo_modify norm no lost ignore
"""
CONTACTS = {
    "DEM": "fix kt all property/global kt peratomtypepair 1 200\nfix gn all property/global gamman_abs peratomtypepair 1 0.2\n"
           "fix gt all property/global gammat_abs peratomtypepair 1 0.1\npair_style gran model hooke/stiffness tangential history absolute_damping on\npair_coeff * *\n"
           "fix gate all wall/gran model hooke/stiffness tangential history primitive type 1 zplane 0 absolute_damping on\nfix move all nve/sphere",
    "TDHS": "fix gate all wall/tdhs primitive type 1 zplane 0\nfix move all tdhs",
    "MPPIC": "fix gate all wall/mp_pic primitive type 1 zplane 0\nfix move all mp_pic stress off",
}  # fmt: skip


class Scene(support.ProgramTest):
    OPEN = 'commands { gate { time 0.1; lines ("unfix gate"); } }'

    def run_scene(self, method, ranks=1, commands=OPEN, script=GATE, weight_on_spring=None, more=""):
        z = 0.005 - (2000 * numpy.pi / 6 * 0.01**3 * 9.81 / 800 if method == "DEM" else 0)
        folder = os.path.join(self.root, f"gate{len(os.listdir(self.root))}")
        head = "FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n"
        support.write(os.path.join(folder, "dem/in.liggghts"), script.format(z=z, contacts=CONTACTS[method]) + more)
        support.write(os.path.join(folder, "system/controlDict"), head.format("controlDict") + "application interphase; startFrom startTime; startTime 0; stopAt endTime; "
                      "endTime 0.3; deltaT 1e-3; writeControl adjustableRunTime; writeInterval 0.1; timePrecision 10;\n")  # fmt: skip
        support.write(os.path.join(folder, "system/couplingDict"), head.format("couplingDict") + f"plugins (hard_sphere mp_pic); method {method};\n"
                      f'particles {{ script "dem/in.liggghts"; solidStep 1e-4; {commands} }} gas {{ model none; }}\n')  # fmt: skip
        support.write(os.path.join(folder, "system/decomposeParDict"), head.format("decomposeParDict") + f"numberOfSubdomains {ranks}; method simple;")
        for rank in range(ranks if ranks > 1 else 0):
            os.makedirs(os.path.join(folder, f"processor{rank}"))
        return support.execute(folder, ranks, timeout=120)


class Gate(Scene):
    def test_what_lay_on_it_falls(self):
        """From 0.1 s on, by g t^2/2: the integrators are exact for that."""
        for method in CONTACTS:
            for ranks in (1, 2):
                with self.subTest(method=method, ranks=ranks):
                    done = self.run_scene(method, ranks)
                    self.assertEqual(done.code, 0, done.text)
                    states = {round(time, 6): state for time, state in done.snapshots().items()}
                    start = states[0.1]
                    # what comes to rest by bounces of the last overlap is still within a thousandth of g t
                    self.assertLess(abs(start["velocity"]).max(), 1e-3)
                    for time in (0.2, 0.3):
                        t = time - 0.1
                        fallen = start["position"] + t * start["velocity"] - numpy.array([0, 0, 0.5 * 9.81 * t**2])
                        # springs let go of what they held, hard spheres' velocities are half a step old
                        numpy.testing.assert_allclose(states[time]["position"], fallen, atol=9.81 * t * 1e-4)


class Refusals(Scene):
    def refused(self, commands, *expected, method="TDHS", more=""):
        for ranks in (1, 2):
            done = self.run_scene(method, ranks, commands=commands, more=more)
            self.assertGreater(done.code, 0, done.text)
            for pattern in expected:
                self.assertRegex(done.text, pattern)

    def test_before_anything_moves(self):
        for entry, *expected in (
            ("commands { gate { lines (\"unfix gate\"); } }", "commands `gate` have no time", "add `time T;`"),
            ("commands { gate { time -1; lines (\"unfix gate\"); } }", "`time -1;` is not accepted"),
            ("commands { gate { time 0.1; } }", "`lines` has no list of texts", "write `lines "),
            ("commands { gate { time 0.1; lines \"unfix gate\"; } }", "is no list of texts"),
            ("commands { gate 0.1; }", "`gate` is not a block in braces"),
            ("commands { gate { time 0.1; lines (\"run 100\"); } }", "`run 100` is no command for a time of the run", "particles.commands.gate", "give one of compute, dump"),
            ("commands { gate { time 0.1; lines (\"\"); } }", "`` is no command for a time"),
            ("commands { gate { time 0.1; lines (\"unfix gatter\"); } }", "there will be no fix `gatter` at t = 0.1 s", "name a fix of the script"),
            ("commands { a { time 0.1; lines (\"unfix gate\"); } b { time 0.2; lines (\"unfix gate\"); } }", "there will be no fix `gate` at t = 0.2 s"),
        ):  # fmt: skip
            with self.subTest(entry):
                self.refused(entry, *expected, "error:")

    def test_what_a_run_does_not_bear(self):
        for lines, *expected in (
            ("unfix move", "the commands change what moves the particles"),
            ("unfix gravity", r"the commands change gravity from \(0 0 -9.81\) to \(0 0 0\)"),
            ("fix also all nve/sphere", r"fix move \(tdhs.* and fix also \(nve/sphere.* both move the same particles"),
            ("fix other all wall/nowhere primitive type 1 zplane 0", "Invalid fix style"),
        ):
            with self.subTest(lines):
                self.refused(f'commands {{ wrong {{ time 0.1; lines ("{lines}"); }} }}', *expected)

    def test_larger_spheres(self):
        template = ("fix one all particletemplate/sphere 15485863 atom_type 1 density constant 2000 radius constant 0.02\n"
                    "fix kinds all particledistribution/discrete 32452843 1 one 1.0\nregion fill block 0.01 0.07 0.005 0.035 0.5 0.9 units box\n")  # fmt: skip
        self.refused('commands { feed { time 0.1; lines ("fix pour all insert/pack seed 49979687 distributiontemplate kinds insert_every once overlapcheck yes '
                     'all_in no vel constant 0 0 0 region fill particles_in_region 1"); } }',
                     r"the commands insert spheres with a radius of 0\.02 m; 0\.005 m is the largest that was known", more=template)  # fmt: skip
