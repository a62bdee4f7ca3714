# SPDX-License-Identifier: GPL-3.0-or-later
"""What tools/run --from finds in a run and in a case's script, in made-up ones: times of a run, types and densities of its
spheres, where a script takes its particles from. tests/program/test_from.py runs the program."""

import os

import h5py
import numpy

from interphase import foam_field, particle_file, starting_particles, starting_point, starting_run
from interphase.case_folder import Dictionaries
from interphase.input_error import InputError
from interphase.particle_script import particle_source
from scratch import InFolder, write, write_results, write_snapshots

COUPLING = 'method DEM;\nweight 1;\nparticles { script "dem/in.liggghts"; variables { method DEM; bed start; } }\n'
SCRIPT = "boundary f p f\nread_data dem/bed.data  # the bed\n"


def spheres(kinds, diameters, densities, ids=None):
    count = len(kinds)
    ids = numpy.arange(1, count + 1) if ids is None else numpy.array(ids)
    return particle_file.ParticleFile(
        2, numpy.zeros(3), numpy.ones(3), ids, numpy.array(kinds), numpy.array(diameters, dtype=float), numpy.array(densities, dtype=float))


class Folder(InFolder):
    def case(self, name, held, script=SCRIPT, places=None):
        """A case whose file holds the spheres `held`, none where None."""
        folder = os.path.join(self.root, name)
        write(os.path.join(folder, "system/couplingDict"), COUPLING)
        write(os.path.join(folder, "dem/in.liggghts"), script)
        if held is not None:
            rest = numpy.zeros((len(held.ids), 3))
            particle_file.write(os.path.join(folder, "dem/bed.data"), "made up", held, rest + 0.5 if places is None else places, rest, rest)
        return folder

    @staticmethod
    def record(folder, diameters, times=(0.0, 0.1), ids=None, weight=1.0, **more):
        """Snapshots of spheres in a row, moving by their time."""
        count = len(diameters)
        write_results(folder, weight=weight, method="DEM")
        write_snapshots(folder, [(time, {
            "id": numpy.arange(1, count + 1) if ids is None else numpy.array(ids), "position": numpy.full((count, 3), 0.5) + 0.1 * time,
            "velocity": numpy.full((count, 3), time), "angular_velocity": numpy.zeros((count, 3)),
            "diameter": numpy.array(diameters, dtype=float), **more}) for time in times])  # fmt: skip

    def put(self, run, case):
        """The spheres that the case then holds."""
        starting_particles.put(starting_run.find(run), case, "case")
        return particle_file.read(os.path.join(case, "dem/bed.data"))


class Times(Folder):
    def test_the_last_unless_another_is_named(self):
        run = os.path.join(self.root, "a@b")  # a name with the sign that times have
        self.record(run, [0.1], times=(0.0, 0.1, 0.2))
        self.assertEqual(starting_run.find(run).time, 0.2)
        self.assertEqual(starting_run.find(run + "@0.1").time, 0.1)
        self.assertEqual(starting_run.find(run + "@0").time, 0.0)
        with self.assertRaisesRegex(InputError, "nearest is at 0.2 s"):
            starting_run.find(run + "@7")

    def test_numbers_that_are_none(self):
        run = os.path.join(self.root, "run")
        self.record(run, [0.1, numpy.nan])
        with self.assertRaisesRegex(InputError, "diameter holds NaN"):
            starting_run.find(run)
        self.record(run, [])
        with self.assertRaisesRegex(InputError, "no particles"):
            starting_run.find(run)


class Weights(Folder):
    def test_of_single_spheres(self):
        run = os.path.join(self.root, "run")
        self.record(run, [0.1, 0.1], weight=8, **{"weight_": [1, 1]})
        start = starting_run.find(run)
        starting_particles.check_weight(start, 8, "case")
        with self.assertRaisesRegex(InputError, "stand for 8 particles each, and case has weight 2"):
            starting_particles.check_weight(start, 2, "case")
        start.particles.quantities["weight"] = numpy.array([1.0, 8.0])
        with self.assertRaisesRegex(InputError, "stand for 1 to 8 particles"):
            starting_particles.check_weight(start, 8, "case")


class Kinds(Folder):
    """Types and densities, which snapshots may not have."""

    def test_follow_the_ids_of_the_runs_own_file(self):
        """Of one diameter, and in another order than in the file."""
        held = spheres([1, 2, 1], [0.1, 0.1, 0.1], [1000, 2000, 1000])
        run, case = self.case("run", held), self.case("case", held)
        self.record(run, [0.1, 0.1], ids=[3, 2])
        found = self.put(run, case)
        self.assertEqual((found.ids.tolist(), found.kind.tolist(), found.density.tolist()), ([2, 3], [2, 1], [2000, 1000]))

    def test_follow_the_diameter_where_a_run_has_no_file(self):
        case = self.case("case", spheres([1, 2], [0.1, 0.2], [1000, 2000]))
        run = os.path.join(self.root, "run")
        self.record(run, [0.2, 0.1, 0.2])
        found = self.put(run, case)
        self.assertEqual((found.kind.tolist(), found.density.tolist()), ([2, 1, 2], [2000, 1000, 2000]))

    def test_ids_are_not_trusted_where_spheres_were_poured_in(self):
        """Theirs may be those of spheres that had left."""
        held = spheres([1, 2], [0.1, 0.1], [1000, 2000])
        run = self.case("run", held, SCRIPT + "fix pour all insert/stream seed 1\n")
        self.record(run, [0.1, 0.1])
        with self.assertRaisesRegex(InputError, "found type 1, 1000 kg/m3; type 2, 2000 kg/m3"):
            self.put(run, self.case("case", held))

    def test_are_taken_from_snapshots_that_have_them(self):
        held = spheres([1, 2], [0.1, 0.1], [1000, 2000])
        run, case = os.path.join(self.root, "run"), self.case("case", held)
        self.record(run, [0.1, 0.1], type=[2, 1], density=[2000.0, 1000.0])
        found = self.put(run, case)
        self.assertEqual((found.kind.tolist(), found.density.tolist()), ([2, 1], [2000, 1000]))

    def test_spheres_within_a_distribution_of_sizes(self):
        """A case with many sizes is for all between them, one of another density is not."""
        case = self.case("case", spheres([1, 1], [0.1, 0.2], [1000, 1000]))
        run = os.path.join(self.root, "run")
        self.record(run, [0.15], type=[1], density=[1000.0])
        self.assertEqual(self.put(run, case).diameter.tolist(), [0.15])
        self.record(run, [0.15], type=[1], density=[1200.0])
        with self.assertRaisesRegex(InputError, "another density than those of case: 1200 kg/m3, and dem/bed.data has"):
            self.put(run, case)
        self.record(run, [0.15], type=[2], density=[1000.0])
        with self.assertRaisesRegex(InputError, "1 spheres of type 2, and dem/bed.data of case none"):
            self.put(run, case)

    def test_every_digit(self):
        """Numbers whose decimals are long, and a run whose name is longer than what LIGGGHTS reads of a first line."""
        case = self.case("case", spheres([1, 1], [0.1, 0.1], [1000, 1000]))
        run = os.path.join(self.root, "r" * 200, "\u00e4" * 100)
        self.record(run, [0.1, 0.1])
        with h5py.File(os.path.join(run, "particles.h5"), "r+") as file:
            position = numpy.random.default_rng(1).uniform(0, 1, (2, 3))
            file["snapshots/000001/position"][...] = position
            file["snapshots/000001/velocity"][...] = -position / 3e7
        self.put(run, case)
        with open(os.path.join(case, "dem/bed.data"), encoding="ascii") as stream:
            text = stream.read()
        self.assertLess(len(text.splitlines()[0]), 255)
        rows = [line.split() for line in text.splitlines() if len(line.split()) == 7 and line[0].isdigit()]
        numpy.testing.assert_array_equal(numpy.array(rows[:2], dtype=float)[:, 4:], position)
        numpy.testing.assert_array_equal(numpy.array(rows[2:], dtype=float)[:, 1:4], -position / 3e7)


class Vessels(Folder):
    def test_the_outside_along_what_does_not_repeat(self):
        case = self.case("case", spheres([1, 1], [0.1, 0.1], [1000, 1000]))
        run = os.path.join(self.root, "run")
        self.record(run, [0.1, 0.1])
        for place, inside in (((0.5, 1.2, 0.5), True), ((1.2, 0.5, 0.5), False), ((0.5, 0.5, -0.01), False)):
            with h5py.File(os.path.join(run, "particles.h5"), "r+") as file:
                file["snapshots/000001/position"][1] = place
            with self.subTest(place):
                if inside:
                    self.put(run, case)
                else:
                    with self.assertRaisesRegex(InputError, "1 of 2 particles of .* are outside of the box .* the first is particle 2"):
                        self.put(run, case)


    def test_the_outside_of_the_gas_mesh(self):
        """By more than a radius: nearer ones are for the program, which knows the cells."""
        case = self.case("case", spheres([1, 1], [0.1, 0.1], [1000, 1000]))
        corners = " ".join(f"({x} {y} {z})" for x in (0, 0.8) for y in (0, 1) for z in (0, 1))
        write(os.path.join(case, "constant/polyMesh/points"), f"FoamFile {{ format ascii; class vectorField; }}\n8\n(\n{corners}\n)\n")
        run = os.path.join(self.root, "run")
        self.record(run, [0.1, 0.1])
        for x, inside in ((0.84, True), (0.86, False)):
            with h5py.File(os.path.join(run, "particles.h5"), "r+") as file:
                file["snapshots/000001/position"][0] = (x, 0.5, 0.5)
            start = starting_run.find(run)
            with self.subTest(x):
                if inside:
                    starting_point.refuse_outside_of_mesh(start, case, "case")
                    continue
                with self.assertRaisesRegex(InputError, "1 of 2 particles of .* outside of the gas mesh of case .*x 0 to 0.8"):
                    starting_point.refuse_outside_of_mesh(start, case, "case")
                coupling = os.path.join(case, "system/couplingDict")
                write(coupling, COUPLING + "outsideMesh ignore;\n")
                starting_point.refuse_outside_of_mesh(start, case, "case")


class Scripts(Folder):
    def source(self, script, **files):
        folder = self.case("case", None, script)
        for name, text in files.items():
            write(os.path.join(folder, "dem", name), text)
        return particle_source(Dictionaries(folder))

    def test_includes_and_variables_are_followed(self):
        found = self.source("include dem/${method}\nvariable old index never\nread_data &\n dem/${bed}.data\n", DEM="boundary p f p  # repeats\n")
        self.assertEqual((found.file, found.periodic, found.others), ("dem/start.data", (True, False, True), []))

    def test_what_makes_or_changes_particles(self):
        for line in ("create_atoms 1 single 0 0 0", "fix pour all insert/pack seed 1", "velocity all set 0 0 1", "set type 1 density 3",
                     "read_data dem/more.data", "read_restart old", 'if "${bed} == 1" then "create_atoms 1 box"'):  # fmt: skip
            with self.subTest(line):
                found = self.source(SCRIPT + line + "\n")
                self.assertEqual(found.file, "dem/bed.data")
                self.assertEqual(len(found.others), 1)
                self.assertIn("dem/in.liggghts:3: " + line.split()[0], found.others[0])
                with self.assertRaisesRegex(InputError, "also makes or changes particles"):
                    starting_particles.check_script(found, "case")
        for line in ("fix w all property/atom weight scalar yes no no 1", "set type 1 property/atom weight 8", "fix g all gravity 9.81"):
            with self.subTest(line):
                self.assertEqual(self.source(SCRIPT + line + "\n").others, [])

    def test_what_is_included_and_not_there(self):
        with self.assertRaisesRegex(InputError, "'dem/gone', which the script of the particles includes, is not in"):
            self.source("include dem/gone\n")


class Fields(Folder):
    VALUES = [[0.1, 1 / 3, -2e-300], [1.0, 2.0, 3.0]]

    def read(self, text, name="U", more=0.0):
        path = os.path.join(self.root, name)
        with open(path, "wb") as stream:
            stream.write(text)
        return foam_field.internal_values(path, more)

    def test_binary_and_text_say_the_same(self):
        head = b'FoamFile { version 2.0; format %s; class volVectorField; arch "LSB;label=32;scalar=64"; }\ninternalField '
        lists = {
            b"binary": b"nonuniform List<vector> \n2\n(" + numpy.array(self.VALUES).tobytes() + b")",
            b"ascii": b"nonuniform List<vector>\n2\n(\n(0.1 0.3333333333333333 -2e-300)\n(1 2 3)\n)",
        }
        expected = "nonuniform List<vector>\n2\n(\n(0.1 0.3333333333333333 -2e-300)\n(1.0 2.0 3.0)\n)"
        for form, values in lists.items():
            with self.subTest(form):
                whole = head % form + values + b";\n\nboundaryField\n{\n    top { type zeroGradient; }\n}\n"
                self.assertEqual(self.read(whole), expected)
                with self.assertRaisesRegex(InputError, "torn"):
                    self.read(whole[: whole.index(values) + len(values) - 8])

    def test_of_a_rank_without_cells(self):
        """OpenFOAM then writes neither kind nor numbers."""
        path = os.path.join(self.root, "U")
        write(path, "FoamFile { version 2.0; format ascii; class volVectorField; object U; }\ninternalField   nonuniform 0();\nboundaryField { }\n")
        self.assertEqual(foam_field.internal_field(path).values.shape, (0, 3))

    def test_one_value_for_all(self):
        self.assertEqual(self.read(b"internalField uniform (0 0 1);"), "uniform (0 0 1)")
        self.assertEqual(self.read(b"internalField uniform 101325;", more=-101325.0), "uniform 0.0")
        self.assertEqual(self.read(b"internalField nonuniform List<scalar> 3{2};"), "nonuniform List<scalar>\n3\n(\n2.0\n2.0\n2.0\n)")
