# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of hard spheres: written as a LIGGGHTS script, run by interphase-liggghts with the plug-in, read back from the dump."""

import os
import subprocess
import tempfile
import unittest
from dataclasses import dataclass, field

import numpy

from interphase import data_file, launch, liggghts_dump

SOURCE = os.environ.get("INTERPHASE_SOURCE") or os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
BUILD = os.environ.get("INTERPHASE_BUILD") or os.path.join(SOURCE, "build", "release")

RUNNER = os.path.join(BUILD, "interphase-liggghts")
LONGEST = 300  # most runs take seconds; ranks that wait for one another for ever are ended here [s]
COLUMNS = "id x y z vx vy vz omegax omegay omegaz radius"
FORMAT = "%d" + 10 * " %.17g"  # a number comes back as it was, to the last bit

HEAD = """units si
atom_style granular
atom_modify map array sort 0 0
boundary {boundary}
newton off
communicate single vel yes
processors {processors}
"""


@dataclass
class Spheres:
    """n spheres: diameter [m, n], density [kg/m3, n], position, velocity and spin [n, 3], type of material [n], from 1."""

    diameter: numpy.ndarray
    position: numpy.ndarray
    velocity: numpy.ndarray = None
    spin: numpy.ndarray = None
    density: float = 2500.0
    type: numpy.ndarray = None

    def __post_init__(self):
        self.position = numpy.atleast_2d(numpy.asarray(self.position, float))
        n = len(self.position)
        self.diameter = numpy.broadcast_to(numpy.asarray(self.diameter, float), n)
        self.density = numpy.broadcast_to(numpy.asarray(self.density, float), n)
        for name in ("velocity", "spin"):
            given = getattr(self, name)
            setattr(self, name, numpy.zeros((n, 3)) if given is None else numpy.broadcast_to(numpy.asarray(given, float), (n, 3)))
        self.type = numpy.broadcast_to(numpy.asarray(1 if self.type is None else self.type, int), n)

    @property
    def mass(self):
        return self.density * numpy.pi / 6 * self.diameter**3

    @property
    def inertia(self):
        return self.mass * self.diameter**2 / 10


@dataclass
class Scene:
    """`low`, `high`: corners of the box [m]. e, et, mu: numbers for all materials, or [types, types]; the last type is the
    walls'. `walls`: what follows `fix ID all wall/tdhs`. `before`: further lines ahead of fix tdhs; `words`: its options. `law`: of the
    plug-in `plugin`, the styles being tdhs/LAW and wall/tdhs/LAW.
    """

    spheres: Spheres
    low: tuple
    high: tuple
    e: object = 1.0
    et: object = 0.0
    mu: object = 0.0
    types: int = 2
    walls: tuple = ()
    before: str = ""
    words: str = ""
    boundary: str = "f f f"
    processors: str = "* 1 1"
    skin: float = 0.002
    fixes: str = "fix hs all {style} {words}\n"
    thermo: str = "step atoms ke v_hs_pairs v_hs_binary_collisions v_hs_cluster_contacts"
    properties: dict = field(default_factory=dict)
    law: str = ""
    plugin: str = os.path.join("plugins", "libhard_sphere.so")  # from the build folder on

    @property
    def style(self):
        return "tdhs" + f"/{self.law}" * bool(self.law)

    def matrix(self, value):
        values = numpy.broadcast_to(numpy.asarray(value, float), (self.types, self.types))
        return f"peratomtypepair {self.types} " + " ".join(f"{x:.17g}" for x in values.ravel())

    def laws(self):
        """The lines of fix property/global, by name; a test of bad input takes one out or changes it."""
        return {
            "coefficientRestitution": self.matrix(self.e),
            "tangentialRestitution": self.matrix(self.et),
            "coefficientFriction": self.matrix(self.mu),
        } | self.properties

    def script(self):
        lines = HEAD.format(boundary=self.boundary, processors=self.processors)
        lines += f"read_data spheres.data\nneighbor {self.skin} bin\nneigh_modify delay 0\n"
        for name, values in self.laws().items():
            if values is not None:
                lines += f"fix {name} all property/global {name} {values}\n"
        lines += self.before
        for k, wall in enumerate(self.walls):
            lines += f"fix wall{k} all wall/{self.style} {wall}\n"
        return lines + self.fixes.format(words=self.words, style=self.style)

    def data(self):
        s = self.spheres
        return data_file.text("spheres", self.low, self.high, s.position, s.diameter, s.density, s.type, s.velocity, s.spin, self.types)


@dataclass
class History:
    """What a dump holds: time [s, t]; position, velocity, spin [t, n, 3], rows by id."""

    time: numpy.ndarray
    position: numpy.ndarray
    velocity: numpy.ndarray
    spin: numpy.ndarray


@dataclass
class Done:
    folder: str
    code: int
    text: str
    step: float

    def states(self):
        """(time, quantities) of one dumped step after the other."""
        for frame in liggghts_dump.Dump("dump", [os.path.join(self.folder, "dump")]).frames():
            yield frame.step * self.step, frame.load().quantities

    def history(self):
        states = list(self.states())
        arrays = [numpy.array([q[name] for _, q in states]) for name in ("position", "velocity", "spin")]
        return History(numpy.array([time for time, _ in states]), *arrays)

    def thermo(self):
        """The columns of the thermo output [rows, columns], without lines of a single number."""
        rows = []
        for line in self.text.splitlines():
            try:
                row = [float(word) for word in line.split()]
            except ValueError:
                continue
            if len(row) > 2 and (not rows or len(row) == len(rows[0])):
                rows.append(row)
        return numpy.array(rows)


class HardSphereTest(unittest.TestCase):
    """Every run has a folder of its own, gone when the test ends."""

    def folder(self):
        folder = tempfile.TemporaryDirectory(prefix="interphase-")
        self.addCleanup(folder.cleanup)
        return folder.name

    def execute(self, scene, step, steps, every=1, ranks=1, files=None, thermo_every=None):
        """`files`: texts to put beside the script, by name. Every `every` steps goes to the dump, the start too;
        `thermo_every` steps to the thermo output, by default as many."""
        folder = self.folder()
        script = scene.script() + (
            f"timestep {step!r}\nthermo_style custom {scene.thermo}\nthermo_modify norm no lost ignore format float %.17g\n"
            f"thermo {thermo_every or every}\n"
            f'dump state all custom {every} dump {COLUMNS}\ndump_modify state sort id format "{FORMAT}"\nrun {steps}\n'
        )
        for name, text in {"in.liggghts": script, "spheres.data": scene.data()}.items() | (files or {}).items():
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        command = [RUNNER, "-plugin", os.path.join(BUILD, scene.plugin), "-in", "in.liggghts"]
        if ranks > 1:
            command = ["mpirun", "-np", str(ranks), "--oversubscribe", *command]
        done = subprocess.run(
            command, cwd=folder, env={**os.environ, **launch.additions(os.environ)}, stdin=subprocess.DEVNULL,
            capture_output=True, text=True, errors="replace", timeout=LONGEST,
        )  # fmt: skip
        return Done(folder, done.returncode, done.stdout + done.stderr, step)

    def run_scene(self, scene, step, steps, every=1, ranks=1, files=None, thermo_every=None):
        """execute(), and demands that the run reaches its end with all spheres."""
        done = self.execute(scene, step, steps, every, ranks, files, thermo_every)
        self.assertEqual(done.code, 0, done.text[-1500:])
        self.assertIn(f" with {len(scene.spheres.position)} atoms", done.text[-1500:])
        return done
