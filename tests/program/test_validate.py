# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""tools/validate finds LIGGGHTS's own numbers in the coupler, and says so where they are not.

Three scripts as users have them, none longer than some thousand steps: a bed that falls after a run of its own, spheres that
are inserted, a wall that turns in a bed; and a case with parcels.
"""

import os
import shutil
import unittest

import measured
import support

HEAD = """
variable friction index 0.4
variable gravity  index 9.81
units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
processors * 1 1
region box block 0 0.02 0 0.02 0 0.03 units box
create_box 1 box
timestep 1e-5
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.8
fix m4 all property/global coefficientFriction peratomtypepair 1 ${friction}
pair_style gran model hertz tangential history
pair_coeff * *
neighbor 0.0005 bin
neigh_modify delay 0
fix left all wall/gran model hertz tangential history primitive type 1 xplane 0.0
fix right all wall/gran model hertz tangential history primitive type 1 xplane 0.02
fix front all wall/gran model hertz tangential history primitive type 1 yplane 0.0
fix back all wall/gran model hertz tangential history primitive type 1 yplane 0.02
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix gravity all gravity ${gravity} vector 0 0 -1
fix move all nve/sphere
"""
# 512 spheres of 2 mm in layers, thrown across at up to 0.3 m/s
BED = """
lattice sc 0.0025 origin 0.5 0.5 0.5
region bed block 0.001 0.019 0.001 0.019 0.001 0.02 units box
create_atoms 1 region bed
set group all diameter 0.002 density 2000
variable vx atom 0.3*sin(id*7.1)
variable vy atom 0.3*sin(id*3.3)
velocity all set v_vx v_vy 0 units box
"""
FALLING = HEAD + BED + """
run 300
dump own all custom 500 own.dump id x y z
variable steps equal 1500
run ${steps}
write_restart end.restart
"""
FED = HEAD + """
fix sphere all particletemplate/sphere 15485863 atom_type 1 density constant 2000 radius constant 0.001
fix kinds all particledistribution/discrete 32452843 1 sphere 1.0
fix face all mesh/surface/planar file face.stl type 1
fix feed all insert/stream seed 49979687 distributiontemplate kinds nparticles 400 particlerate 8000 &
    overlapcheck yes all_in no vel constant 0 0 -0.5 insertion_face face extrude_length 0.005
run 3000   # the first ones bounce on the floor after 0.03 s
"""
STIRRED = HEAD + BED + """
fix paddle all mesh/surface file paddle.stl type 1
fix at_paddle all wall/gran model hertz tangential history mesh n_meshes 1 meshes paddle
fix turning all move/mesh mesh paddle rotate origin 0.01 0.01 0.005 axis 0 0 1 period 0.05
run 1000
"""


def square(low, high, left, right):
    """STL of a square between x, y = low and high, at z = left on its one side and z = right on the other."""
    a, b, c, d = (low, low, left), (high, low, left), (high, high, right), (low, high, right)
    text = "solid square\n"
    for triangle in ((a, b, c), (a, c, d)):
        text += "facet normal 0 0 1\n outer loop\n" + "".join(f"  vertex {x} {y} {z}\n" for x, y, z in triangle)
        text += " endloop\nendfacet\n"
    return text + "endsolid square\n"


@unittest.skipUnless(shutil.which("liggghts"), "needs the liggghts binary")
class Validate(support.ProgramTest):
    def validate(self, *arguments):
        return support.tool("validate", *arguments)

    def script(self, text):
        path = os.path.join(self.root, "scene", "in.liggghts")
        support.write(path, text)
        support.write(os.path.join(self.root, "scene", "face.stl"), square(0.002, 0.018, 0.02, 0.02))
        support.write(os.path.join(self.root, "scene", "paddle.stl"), square(0.005, 0.015, 0.004, 0.006))
        return path

    def assert_bit_equal(self, *arguments, ranks=(1, 2)):
        done = self.validate(*arguments)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        unlike = sum(f"{number} rank{'s' if number > 1 else ''}: bit-equal" not in done.stdout for number in ranks)
        measured.within(self, f"tools/validate, {self.id().split('test_')[-1].replace('_', ' ')}: runs of {len(ranks)} (1 and 2 ranks) not bit-equal to native "
                        "LIGGGHTS's", unlike, 0, 0, "", "Debian's liggghts 3.8.0")  # fmt: skip
        self.assertNotIn("no particle moves", done.stdout)

    def assert_different(self, *arguments):
        done = self.validate(*arguments)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn(": different", done.stdout)

    def test_a_bed_that_falls_after_a_run_of_its_own(self):
        self.assert_bit_equal(self.script(FALLING))

    def test_spheres_that_are_inserted(self):
        self.assert_bit_equal(self.script(FED))

    def test_a_wall_that_turns(self):
        self.assert_bit_equal(self.script(STIRRED))

    def test_parcels_of_a_case(self):
        self.assert_bit_equal(os.path.join(support.SOURCE, "cases", "sscp1"), "--set", "method=CGPM", "--set", "weight=64", "--until", "0.01")

    def test_another_friction_is_found(self):
        """A hundredth more friction, in the coupler alone: beyond what round-off grows to."""
        for text in (FALLING, STIRRED):
            self.assert_different(self.script(text), "--ranks", "1", "--only-coupler", "friction=0.404")

    def test_a_last_bit_is_round_off(self):
        """Gravity's next double: not bit-equal, and not called different."""
        done = self.validate(self.script(FALLING), "--ranks", "1", "--only-coupler", "gravity=9.810000000000002")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("equal up to the growth of round-off", done.stdout)

    def test_refusals(self):
        for text, says in (
            (HEAD + BED, "no `run` in it"),
            (HEAD + BED + "label again\nvariable a loop 3\nrun 10\nnext a\njump SELF again\n", "stands in a loop"),
            (HEAD + BED + "run 100 upto\n", "`run N` alone"),
            (HEAD + BED + "include no_such_file\nrun 100\n", "no_such_file"),
            (HEAD + BED + "fix wrong all no/such/style\nrun 100\n", "no/such/style"),
            ("variable weight index 8\n" + HEAD + BED + "run 10\n", "--weight W"),
        ):
            done = self.validate(self.script(text), "--ranks", "1")
            self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
            self.assertIn(says, done.stderr)
