# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 900
"""Scenes that LIGGGHTS takes and that would give wrong numbers: refused by name, or told once and counted.

The scene is cases/sscp1 with 1,000 parcels of 8 (CGPM), 6.512 mm wide; each test changes one thing of it.
"""

import os
import re
import shutil

import support

RANKS = (1, 2)
SCRIPT, SOFT, HARD = "dem/in.liggghts", "dem/soft_spheres.liggghts", "dem/hard_spheres.liggghts"
COUPLING = "system/couplingDict"


class Doubtful(support.ProgramTest):
    METHODS = ("CGPM", "CGHS", "MPPIC")

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.good = {
            (method, ranks): cls.prepare("sscp1", os.path.join(cls.shared, f"{method}{ranks}"), ranks, method=method,
                                         particleCount=8000, initialPacking=0.3, until=0.003)
            for method in cls.METHODS for ranks in RANKS
        }  # fmt: skip

    def ended(self, method, ranks, *edits):
        """What became of the scene with `edits` (file, pattern, replacement; pattern None: added at the end)."""
        self.runs = getattr(self, "runs", 0) + 1
        folder = self.copied(self.good[method, ranks], f"{method}{ranks}-{self.runs}")
        for file, pattern, replacement in edits:
            if pattern is None:
                support.write(os.path.join(folder, file), (support.read(folder, file) if os.path.exists(os.path.join(folder, file)) else "") + replacement)
            else:
                self.edit(folder, file, pattern, replacement)
        done = support.execute(folder, ranks, timeout=200)
        return done

    def refused(self, edits, *expected, methods=("CGPM",), ranks=RANKS):
        for method in methods:
            for count in ranks:
                with self.subTest(method=method, ranks=count):
                    done = self.ended(method, count, *edits)
                    self.assertEqual(done.code, 1, done.text)
                    self.assertEqual(done.text.count("interphase: error"), 1, done.text)
                    self.assertEqual(done.text.count("remedy:"), 1, done.text)
                    self.assertNotIn("Reached t =", done.text)
                    for words in expected:
                        self.assertRegex(done.err, words)
                    shutil.rmtree(done.folder)

    def told(self, edits, *expected, methods=("CGPM",), ranks=RANKS, counted=None):
        """The run reaches its end, and each of `expected` is told once."""
        for method in methods:
            for count in ranks:
                with self.subTest(method=method, ranks=count):
                    done = self.ended(method, count, *edits)
                    self.assertEqual(done.code, 0, done.text)
                    for words in expected:
                        self.assertEqual(len(re.findall(words, done.err)), 1, f"{words}:\n{done.text}")
                    if counted:
                        self.assertRegex(done.out, counted)
                    shutil.rmtree(done.folder)


class Integrators(Doubtful):
    SECOND = ((SCRIPT, "^fix gravity", "fix again all nve/sphere\nfix gravity"),)

    def test_two_are_refused(self):
        """Each parcel would go twice its way in a step."""
        self.refused(self.SECOND, r"fix move \((nve/sphere|tdhs|mp_pic), of group all\) and fix again \(nve/sphere, of group all\)",
                     "twice its way", methods=self.METHODS)  # fmt: skip

    def test_of_groups_with_common_particles(self):
        """No group is the other; 100 parcels are in both."""
        groups = "group low id 1:600\ngroup high id 501:1000\n"
        self.refused([(SOFT, "^fix move.*$", groups + "fix move low nve/sphere\nfix lift high nve/sphere")],
                     r"fix move \(nve/sphere, of group low\) and fix lift", r"particle 5\d\d is one of them|particle \d+ is one")

    def test_of_groups_without_common_particles_are_fine(self):
        groups = "group low id 1:500\ngroup high id 501:1000\n"
        self.told([(SOFT, "^fix move.*$", groups + "fix move low nve/sphere\nfix lift high nve/sphere")], ranks=(1,))

    def test_particles_without_one_are_told(self):
        self.told([(SOFT, "^fix move.*$", "group low id 1:600\nfix move low nve/sphere")],
                  "no fix of the script moves 400 of the 1000 particles", counted=r"that no fix moves +400 +40\.000 % +look at it\n")


class Shapes(Doubtful):
    METHODS = ("CGPM",)

    def test_clumps_are_refused(self):
        """Their overlaps would count twice as solids: 18.5 % of a clump's volume in the scene where it was seen."""
        template = (
            "fix clump all particletemplate/multisphere 15485863 atom_type 1 density constant 1131 nspheres 2 ntry 100000 "
            "spheres 0 0 0 0.002 0.002 0 0 0.002 type 1\n"
        )
        self.refused([(SCRIPT, "^fix gravity", template + "fix gravity")],
                     r"fix clump \(particletemplate/multisphere\) makes clumps of overlapping spheres", "solid volume")

    def test_rigid_bodies_are_refused(self):
        self.refused([(SOFT, "^fix move.*$", "group two id 1 2\ngroup rest subtract all two\n"
                       "fix body two rigid single\nfix move rest nve/sphere")],
                     r"fix body \(rigid\) ties spheres together")


class Walls(Doubtful):
    CYLINDER = ((SOFT, "^fix left ", "fix pipe all wall/gran model hooke/stiffness tangential history primitive type 2 zcylinder "
                                     "0.05 0.1143 0.0381 absolute_damping on\nfix left "),)
    HARD_CYLINDER = ((HARD, "^fix left ", "fix pipe all wall/tdhs primitive type 2 zcylinder 0.05 0.1143 0.0381\nfix left "),)
    WORDS = r"warning: \d\d+ particles stand in the wall of fix pipe \(wall/(gran|tdhs)\) by more than 5 % of a radius"

    def test_that_stand_in_particles_are_told(self):
        self.told(self.CYLINDER, self.WORDS, counted=r"overlaps at the start +\d[\d,]+ +look at it\n")
        self.told(self.HARD_CYLINDER, self.WORDS, methods=("CGHS",))

    def test_of_a_mesh(self):
        """A plate of two triangles through the bed, 1 cm above the floor."""
        self.plate("fix plate", "CGPM", SOFT, "wall/gran model hooke/stiffness tangential history")
        self.plate("fix plate", "CGHS", HARD, "wall/tdhs")

    def plate(self, name, method, file, style):
        facet = " facet normal 0 0 1\n  outer loop\n{}  endloop\n endfacet\n"
        corner = ["   vertex 0.01 0.01 0.013\n", "   vertex 0.2 0.01 0.013\n", "   vertex 0.2 0.06 0.013\n", "   vertex 0.01 0.06 0.013\n"]
        stl = "solid plate\n" + facet.format("".join(corner[:3])) + facet.format("".join(corner[i] for i in (0, 2, 3))) + "endsolid plate\n"
        options = " absolute_damping on" if method == "CGPM" else ""
        self.told([(file, "^fix left ", "fix surface all mesh/surface file dem/plate.stl type 2\n"
                    f"{name} all {style} mesh n_meshes 1 meshes surface{options}\nfix left "), ("dem/plate.stl", None, stl)],
                  r"warning: \d\d+ particles stand in the wall of fix plate", methods=(method,))

    def test_particles_in_each_other(self):
        """One is put 0.3 radii into another; both are named, whichever ranks have them."""
        edits = [("dem/bed.data", r"^1 1 (\S+) (\S+) .*$", "1 1 0.006512 1131.0 0.1143 0.0381 0.5"),
                 ("dem/bed.data", r"^1000 1 (\S+) (\S+) .*$", "1000 1 0.006512 1131.0 0.1143 0.0381 0.5055352")]
        self.told(edits, r"warning: 1 pairs of particles overlap by more than 5 % of a radius before the first step, the deepest "
                         r"by 30 %\n  where:  dem/in.liggghts: particle 1 at \(0.1143 0.0381 0.5\), with particle 1000",
                  methods=("CGPM", "CGHS"))

    def test_none_is_told_of_a_good_bed(self):
        for method in self.METHODS:
            done = self.ended(method, 2)
            self.assertEqual(done.code, 0, done.text)
            self.assertEqual(done.err, "")
            self.assertRegex(done.out, r"warnings of LIGGGHTS +0\n +warnings of OpenFOAM +0\n")


class Warnings(Doubtful):
    METHODS = ("CGPM",)

    def test_of_liggghts(self):
        """Its own check of the step, every 2 steps: once on the console, each time in the count."""
        hertz = """
fix young all property/global youngsModulus peratomtype 5e6 5e6
fix nu all property/global poissonsRatio peratomtype 0.3 0.3
fix e all property/global coefficientRestitution peratomtypepair 2 0.9 0.9 0.9 0.9
pair_style gran model hertz tangential history
pair_coeff * *
neighbor 0.0016 bin
neigh_modify delay 0
fix floor all wall/gran model hertz tangential history primitive type 2 zplane 0.0
fix check all check/timestep/gran 2 0.01 0.01
fix move all nve/sphere
"""
        keep = r"fix mu all property/global coefficientFriction peratomtypepair 2 0.1 0.1 0.1 0.1"
        edits = [(SCRIPT, r"^include\s+dem/\$\{method\}.*$", keep + hertz)]
        step = (COUPLING, r"script\s+\S+;", 'script "dem/in.liggghts"; solidStep 5e-5;')
        self.told([*edits, step], r"warning: LIGGGHTS warns: time-?step is [\d.]+ % of rayleigh time\n  where:  dem/log.liggghts",
                  counted=r"warnings of LIGGGHTS +[1-9][\d,]+ +look at it\n")  # fmt: skip
        # pi r sqrt(rho/G)/(0.1631 nu + 0.8766), r = 3.256 mm, rho = 1131 kg/m3, G = 5 MPa/2.6
        long = (COUPLING, r"script\s+\S+;", 'script "dem/in.liggghts"; solidStep 1.25e-4;')
        self.refused([*edits, long], r"solid step of 0.000125 s is 46\.\d+ % of Rayleigh's time of 0.00026\d+ s", "at most 40 %")
        self.refused(edits, "no collision time.*", r"say 5\.\d+e-05, 20 % of Rayleigh's time")
        # 12 m/s head-on
        fast = (SCRIPT, "^fix gravity", "velocity all set 0 0 6\nfix gravity")
        self.told([*edits, step, fast], r"touch for [\d.e-]+ s by Hertz's law, \d\.\d+ solid steps", counted=r"too fast contacts +3 +100\.000 % +look at it\n")

    def test_of_openfoam(self):
        """A function object that knows no such field warns in every step."""
        functions = """
functions { seen { type probes; libs (sampling); fields (U); probeLocations ((9 9 9)); writeControl timeStep; writeInterval 1; } }
"""
        self.told([("system/controlDict", None, functions)], r"warning: OpenFOAM warns: Did not find location \(9 9 9\)",
                  counted=r"warnings of OpenFOAM +[1-9][\d,]* +look at it\n")

    def test_stiffnesses_of_hertz_are_no_springs(self):
        """kn of hertz/stiffness is in N/m2: no collision time follows from it as from a spring's."""
        edits = [("dem/contact.liggghts", r"^pair_style gran model hooke.*$", "pair_style gran model hertz/stiffness tangential history"),
                 ("dem/contact.liggghts", "property/global gamman_abs", "property/global gamman"),
                 ("dem/contact.liggghts", "property/global gammat_abs", "property/global gammat")]
        walls = [(SOFT, f"^fix {wall} .*$", "") for wall in ("left", "right", "front", "back", "bottom", "top")]
        self.refused(edits + walls, "no collision time", "solidStep", ranks=(1,))


class MovingMesh(Doubtful):
    METHODS = ("CGPM",)

    def test_that_the_gas_does_not_feel_is_told(self):
        stl = """solid plate
 facet normal 0 0 1
  outer loop
   vertex 0.01 0.01 0.9
   vertex 0.2 0.01 0.9
   vertex 0.2 0.06 0.9
  endloop
 endfacet
endsolid plate
"""
        lines = ("fix surface all mesh/surface file dem/plate.stl type 2\n"
                 "fix plate all wall/gran model hooke/stiffness tangential history mesh n_meshes 1 meshes surface absolute_damping on\n"
                 "fix turn all move/mesh mesh surface linear 0 0 -0.1\nfix left ")
        self.told([(SOFT, "^fix left ", lines), ("dem/plate.stl", None, stl)], "the gas does not feel it")
