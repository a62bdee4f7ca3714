# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 1200
"""Mistakes of a user end the program with exit code 1 and one message that names what is wrong, its value, where it stands
and what to do, printed once however many ranks there are, and before the first step.

The scene is cases/sscp1 with 1,000 parcels; each test spoils one thing of it.
"""

import os
import re
import shutil

import support

RANKS = (1, 2)
COUPLING = "system/couplingDict"
SCRIPT = "dem/in.liggghts"


def line_of(folder, file, pattern):
    for number, line in enumerate(support.read(folder, file).splitlines(), 1):
        if re.search(pattern, line):
            return number
    raise AssertionError(f"no line with {pattern} in {file}")


class SpoiledCase(support.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.good = {
            ranks: cls.prepare("sscp1", os.path.join(cls.shared, f"good{ranks}"), ranks, particleCount=8000,
                               initialPacking=0.3, until=0.02)
            for ranks in RANKS
        }  # fmt: skip

    def pieces(self, folder):
        """The case folder itself, or its parts where it is decomposed."""
        parts = [os.path.join(folder, name) for name in sorted(os.listdir(folder)) if re.fullmatch(r"processor\d+", name)]
        return parts or [folder]

    def stopped(self, done, *expected):
        """The program's message, which holds all of `expected` (regular expressions)."""
        self.assertNotEqual(done.code, 0, done.text)
        self.assertGreater(done.code, 0, f"killed by a signal:\n{done.text}")
        self.assertEqual(done.text.count("interphase: "), 1, f"one message, of one rank:\n{done.text}")
        self.assertEqual(done.text.count("remedy:"), 1, done.text)
        message = done.text[done.text.index("interphase: "):]
        for pattern in expected:
            self.assertRegex(message, pattern)
        return message

    def refused(self, spoil, *expected, ranks=RANKS, good=None):
        """`spoil(folder)` changes the case. Nothing may have moved."""
        for count in ranks:
            with self.subTest(ranks=count):
                folder = self.copied((good or self.good)[count], f"spoiled{count}")
                patterns = spoil(folder) or ()
                done = support.execute(folder, count, timeout=200)
                message = self.stopped(done, *expected, *patterns)
                self.assertNotIn("Reached t =", done.text)
                self.assert_nothing_moved(done)
                shutil.rmtree(folder)
        return message

    def assert_nothing_moved(self, done):
        if os.path.exists(done.path("results.h5")):
            self.assertEqual(len(done.run.ledger), 0)
        if os.path.exists(done.path("particles.h5")):
            self.assertLessEqual(len(done.snapshots()), 1)

    def with_edit(self, file, pattern, replacement):
        return lambda folder: self.edit(folder, file, pattern, replacement)


class Dictionary(SpoiledCase):
    def misspelt(self, file, pattern, replacement, *expected):
        """The message names the line, too."""

        def spoil(folder):
            self.edit(folder, file, pattern, replacement)
            return (rf"{re.escape(file)}\S*, line {line_of(folder, file, re.escape(replacement))}\b",)

        self.refused(spoil, *expected)

    def test_unknown_key(self):
        self.misspelt(COUPLING, r"maximumPacking\s+0.74;", "maximalPacking 0.7;", r"unknown entry `maximalPacking`",
                      r"did you mean `maximumPacking`\?")  # fmt: skip

    def test_unknown_block(self):
        self.refused(self.with_edit(COUPLING, r"^mapping$", "maping"), r"unknown entry `maping`", r"did you mean `mapping`\?",
                     r"system/couplingDict, block at line \d+")  # fmt: skip

    def test_unknown_choice(self):
        self.misspelt(COUPLING, r"law\s+BVK;", "law WenYuu;", r"`law WenYuu;`", r"did you mean `WenYu`\?", "Gidaspow")

    def test_missing_key(self):
        self.refused(self.with_edit(COUPLING, r'^\s*script\s.*$', ""), "`script` is missing", r"system/couplingDict\.particles")

    def test_missing_block(self):
        self.refused(self.with_edit(COUPLING, r"^particles\s*\{(.|\n)*?\n\}", ""), r"`particles \{ \.\.\. \}` is missing",
                     "system/couplingDict")  # fmt: skip

    def test_weight_below_one(self):
        self.misspelt(COUPLING, r"weight\s+\$weight;", "weight 0.5;", r"`weight 0\.5;`", "at least 1")

    def test_weight_of_dem(self):
        self.refused(self.with_edit(COUPLING, r"method\s+\$method;", "method DEM;"), r"`weight 8;` with method DEM", "line",
                     "CGPM")  # fmt: skip

    def test_word_for_a_number(self):
        self.misspelt(COUPLING, r"maximumPacking\s+0.74;", "maximumPacking much;", r"`maximumPacking much;`", "number")

    def test_too_few_steps_per_collision(self):
        self.misspelt(COUPLING, r"script\s+\S+;", 'script "dem/in.liggghts"; stepsPerCollision 3;', r"`stepsPerCollision 3;`", "at least 10")

    def test_syntax(self):
        """A brace that is missing: OpenFOAM's own words, and the file."""
        self.refused(self.with_edit(COUPLING, r"^drag\n\{", "drag\n"), "couplingDict")

    def test_pressure_tap_outside(self):
        self.refused(self.with_edit(COUPLING, r"0\.3461\)\)", "3.461))"), r"\(0\.1143 0\.0381 3\.461\)", "in no cell",
                     r"between \(0 0 0\) and \(0\.2286 0\.0762 1\.2192\) m", "pressureTaps", "or none")  # fmt: skip

    def test_mean_fields_without_a_gas(self):
        def spoil(folder):
            self.edit(folder, COUPLING, r"^statistics\n\{", "statistics\n{\n    fields { }")
            self.edit(folder, COUPLING, r"model +pimple;", "model none;")
            self.edit(folder, COUPLING, r"coupling +twoWay;", "coupling oneWay;")

        self.refused(spoil, "`fields` in `statistics` with `model none;`", "there are no gas cells", "remove `fields`")

    def test_mean_fields_without_samples(self):
        self.refused(self.with_edit(COUPLING, r"interval    0\.05;       // 20 Hz.*$", "fields { }"), "`fields` without an `interval`",
                     r"where:  system/couplingDict\.statistics\n", r"add `interval 0\.05;`")  # fmt: skip


class UnitSlips(SpoiledCase):
    def test_negative_gas_density(self):
        def spoil(folder):
            self.edit(folder, "constant/transportProperties", r"^(rho\s).*$", "rho -1.204;")
            return (rf"transportProperties\S*, line {line_of(folder, 'constant/transportProperties', '^rho')}",)

        self.refused(spoil, r"-1\.204", "not positive", "kg/m3")

    def test_restitution_above_one(self):
        """The case makes dampings of it; a negative one is refused where LIGGGHTS would take it."""
        self.refused(self.with_edit("parameters", r"^restitution\s.*$", "restitution 1.1;"), r"gamman_abs is -\d", "above 1",
                     SCRIPT)  # fmt: skip

    def test_negative_particle_density_in_the_bed(self):
        """LIGGGHTS refuses the file."""
        self.refused(self.with_edit("dem/bed.data", r" 1131\.0 ", " -1131.0 "), "LIGGGHTS stopped", "Invalid density")

    def test_negative_particle_density_in_the_contact_law(self):
        """The script takes the square root of a mass."""
        self.refused(self.with_edit("parameters", r"^particleDensity\s.*$", "particleDensity -1131;"), "LIGGGHTS stopped",
                     "(?i)sqrt of negative")  # fmt: skip

    def test_tools_refuse_them_too(self):
        """... before anything is started: `prepare` and tools/run."""
        for key, value, words in (("particleDensity", -1131, "density"), ("weight", 0.5, "weight"), ("diameter", -1, "diameter")):
            with self.subTest(key=key), self.assertRaisesRegex(AssertionError, f"(?s)error.*{words}.*{value}|{words}.*{value}"):
                self.prepared("sscp1", name=key, **{key: value})

    def test_scaled_springs(self):
        """The laws are listed, where none of them is meant and where there are no springs."""
        with self.assertRaisesRegex(AssertionError, "stiffnessScaling square.*none, cubeRoot, twoThirds, linear"):
            self.prepared("sscp1", name="unknown", stiffnessScaling="square")
        for method in ("CGHS", "MPPIC"):
            with self.subTest(method), self.assertRaisesRegex(AssertionError, f"linear.*method {method} have no springs.*CGPM"):
                self.prepared("sscp1", name=method, method=method, stiffnessScaling="linear")
        self.refused(self.with_edit("parameters", r"^stiffnessScaling\s.*$", "stiffnessScaling square;"), "LIGGGHTS stopped",
                     r"scaling_square(.|\n)*of: none, cubeRoot, twoThirds, linear(.|\n)*ERROR")  # fmt: skip


class Scene(SpoiledCase):
    def test_particle_outside_the_mesh(self):
        """A parcel 2 cm above the vessel, in a LIGGGHTS box that was made higher."""

        def spoil(folder):
            self.edit(folder, "dem/bed.data", r"^0\.0 1\.2192 zlo zhi$", "0.0 1.3 zlo zhi")
            self.edit(folder, "dem/bed.data", r"^(7 1 \S+ \S+ \S+ \S+) \S+$", "7 1 0.006512 1131.0 0.1143 0.0381 1.24")

        self.refused(spoil, r"particle 7 \(rank \d\) is in no gas cell", r"\(0\.1143 0\.0381 1\.24\)", "outsideMesh", "t = 0 s")

    def test_particle_of_infinite_velocity(self):
        def spoil(folder):
            self.edit(folder, SCRIPT, r"^include\s+dem/\$\{method\}.*$", "include dem/CGPM.liggghts\nvelocity all set 0 0 1e400")

        self.refused(spoil, r"(is not finite|LIGGGHTS stopped)")

    def test_cell_smaller_than_a_particle(self):
        good = {
            ranks: self.prepared("sscp1", f"large{ranks}", ranks, weight=125, particleCount=12500, initialPacking=0.2, until=0.02)
            for ranks in RANKS
        }  # fmt: skip

        def spoil(folder):
            self.edit(folder, COUPLING, r"^(\s*)type\s+kernel;", "    type cellCentre;")

        # 1.2192 m / 85 cells; 5 diameters of 3.256 mm
        self.refused(spoil, r"smallest gas cell measures 0\.0142\d+ m", r"sphere of 0\.01628 m", "kernel", COUPLING, good=good)
        # the kernel bears them
        self.run_case(good[1])

    def test_solid_step_too_long(self):
        self.refused(
            self.with_edit(COUPLING, r"script\s+\S+;", 'script "dem/in.liggghts"; solidStep 2e-4;'),
            r"solid step of 0\.0002 s is too long", r"t_c = 0\.0010059\d* s", "solidStep", "t_c/20",
        )  # fmt: skip

    def test_no_particles(self):
        self.refused(self.with_edit(SCRIPT, r"^fix gravity", "delete_atoms group all compress no\nfix gravity"), "no particles", SCRIPT)

    def test_gravity_that_differs(self):
        self.refused(self.with_edit(SCRIPT, r"^fix gravity .*$", "fix gravity all gravity 1.62 vector 0.0 0.0 -1.0"),
                     r"constant/g says \(0 0 -9\.81\)", r"fix gravity \(0 0 -1\.62\)")  # fmt: skip

    def test_error_in_the_script(self):
        """LIGGGHTS's own words, and the command that it choked on."""
        self.refused(self.with_edit("dem/soft_spheres.liggghts", r"^fix move .*$", "fix move all nve/spere"), "LIGGGHTS stopped",
                     r"ERROR.*nve/spere|ERROR.*[Ff]ix style", r"\| fix move all nve/spere", "dem/log.liggghts")  # fmt: skip

    def test_variable_that_the_script_lacks(self):
        self.refused(self.with_edit(COUPLING, r"^\s*friction\s+\$friction;$", ""), "LIGGGHTS stopped",
                     r"ERROR.*variable", r"friction")  # fmt: skip

    def test_error_on_one_rank(self):
        """All parcels are on the second rank, and LIGGGHTS's neighbour lists overflow there: its words come from there."""

        def spoil(folder):
            self.edit(folder, SCRIPT, r"^fix gravity",
                      "region left block -1 0.13 -1 1 -1 2 units box\ndelete_atoms region left compress no\n"
                      "neigh_modify one 2 page 20\nfix gravity")  # fmt: skip

        self.refused(spoil, "LIGGGHTS stopped", r"ERROR on proc 1: Neighbor list overflow", "neigh_modify one", ranks=(2,))

    def test_missing_script(self):
        self.refused(lambda folder: os.remove(os.path.join(folder, SCRIPT)), "no LIGGGHTS script `dem/in.liggghts`",
                     r"couplingDict\.particles, line \d+")  # fmt: skip


class Gas(SpoiledCase):
    def without_field(self, name):
        def spoil(folder):
            for piece in self.pieces(folder):
                os.remove(os.path.join(piece, "0", name))

        self.refused(spoil, rf"{name}\b", "0/")

    def test_missing_velocity(self):
        self.without_field("U")

    def test_missing_pressure(self):
        self.without_field("p_rgh")

    def test_missing_boundary_condition(self):
        def spoil(folder):
            for piece in self.pieces(folder):
                path = os.path.join(piece, "0/U")
                with open(path, "rb") as file:  # a decomposed field is binary
                    content = file.read()
                with open(path, "wb") as file:
                    file.write(content.replace(b"    outlet\n", b"    outlett\n"))

        self.refused(spoil, "outlet", r"0/U")

    def test_missing_property(self):
        self.refused(self.with_edit("constant/transportProperties", r"^mu\s.*$", ""), "'?mu'?", "transportProperties")

    def test_missing_gravity(self):
        self.refused(lambda folder: os.remove(os.path.join(folder, "constant/g")), r"constant/g|\bg\b")

    def test_missing_solver(self):
        self.refused(self.with_edit("system/fvSolution", r"^    p_rgh$", "    pressure"), "p_rgh", "fvSolution")

    def test_missing_scheme(self):
        self.refused(self.with_edit("system/fvSchemes", r"^divSchemes\s*\{[^}]*\}", "divSchemes { default none; }"),
                     r"Entry .div\(", "fvSchemes")  # fmt: skip

    def test_missing_mesh(self):
        def spoil(folder):
            for piece in self.pieces(folder):
                shutil.rmtree(os.path.join(piece, "constant/polyMesh"))

        self.refused(spoil, "polyMesh|mesh")

    def test_missing_control(self):
        self.refused(self.with_edit("system/controlDict", r"^deltaT\s.*$", ""), "deltaT", "controlDict")


class Launch(SpoiledCase):
    def test_more_ranks_than_parts(self):
        folder = self.copied(self.good[2])
        self.stopped(support.execute(folder, 3, timeout=60), "into 2 parts", "3 ranks", "decomposePar", "start 2 ranks")

    def test_no_parts(self):
        folder = self.copied(self.good[1])
        self.stopped(support.execute(folder, 2, timeout=60), "2 ranks", "not decomposed", "decomposePar", "start 1 rank")

    def test_no_decomposition_dictionary(self):
        self.refused(lambda folder: os.remove(os.path.join(folder, "system/decomposeParDict")), "system/decomposeParDict", ranks=(2,))

    def test_folder_that_is_no_case(self):
        os.mkdir(os.path.join(self.root, "empty"))
        for folder in (os.path.join(self.root, "empty"), os.path.join(self.root, "nowhere")):
            for ranks in RANKS:
                program = support.execute_from(self.root, folder, ranks)
                self.stopped(program, re.escape(folder), "is not a case", "-case")

    def test_case_without_coupling(self):
        self.refused(lambda folder: os.remove(os.path.join(folder, COUPLING)), "is not a case", "couplingDict")


class DuringTheRun(SpoiledCase):
    """What goes wrong on the way stops the run; what was recorded until then can be read."""

    def stops(self, spoil, *expected, rows, ranks=RANKS):
        """`rows` of the ledger at least, each one complete."""
        for count in ranks:
            with self.subTest(ranks=count):
                folder = self.copied(self.good[count], f"spoiled{count}")
                spoil(folder)
                done = support.execute(folder, count, timeout=200)
                message = self.stopped(done, *expected, r"t = 0\.\d+ s to 0\.\d+ s")
                with done.results() as file:
                    ledger = file["/ledger"]
                    count_of_rows = len(ledger["time"])
                    self.assertGreaterEqual(count_of_rows, rows)
                    self.assertEqual({len(column) for column in ledger.values()}, {count_of_rows})
                    reached = float(file["/meta"].attrs["simulated_time"])
                    self.assertLess(reached, 0.02)
                    # the message's time is the step after the last row's
                    start = float(re.search(r"from t = (\S+) s", message)[1])
                    self.assertAlmostEqual(start, ledger["time"][-1], delta=1e-9)
                self.assertGreaterEqual(len(done.snapshots()), 1)
                shutil.rmtree(folder)

    def test_gas_that_is_not_finite(self):
        """The inflow rises to 1e200 m/s after 5 ms."""

        def spoil(folder):
            ramp = b"type uniformFixedValue; uniformValue table ((0 (0 0 2)) (0.005 (0 0 2)) (0.006 (0 0 1e200)) (1 (0 0 1e200)));"
            for piece in self.pieces(folder):
                path = os.path.join(piece, "0/U")
                with open(path, "rb") as file:
                    content = file.read()
                content, found = re.subn(rb"(inlet\s*\{\s*)type\s+fixedValue;\s*value\s+[^;]*;", rb"\1" + ramp, content)
                if found != 1:  # a part of the mesh without inlet faces has an empty patch, not none
                    raise AssertionError(f"no inlet in {path}")
                with open(path, "wb") as file:
                    file.write(content)

        self.stops(spoil, r"gas field (U|p_rgh) is not finite in cell \d+ of rank \d", r"at \(\S+ \S+ \S+\)", "deltaT", rows=4)

    def test_particle_that_is_not_finite(self):
        """A force that grows beyond all numbers after 100 solid steps."""

        def spoil(folder):
            self.edit(folder, SCRIPT, r"^fix gravity",
                      "group one id 11\nvariable push equal \"(step>100)*1e300\"\nfix push one addforce v_push 0.0 0.0\nfix gravity")  # fmt: skip

        self.stops(spoil, r"particle 11 \(rank \d\)", rows=4)

    def test_lost_particles(self):
        """There is no bottom: parcels fall out of the vessel."""

        def spoil(folder):
            self.edit(folder, "dem/soft_spheres.liggghts", r"^fix bottom .*$", "velocity all set 0.0 0.0 -1.0")

        self.stops(spoil, r"particle \d+ \(rank \d\)", r"at \(\S+ \S+ \S+\)", "walls", rows=1)

    def test_particle_that_liggghts_drops(self):
        """One that leaves at 1 km/s is out of LIGGGHTS's box before the gas looks for it."""

        def spoil(folder):
            self.edit(folder, SCRIPT, r"^fix gravity",
                      "group one id 11\nvariable push equal \"(step>100)*1e3\"\nfix push one addforce 0.0 0.0 v_push\nfix gravity")  # fmt: skip
            self.edit(folder, "dem/soft_spheres.liggghts", r"^fix top .*$", "")

        self.stops(spoil, r"1 of 1000 particles were lost", r"particle 11 \(rank \d\)", r"at \(\S+ \S+ \S+\)", rows=4)

    def test_packing_above_the_limit(self):
        """Parcels blown up to four times their diameter fill 0.44 of the vessel, more than the limit of 0.4."""

        def spoil(folder):
            self.edit(folder, COUPLING, r"maximumPacking\s+0.74;", "maximumPacking 0.4;")
            self.edit(folder, SCRIPT, r"^fix gravity",
                      "variable grown equal \"0.006512*(1+3*(step>100))\"\nfix grow all adapt 20 atom diameter v_grown\nfix gravity")  # fmt: skip

        self.stops(spoil, r"solid fraction \(voidage field\) is \S+ in cell \d+ of rank \d, above the limit of 0\.4",
                   r"at \(\S+ \S+ \S+\)", "maximumPacking", rows=4)  # fmt: skip
