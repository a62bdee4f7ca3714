# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes for the plug-ins that tools/new-plugin writes: LIGGGHTS scripts, run by interphase-liggghts, read back from the dump."""

import os
import subprocess
import tempfile
import unittest

import numpy

SOURCE = os.environ.get("INTERPHASE_SOURCE") or os.path.realpath(os.path.join(os.path.dirname(__file__), "..", "..", ".."))
BUILD = os.environ.get("INTERPHASE_BUILD") or os.path.join(SOURCE, "build", "release")
RUNNER = os.path.join(BUILD, "interphase-liggghts")
PLUGINS = os.path.join(BUILD, "tests", "plugins")
PLAIN, KEPT = "plain_contacts", "kept_contacts"  # without and with memory
COLUMNS = "id type x y z vx vy vz omegax omegay omegaz radius mass"

BOX = """\
units si
atom_style granular
boundary {boundary}
newton off
communicate single vel yes
processors * 1 1
"""
DOMAIN = "region box block 0 0.1 0 0.1 0 0.1 units box\ncreate_box 2 box\n"
FIXES = """\
neighbor {skin} bin
neigh_modify delay 0
timestep {step}
fix kn all property/global kn peratomtypepair 2 1000 500 500 2000
fix en all property/global coefficientRestitution peratomtypepair 2 0.7 0.8 0.8 0.9
fix mu all property/global coefficientFriction peratomtypepair 2 0.3 0.4 0.4 0.5
fix push all {plugin}/spheres
fix move all nve/sphere
"""
STATES = f'dump states all custom {{every}} states {COLUMNS}\ndump_modify states sort id format "%d %d{11 * " %.17g"}"\n'
GRAVITY = "fix gravity all gravity 9.81 vector 0.0 0.0 -1.0\n"
FLOOR = "fix floor all wall/{plugin} primitive type 1 zplane 0.0\n"


def sphere(number, radius, x, v=(0, 0, 0), density=2000, kind=1):
    """Lines that make a sphere of this number (the next one); lengths in m, v in m/s."""
    return (f"create_atoms {kind} single {x[0]!r} {x[1]!r} {x[2]!r} units box\nset atom {number} diameter {2 * radius!r} density {density!r}\n"
            f"group one id {number}\nvelocity one set {v[0]!r} {v[1]!r} {v[2]!r} units box\ngroup one delete\n")  # fmt: skip


def scene(plugin, particles, after, every=1000, boundary="f f f", skin=0.002, step=1e-5, domain=DOMAIN, fixes=FIXES):
    """A script: `particles`, then the plug-in's fix, the dump, and what comes `after` them ("{plugin}" is its name)."""
    text = BOX.format(boundary=boundary) + domain + particles + fixes.format(plugin=plugin, skin=skin, step=step)
    return text + STATES.format(every=every) + after.replace("{plugin}", plugin)


class ContactTest(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.root = room.name

    def execute(self, plugin, script, ranks=1):
        with open(os.path.join(self.root, "in.script"), "w", encoding="utf-8") as file:
            file.write(script)
        command = [RUNNER, "-plugin", os.path.join(PLUGINS, f"lib{plugin}.so"), "-in", "in.script", "-log", "none"]
        if ranks > 1:
            command = ["mpirun", "-np", str(ranks), "--oversubscribe", *command]
        return subprocess.run(command, cwd=self.root, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", timeout=200)

    def states(self, plugin, script, ranks=1):
        """[{column: values}] of the dumped states, spheres by their ids."""
        done = self.execute(plugin, script, ranks)
        self.assertEqual(done.returncode, 0, done.stdout[-3000:] + done.stderr[-3000:])
        with open(os.path.join(self.root, "states"), encoding="utf-8") as file:
            parts = [part.split("ITEM:")[0].strip().split("\n")[1:] for part in file.read().split("ITEM: ATOMS")[1:]]
        rows = [numpy.array([line.split() for line in lines], float).reshape(-1, len(COLUMNS.split())) for lines in parts]
        return [dict(zip(COLUMNS.split(), each.T)) for each in rows]

    def refused(self, script, *expected, plugin=PLAIN, ranks=1):
        done = self.execute(plugin, script, ranks)
        self.assertNotEqual(done.returncode, 0, done.stdout[-2000:])
        for words in expected:
            self.assertIn(words, done.stdout + done.stderr)


def vectors(state, name="v"):
    """[n, 3]"""
    names = {"x": "x y z", "v": "vx vy vz", "omega": "omegax omegay omegaz"}[name].split()
    return numpy.column_stack([state[each] for each in names])
