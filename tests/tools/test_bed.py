# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/bed: the spheres asked for, none overlapping, in the box, the same every time; and what it refuses."""

import itertools
import math
import os
import shutil
import subprocess
import unittest

import numpy
from hypothesis import given, strategies as st
from scipy.spatial import cKDTree
from scipy.stats import kstest, lognorm

from interphase import sizes
from interphase.input_error import InputError
from interphase.tree import TOOLS
import made_up  # noqa: F401  (how examples are drawn)
from scratch import InFolder

BED = os.path.join(TOOLS, "bed")
VESSEL = ["0", "0.2286", "0", "0.0762", "0", "1.2192"]  # SSCP-I


class Bed:
    """A data file read back: `header`, `ids`, `columns` (type, diameter, density), `centres`."""

    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            self.text = file.read()
        header, _, atoms = self.text.partition("\nAtoms\n\n")
        self.header = header
        rows = [line.split() for line in atoms.splitlines()]
        self.ids = [int(row[0]) for row in rows]
        self.columns = {tuple(row[1:4]) for row in rows}
        self.centres = [tuple(float(x) for x in row[4:]) for row in rows]

    def smallest_distance(self, cutoff):
        """Of any two centres, when below `cutoff`; infinity otherwise."""
        cells = {}
        for n, x in enumerate(self.centres):
            cells.setdefault(tuple(int(a // cutoff) for a in x), []).append(n)
        least = math.inf
        for cell, inside in cells.items():
            near = [
                n
                for shift in itertools.product((-1, 0, 1), repeat=3)
                for n in cells.get(tuple(a + s for a, s in zip(cell, shift)), ())
            ]
            for i in inside:
                for j in near:
                    if j > i:
                        least = min(least, math.dist(self.centres[i], self.centres[j]))
        return least


class WithBed(InFolder):
    def setUp(self):
        super().setUp()
        self.path = os.path.join(self.root, "bed.data")

    def run_bed(self, *options, diameter="6.512e-3", box=None):
        command = [BED, "--diameter", diameter, "--density", "1131", "--box", *(box or VESSEL), "--out", self.path]
        return subprocess.run([*command, *map(str, options)], capture_output=True, text=True)

    def bed(self, *options, **named):
        run = self.run_bed(*options, **named)
        self.assertEqual(run.returncode, 0, run.stderr)
        return Bed(self.path)

    def refused(self, *options, **named):
        run = self.run_bed(*options, **named)
        self.assertNotEqual(run.returncode, 0)
        self.assertFalse(os.path.exists(self.path), "a file was written all the same")
        self.assertNotIn("Traceback", run.stderr)
        return run.stderr


class BedTest(WithBed):
    def test_no_overlap_with_spheres_or_walls(self):
        for packing, jitter in ((0.35, 1), (0.45, 1), (0.45, 0)):
            bed = self.bed("--count", 11875, "--packing", packing, "--jitter", jitter)
            self.assertEqual(len(bed.centres), 11875)
            self.assertGreaterEqual(bed.smallest_distance(7e-3), 6.512e-3 * (1 - 1e-12))
            for low, high, values in zip((0, 0, 0), (0.2286, 0.0762, 1.2192), zip(*bed.centres)):
                self.assertGreaterEqual(min(values), low + 3.256e-3 * (1 - 1e-12))
                self.assertLessEqual(max(values), high - 3.256e-3 * (1 - 1e-12))

    def test_packing_and_fill_agree(self):
        solid = 11875 * math.pi / 6 * 6.512e-3**3 / (0.2286 * 0.0762)
        by_packing = self.bed("--count", 11875, "--packing", 0.4).centres
        by_height = self.bed("--count", 11875, "--fill", repr(solid / 0.4)).centres
        for a, b in zip(by_packing, by_height):
            self.assertLess(math.dist(a, b), 1e-12)
        top = max(z for _, _, z in by_packing)
        self.assertLess(top, solid / 0.4)
        self.assertGreater(top, solid / 0.4 - 0.008)  # within a layer

    def test_numbered_from_the_bottom(self):
        bed = self.bed("--count", 11875, "--packing", 0.4)
        self.assertEqual(bed.ids, list(range(1, 11876)))
        heights = [z for _, _, z in bed.centres]
        highest = 0
        for z in heights:
            self.assertGreater(z, highest - 6.512e-3)  # never by a layer below an earlier one
            highest = max(highest, z)

    def test_top_layer_is_spread_out(self):
        bed = self.bed("--count", 374 + 4, "--packing", 0.2)
        last = [x for x, _, z in bed.centres if z > max(z for _, _, z in bed.centres) - 6.5e-3]
        self.assertGreater(max(last) - min(last), 0.1)

    def test_same_again_and_other_seed(self):
        first = self.bed("--count", 1000, "--packing", 0.3, "--seed", 7).text
        self.assertEqual(first, self.bed("--count", 1000, "--packing", 0.3, "--seed", 7).text)
        self.assertNotEqual(first, self.bed("--count", 1000, "--packing", 0.3, "--seed", 8).text)

    def test_header_and_columns(self):
        bed = self.bed("--count", 10, "--fill", 0.01, "--types", 3)
        self.assertIn("\n10 atoms\n3 atom types\n", bed.header)
        self.assertIn("\n0.0 0.2286 xlo xhi\n0.0 0.0762 ylo yhi\n0.0 1.2192 zlo zhi\n", bed.header)
        self.assertEqual(bed.columns, {("1", "0.006512", "1131.0")})

    def test_grid_is_uniform_and_exact(self):
        for lattice, per_cell, voidage in (("cubic", 1, 0.5), ("bcc", 2, 0.42), ("fcc", 4, 0.30)):
            edge = (per_cell * math.pi / 6 * 1e-9 / (1 - voidage)) ** (1 / 3)
            box = [0, 4 * edge, 0, 4 * edge, 0, 10 * edge]
            region = [0, 4 * edge, 0, 4 * edge, 2 * edge, 8 * edge]
            bed = self.bed(
                "--grid", "--lattice", lattice, "--voidage", voidage, "--region", *map(repr, region),
                diameter="1e-3", box=list(map(repr, box)),
            )  # fmt: skip
            self.assertEqual(len(bed.centres), 4 * 4 * 6 * per_cell)
            self.assertGreaterEqual(bed.smallest_distance(1.5e-3), 1e-3)
            in_cell = {}
            for x in bed.centres:
                cell = tuple(int(a / edge) for a in x)
                in_cell[cell] = in_cell.get(cell, 0) + 1
            self.assertEqual(set(in_cell.values()), {per_cell})
            self.assertEqual(len(in_cell), 4 * 4 * 6)
            heights = [z for _, _, z in bed.centres]
            self.assertEqual(heights, sorted(heights))

    def test_refuses_what_does_not_fit(self):
        message = self.refused("--count", 11875, "--packing", 0.6)
        for part in ("11875 spheres", "without overlap", "needs 0."):
            self.assertIn(part, message)
        self.assertIn("1.2192 m high", self.refused("--count", 100000, "--packing", 0.4))
        self.assertIn("narrower than one sphere", self.refused("--count", 1, "--fill", 1, diameter="0.08"))
        self.assertIn("leaves the box", self.refused("--count", 1, "--fill", 1, "--region", 0, 1, 0, 0.05, 0, 1))
        self.assertIn("empty along z", self.refused("--count", 1, "--fill", 1, box=["0", "1", "0", "1", "1", "0"]))

    def test_refuses_a_grid_that_is_none(self):
        self.assertIn("whole number", self.refused("--grid", "--voidage", 0.42))
        self.assertIn("overlap below a voidage of 0.3198", self.refused("--grid", "--voidage", 0.3))
        self.assertIn("--voidage must be", self.refused("--grid", "--voidage", 1.2))

    def test_refuses_bad_arguments(self):
        self.assertIn("--diameter must be positive", self.refused("--count", 1, "--fill", 1, diameter="0"))
        self.assertIn("--packing must be", self.refused("--count", 1, "--packing", 40))
        self.assertIn("--count is missing", self.refused("--fill", 1))
        self.assertIn("--fill or --packing", self.refused("--count", 1))
        self.assertIn("--jitter must be", self.refused("--count", 1, "--fill", 1, "--jitter", 2))


class Sizes(unittest.TestCase):
    LENGTHS = st.floats(1e-5, 1e-2)

    @given(st.dictionaries(LENGTHS, st.floats(0.01, 100), min_size=1, max_size=5), st.integers(1, 5000), st.booleans())
    def test_a_table_s_counts_are_the_whole_numbers_nearest_to_its_shares(self, table, count, by_mass):
        made = sizes.Table(tuple(table), tuple(table.values()), by_mass)
        wanted = [share * count for share in made.number_shares()]
        try:
            counts = made.counts(count)
        except InputError:
            self.assertLess(min(wanted), 1)  # one of the sizes would have none
            return
        self.assertEqual(sum(counts), count)
        self.assertTrue(all(abs(n - share) < 1 for n, share in zip(counts, wanted)))

    @given(LENGTHS, st.floats(1.01, 3), st.integers(1, 300), st.booleans(), st.floats(0.1, 0.9), st.floats(1.1, 10))
    def test_a_lognormal_s_particles_are_its_quantiles(self, median, deviation, count, by_mass, low, high):
        made = sizes.Lognormal(median, deviation, by_mass, low * median, high * median)
        try:
            diameters = made.particles(count)
        except InputError:  # by mass, the numbers' median may lie far below the cuts
            return
        self.assertEqual(diameters, sorted(diameters))
        self.assertTrue(low * median * (1 - 1e-9) <= diameters[0] and diameters[-1] <= high * median * (1 + 1e-9))
        for at, diameter in enumerate(diameters):
            self.assertAlmostEqual(made.share_below(diameter), (at + 0.5) / count, delta=1e-6)


class MixedBed(WithBed):
    """Sizes by table and by formula, by number and by mass, with weights."""

    BOX = ["0", "0.03", "0", "0.02", "0", "0.1"]

    def run_bed(self, *options, box=None, **_):
        command = [BED, "--density", "2500", "--box", *(box or self.BOX), "--out", self.path]
        return subprocess.run([*command, *map(str, options)], capture_output=True, text=True)

    def atoms(self, *options):
        self.bed(*options)
        with open(self.path, encoding="ascii") as file:
            rows = numpy.loadtxt(file.read().partition("\nAtoms\n\n")[2].splitlines(), ndmin=2)
        return rows[:, 1].astype(int), rows[:, 2], rows[:, 4:]

    def assert_apart(self, diameter, centre, fill):
        """No two overlap, and none leaves the box up to `fill` [m]."""
        pairs = cKDTree(centre).query_pairs(diameter.max(), output_type="ndarray")
        gap = numpy.linalg.norm(centre[pairs[:, 0]] - centre[pairs[:, 1]], axis=1) - diameter[pairs].mean(axis=1)
        self.assertGreaterEqual(gap.min(), 0)
        self.assertTrue((centre - diameter[:, None] / 2 >= 0).all())
        self.assertTrue((centre + diameter[:, None] / 2 <= (0.03, 0.02, fill * (1 + 1e-12))).all())

    def test_table_by_mass(self):
        """Whole numbers of each size, mass shares within one particle, the solid fraction asked for."""
        shares, packing = {1e-3: 0.3, 1.5e-3: 0.3, 2e-3: 0.4}, 0.5
        _, diameter, centre = self.atoms("--sizes", *(f"{d}:{s}" for d, s in shares.items()), "--shares", "mass", "--count", 4000,
                                         "--packing", packing)  # fmt: skip
        self.assertEqual(len(diameter), 4000)
        volume = math.pi / 6 * diameter**3
        for size, share in shares.items():
            self.assertAlmostEqual(volume[diameter == size].sum() / volume.sum(), share, delta=math.pi / 6 * size**3 / volume.sum())
        self.assert_apart(diameter, centre, volume.sum() / (packing * 0.03 * 0.02))
        # as dense everywhere: a third of the height holds a third of the volume but for the layers at both ends
        thirds = numpy.histogram(centre[:, 2], 3, weights=volume)[0] / volume.sum()
        self.assertLess(abs(thirds - 1 / 3).max(), 0.03)

    def test_lognormal(self):
        """By number and by mass: the share of particles below each diameter, and Hatch and Choate's relation of the medians."""
        for shares, median in (("number", 1e-3), ("mass", 1e-3 * math.exp(3 * math.log(1.3) ** 2))):
            _, diameter, centre = self.atoms("--lognormal", repr(median), 1.3, "--shares", shares, "--count", 3000, "--packing", 0.45)
            # quantiles: the empirical distribution function is within 1/2 n of the true one, the KS distance at random is 0.025
            distance = kstest(diameter, lognorm(math.log(1.3), scale=1e-3).cdf).statistic
            self.assertLessEqual(distance, 0.5 / 3000 * (1 + 1e-6))
            self.assert_apart(diameter, centre, math.pi / 6 * (diameter**3).sum() / (0.45 * 0.03 * 0.02))

    def test_cuts(self):
        _, diameter, _ = self.atoms("--lognormal", 1e-3, 1.5, "--cut", 8e-4, 1.5e-3, "--count", 2000, "--fill", 0.05)
        self.assertGreater(diameter.min(), 8e-4)
        self.assertLess(diameter.max(), 1.5e-3)
        self.assertAlmostEqual(numpy.median(diameter), 1.0699e-3, delta=0.002e-3)  # the quantile midway between 0.2910 and 0.8413

    def test_weights_of_each_size(self):
        """Parcels of d W^(1/3); real numbers and mass are those of the table within a parcel."""
        script = os.path.join(self.root, "weights")
        kind, diameter, centre = self.atoms("--sizes", "5e-4:0.9", "1e-3:0.1", "--count", 20000, "--weights", 27, 8, "--type-per-size",
                                            "--types", 3, "--script", script, "--packing", 0.4)  # fmt: skip
        self.assertEqual([int((kind == k).sum()) for k in (1, 2)], [667, 250])  # of 18,000 and 2,000
        self.assertTrue(numpy.allclose(diameter, numpy.where(kind == 1, 1.5e-3, 2e-3), rtol=1e-12))
        self.assert_apart(diameter, centre, 1)
        with open(script, encoding="ascii") as file:
            text = file.read()
        for line in ("fix weights all property/atom weight scalar yes no no 27.0\nrun 0\n", "set type 1 property/atom weight 27.0\n",
                     "set type 2 property/atom weight 8.0\n"):  # fmt: skip
            self.assertIn(line, text)

    def test_same_again_and_other_seed(self):
        options = ("--sizes", "1e-3:1", "2e-3:1", "--count", 400, "--packing", 0.3)
        first = self.bed(*options).text
        self.assertEqual(first, self.bed(*options).text)
        self.assertNotEqual(first, self.bed(*options, "--seed", 8).text)

    def test_refuses(self):
        rest = ("--count", 100, "--packing", 0.4)
        for options, words in (
            (("--sizes", "1e-3", *rest), "D:SHARE"),
            (("--sizes", "1e-3:-1", "2e-3:1", *rest), "share of 0.001 m must be"),
            (("--sizes", "1e-3:1", "1e-3:2", *rest), "twice"),
            (("--sizes", "1e-3:1", "2e-3:1e-9", *rest), "none of 100 particles would be of 0.002 m"),
            (("--lognormal", 1e-3, 0.5, *rest), "geometric standard deviation"),
            (("--lognormal", 1e-3, 1.1, "--cut", 5e-3, 6e-3, *rest), "leave nothing"),
            (("--lognormal", 1e-3, 1.1, "--weights", 2, 3, *rest), "one weight"),
            (("--sizes", "1e-3:1", "2e-3:1", "--weights", 2, 3, *rest), "type of their own"),
            (("--sizes", "1e-3:1", "2e-3:1", "--weights", 0.5, *rest), "weight counts real"),
            (("--sizes", "1e-3:1", "2e-3:1", "--jitter", 0.5, *rest), "--jitter"),
            (("--sizes", "1e-3:1", "2e-3:1", "--count", 100, "--packing", 0.8), "packing of 0.8"),
            (("--sizes", "1e-3:1", "2e-3:1", "--count", 1000000, "--packing", 0.4), "m high"),
            (("--sizes", "1e-3:1", "--diameter", 1e-3, *rest), "not allowed with"),
            (("--diameter", 1e-3, "--weights", 2, *rest), "mixed beds"),
        ):
            with self.subTest(options=options):
                self.assertIn(words, self.refused(*options))


@unittest.skipUnless(shutil.which("liggghts"), "needs the liggghts binary")
class ReadByLiggghts(WithBed):
    def read_by_liggghts(self):
        """Mass [kg] and height of its centre [m]."""
        script = os.path.join(self.root, "in")
        with open(script, "w", encoding="ascii") as file:
            file.write(
                "units si\natom_style granular\natom_modify map array sort 0 0\nboundary f f f\nnewton off\n"
                f"communicate single vel yes\nread_data {self.path}\n"
                'variable m equal mass(all)\nvariable z equal xcm(all,z)\nfix keep all nve/sphere\nrun 0\n'
                'print "mass ${m} centre ${z}"\n'
            )
        run = subprocess.run(
            ["liggghts", "-in", script, "-log", "none"], cwd=self.root, capture_output=True, text=True, timeout=60
        )
        words = [line.split() for line in run.stdout.splitlines() if line.startswith("mass ")]
        self.assertTrue(words, run.stdout + run.stderr)
        return float(words[-1][1]), float(words[-1][3])

    def test_liggghts_reads_a_mixture(self):
        """Its mass is that of the particles asked for, to round-off."""
        command = [BED, "--sizes", "1e-3:0.7", "2e-3:0.3", "--count", "300", "--packing", "0.3", "--density", "2500", "--box", "0", "0.02",
                   "0", "0.02", "0", "0.1", "--out", self.path]  # fmt: skip
        subprocess.run(command, check=True, capture_output=True)
        mass, _ = self.read_by_liggghts()
        self.assertAlmostEqual(mass / (2500 * math.pi / 6 * (210 * 1e-9 + 90 * 8e-9)), 1, delta=1e-9)

    def test_liggghts_reads_it(self):
        """Mass and heights as LIGGGHTS reads them: the columns are in the order it expects."""
        self.bed("--count", 500, "--packing", 0.3)
        mass, centre = self.read_by_liggghts()
        self.assertAlmostEqual(mass / (500 * 1131 * math.pi / 6 * 6.512e-3**3), 1, delta=1e-9)
        heights = [z for _, _, z in Bed(self.path).centres]
        self.assertAlmostEqual(centre, sum(heights) / 500, delta=1e-9)
