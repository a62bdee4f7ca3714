#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/bed: the spheres asked for, none overlapping, in the box, the same every time; and what it refuses."""

import itertools
import math
import os
import shutil
import subprocess
import tempfile
import unittest

BED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools", "bed")
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


class WithBed(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.path = os.path.join(self.folder, "bed.data")

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


@unittest.skipUnless(shutil.which("liggghts"), "needs the liggghts binary")
class ReadByLiggghts(WithBed):
    def test_liggghts_reads_it(self):
        """Mass and heights as LIGGGHTS reads them: the columns are in the order it expects."""
        self.bed("--count", 500, "--packing", 0.3)
        script = os.path.join(self.folder, "in")
        with open(script, "w", encoding="ascii") as file:
            file.write(
                "units si\natom_style granular\natom_modify map array sort 0 0\nboundary f f f\nnewton off\n"
                f"communicate single vel yes\nread_data {self.path}\n"
                'variable m equal mass(all)\nvariable z equal xcm(all,z)\nfix keep all nve/sphere\nrun 0\n'
                'print "mass ${m} centre ${z}"\n'
            )
        run = subprocess.run(
            ["liggghts", "-in", script, "-log", "none"], cwd=self.folder, capture_output=True, text=True, timeout=60
        )
        words = [line.split() for line in run.stdout.splitlines() if line.startswith("mass ")]
        self.assertTrue(words, run.stdout + run.stderr)
        mass, centre = float(words[-1][1]), float(words[-1][3])
        self.assertAlmostEqual(mass / (500 * 1131 * math.pi / 6 * 6.512e-3**3), 1, delta=1e-9)
        heights = [z for _, _, z in Bed(self.path).centres]
        self.assertAlmostEqual(centre, sum(heights) / 500, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
