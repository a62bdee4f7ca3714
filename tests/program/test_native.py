# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""DEM through the coupler is LIGGGHTS's own DEM: with `gas { model none; }`, interphase and the packaged `liggghts` write
the same dumps from the same script, to the last bit, after 10,000 steps on one rank and on two.

A box of 800 spheres with the contact law of cases/sscp1, thrown about at 1 m/s: every one of them collides with others
and with walls. `tools/compare` judges; that it would notice is shown with another friction.
"""

import math
import os
import shutil
import unittest

import numpy

import measured
import support
from interphase import data_file, launch

STEPS = 10000
SOLID_STEP = 1.7e-5  # [s], t_c/21
SUBSTEPS = 100       # per coupling step: the coupler cuts the run into 100 pieces, the native run is one
EDGE = 0.045         # of the box [m]
COUNT = 800

SCRIPT = """
units           si
atom_style      granular
atom_modify     map array
boundary        f f f
newton          off
communicate     single vel yes
processors      * 1 1
read_data       dem/spheres.data
include         dem/contact.liggghts
neighbor        0.0008 bin
neigh_modify    delay 0
fix walls1 all wall/gran model hooke/stiffness tangential history primitive type 2 xplane 0.0     absolute_damping on
fix walls2 all wall/gran model hooke/stiffness tangential history primitive type 2 xplane ${edge} absolute_damping on
fix walls3 all wall/gran model hooke/stiffness tangential history primitive type 2 yplane 0.0     absolute_damping on
fix walls4 all wall/gran model hooke/stiffness tangential history primitive type 2 yplane ${edge} absolute_damping on
fix walls5 all wall/gran model hooke/stiffness tangential history primitive type 2 zplane 0.0     absolute_damping on
fix walls6 all wall/gran model hooke/stiffness tangential history primitive type 2 zplane ${edge} absolute_damping on
fix gravity all gravity 9.81 vector 0.0 0.0 -1.0
fix move all nve/sphere
dump            record all custom 1000 dem/record.dump id x y z vx vy vz omegax omegay omegaz fx fy fz
dump_modify     record sort id format "%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
thermo_style    custom step atoms ke
thermo          1000
thermo_modify   norm no
"""

CONTROL = f"""
FoamFile {{ version 2.0; format ascii; class dictionary; object controlDict; }}
application interphase; startFrom startTime; startTime 0; stopAt endTime;
endTime {STEPS * SOLID_STEP!r};
deltaT {SUBSTEPS * SOLID_STEP!r};
writeControl adjustableRunTime; writeInterval 1; timePrecision 10;
"""

COUPLING = """
FoamFile {{ version 2.0; format ascii; class dictionary; object couplingDict; }}
method DEM;
weight 1;
particles {{ script "dem/in.liggghts"; solidStep {step!r}; variables {{ {variables} }} }}
gas {{ model none; }}
"""


def variables(**changed):
    numbers = support.parameters(os.path.join(support.SOURCE, "cases", "sscp1"))
    names = ("diameter", "particleDensity", "springConstant", "restitution", "tangentialRestitution", "wallRestitution",
             "wallTangentialRestitution", "friction", "wallFriction")  # fmt: skip
    return {**{name: numbers[name] for name in names}, "edge": EDGE, **changed}


def spheres():
    """A LIGGGHTS data file: a jittered lattice, velocities uniform in +- 1 m/s."""
    random = numpy.random.default_rng(7)
    diameter, density = (variables()[name] for name in ("diameter", "particleDensity"))
    sites = math.ceil(COUNT ** (1 / 3))
    pitch = EDGE / sites
    if pitch - diameter < 0.3 * diameter:
        raise AssertionError("the box is too small for the lattice")
    lattice = numpy.stack(numpy.meshgrid(*[numpy.arange(sites)] * 3), axis=-1).reshape(-1, 3)[:COUNT]
    positions = (lattice + 0.5) * pitch + random.uniform(-0.1, 0.1, (COUNT, 3)) * diameter
    velocities = random.uniform(-1, 1, (COUNT, 3))
    return data_file.text("spheres", 3 * [0], 3 * [EDGE], positions, diameter, density, velocity=velocities)


@unittest.skipUnless(shutil.which("liggghts"), "needs the liggghts binary")
class NativeDem(support.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.native_dumps = {ranks: cls.native(ranks) for ranks in (1, 2)}

    @classmethod
    def scene(cls, folder, suffix="", **changed):
        dem = os.path.join(folder, "dem")
        support.write(os.path.join(dem, "in.liggghts"), SCRIPT + suffix)
        support.write(os.path.join(dem, "spheres.data"), spheres())
        shutil.copy(os.path.join(support.SOURCE, "cases/sscp1/dem/contact.liggghts"), dem)
        return variables(**changed)

    @classmethod
    def native(cls, ranks):
        """The dump that the packaged binary writes."""
        folder = os.path.join(cls.shared, f"native{ranks}")
        given = cls.scene(folder, suffix=f"timestep {SOLID_STEP!r}\nrun {STEPS}\n")
        launch.liggghts("dem/in.liggghts", folder, {"weight": 1, **given}, ranks=ranks, timeout=support.LONGEST)
        return os.path.join(folder, "dem/record.dump")

    def coupled(self, ranks, **changed):
        """The dump that the same script writes inside interphase."""
        folder = os.path.join(self.root, f"coupled{ranks}")
        given = self.scene(folder, **changed)
        listed = " ".join(f"{name} {value!r};" for name, value in given.items())
        support.write(os.path.join(folder, "system/controlDict"), CONTROL)
        support.write(
            os.path.join(folder, "system/couplingDict"), COUPLING.format(step=SOLID_STEP, variables=listed)
        )
        support.write(os.path.join(folder, "system/decomposeParDict"), f"numberOfSubdomains {ranks}; method simple;")
        for rank in range(ranks if ranks > 1 else 0):
            os.makedirs(os.path.join(folder, f"processor{rank}"))
        self.run_case(folder, ranks)
        return os.path.join(folder, "dem/record.dump")

    def compare(self, a, b):
        return support.tool("compare", a, b, "--same-times")

    def assert_bit_equal(self, ranks):
        coupled = self.coupled(ranks)
        done = self.compare(coupled, self.native_dumps[ranks])
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("bit-equal", done.stdout)
        words, native = support.read(coupled).split(), support.read(self.native_dumps[ranks]).split()
        self.assertEqual(len(words), len(native))
        measured.within(self, f"{COUNT} colliding spheres, {STEPS} steps, {ranks} rank{'s' if ranks > 1 else ''}: numbers of 17 digits that differ from native "
                        f"LIGGGHTS's, of {COUNT * 13 * (STEPS // 1000 + 1)}", sum(a != b for a, b in zip(words, native)), 0, 0, "", "Debian's liggghts 3.8.0")  # fmt: skip

    def test_one_rank(self):
        self.assert_bit_equal(1)

    def test_two_ranks(self):
        self.assert_bit_equal(2)

    def test_another_friction_is_noticed(self):
        """A hundredth more friction between particles: the dumps part, and the comparison says so."""
        done = self.compare(self.coupled(1, friction=1.01 * variables()["friction"]), self.native_dumps[1])
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)

    def test_the_scene_collides(self):
        """What is compared is a collision model at work: all dumps are there, every sphere has got spin, which only a
        contact gives, and most of the kinetic energy has gone in collisions."""
        rows = numpy.loadtxt(
            [line for line in support.read(self.native_dumps[1]).splitlines() if line.count(" ") >= 12 and "ITEM" not in line]
        )
        self.assertEqual(len(rows), COUNT * (STEPS // 1000 + 1))
        first, last = rows[:COUNT], rows[-COUNT:]
        self.assertTrue((numpy.linalg.norm(last[:, 7:10], axis=1) > 0).all())
        self.assertLess((last[:, 4:7] ** 2).sum(), 0.5 * (first[:, 4:7] ** 2).sum())
        self.assertGreater((last[:, 4:7] ** 2).sum(), 0.0)
