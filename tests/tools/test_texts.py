# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts that several programs write: data files of LIGGGHTS come back to the last bit and are read by LIGGGHTS; tables stay in line;
lists of the command line come apart where they were put together."""

import os
import shutil
import subprocess
import unittest

import numpy
from hypothesis import given, strategies as st

from interphase import data_file, particle_file, sweep_plan, tables
import made_up  # noqa: F401  (how examples are drawn)
from scratch import InFolder

READ = """units si
atom_style granular
atom_modify sort 0 0
boundary f f f
newton off
communicate single vel yes
read_data spheres.data
neighbor 1e-3 bin
pair_style none
fix m1 all property/global youngsModulus peratomtype 5e6 5e6 5e6
fix move all nve/sphere
dump all all custom 1 spheres.dump id type x y z vx vy vz omegax omegay omegaz radius density
dump_modify all format "%d %d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
timestep 1e-9
run 0
"""


FINITE = st.floats(allow_nan=False, allow_infinity=False, width=64).filter(lambda x: abs(x) < 1e300)
POSITIVE = FINITE.map(abs).filter(bool)
CELLS = st.text(st.characters(min_codepoint=33, max_codepoint=0x24F, blacklist_characters="|", blacklist_categories=("Zs", "Cc", "Mn", "Cf")), max_size=8)


class DataFiles(InFolder):
    def setUp(self):
        super().setUp()
        self.path = os.path.join(self.root, "spheres.data")
        random = numpy.random.default_rng(3)
        self.position, self.velocity, self.spin = random.uniform(0.1, 0.9, (50, 3)), random.normal(size=(50, 3)), random.normal(size=(50, 3))
        self.diameter, self.density = random.uniform(1e-3, 2e-3, 50), random.uniform(1000, 2000, 50)
        self.kind = random.integers(1, 3, 50)
        data_file.write(self.path, "made up \u00e9\nin two lines " + 300 * "x", (0, 0, 0), (1, 1, 1), self.position, self.diameter, self.density, self.kind,
                        self.velocity, self.spin, types=3)  # fmt: skip

    @given(st.one_of(st.text(max_size=40), st.lists(st.sampled_from(("\r", "\n", "Atoms", "9 atom types")), max_size=8).map("".join)), st.integers(1, 9), st.lists(FINITE, min_size=3, max_size=3), st.lists(st.tuples(
        st.integers(1, 2**31 - 1), st.integers(1, 9), POSITIVE, POSITIVE, st.tuples(FINITE, FINITE, FINITE)), max_size=5, unique_by=lambda row: row[0]))
    def test_what_is_written_is_read(self, remark, types, low, rows):
        ids, kind, diameter, density, position = zip(*rows) if rows else ((),) * 5
        high = [x + 1.0 + abs(x) for x in low]
        data_file.write(self.path, remark, low, high, position, diameter, density, kind, types=types, ids=ids)
        found = particle_file.read(self.path)
        self.assertEqual(found.types, types)
        for values, written in ((found.ids, ids), (found.kind, kind), (found.diameter, diameter), (found.density, density),
                                (found.low, low), (found.high, high)):  # fmt: skip
            numpy.testing.assert_array_equal(values, written)

    @unittest.skipUnless(shutil.which("liggghts"), "needs the liggghts binary")
    def test_liggghts_reads_the_same_doubles(self):
        with open(os.path.join(self.root, "in.read"), "w", encoding="ascii") as stream:
            stream.write(READ)
        done = subprocess.run(["liggghts", "-in", "in.read"], cwd=self.root, capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:] + done.stderr)
        rows = numpy.loadtxt(os.path.join(self.root, "spheres.dump"), skiprows=9)
        rows = rows[numpy.argsort(rows[:, 0])]
        numpy.testing.assert_array_equal(rows[:, 1], self.kind)
        numpy.testing.assert_array_equal(rows[:, 2:11], numpy.hstack([self.position, self.velocity, self.spin]))
        numpy.testing.assert_array_equal(rows[:, 11], self.diameter / 2)
        # LIGGGHTS keeps the mass and gives the density back from it
        numpy.testing.assert_allclose(rows[:, 12], self.density, rtol=1e-15 * 4)

    def test_lists_and_one_value_for_all(self):
        text = data_file.text("two", [0, 0, 0], [1, 1, 1], [(0.25, 0.5, 0.5), (0.75, 0.5, 0.5)], 0.1, 2500)
        self.assertTrue(text.endswith("\n2 atoms\n2 atom types\n\n0.0 1.0 xlo xhi\n0.0 1.0 ylo yhi\n0.0 1.0 zlo zhi\n\nAtoms\n\n"
                                      "1 1 0.1 2500.0 0.25 0.5 0.5\n2 1 0.1 2500.0 0.75 0.5 0.5\n"), text)  # fmt: skip


class Tables(unittest.TestCase):
    def test_columns_are_as_wide_as_what_is_in_them(self):
        self.assertEqual(tables.columns([["a", "b"], ["longer", "1", "x"], ["c"]], right=(1,)), ["a       b", "longer  1  x", "c"])

    @given(st.lists(st.lists(CELLS, max_size=5), max_size=5), st.sets(st.integers(0, 4)))
    def test_every_cell_stands_in_its_column(self, rows, right):
        lines = tables.columns(rows, right)
        self.assertEqual(len(lines), len(rows))
        begin = 0
        for at in range(max(map(len, rows), default=0)):
            end = begin + max(len(row[at]) for row in rows if at < len(row))
            for row, line in zip(rows, lines):
                shown, cell = line[begin:end], row[at] if at < len(row) else ""
                self.assertEqual(shown.strip(), cell)
                self.assertTrue(not cell or (line[:end].endswith(cell) if at in right else shown.startswith(cell)))
            begin = end + 2

    @given(st.lists(st.lists(CELLS, min_size=3, max_size=3), min_size=1, max_size=4))
    def test_markdown(self, rows):
        lines = [*tables.markdown_head(rows[0]).split("\n"), *map(tables.markdown_row, rows[1:])]
        self.assertEqual(lines.pop(1), "|---|---|---|")
        self.assertEqual([[cell.strip() for cell in line[1:-1].split("|")] for line in lines], rows)

    def test_a_bar_in_a_cell_of_markdown_parts_none(self):
        self.assertEqual(tables.markdown_row(["(U|k)", 1]), r"| (U\|k) | 1 |")


# What stands in a list of the command line: words, quoted texts, lists of OpenFOAM
WORD = st.from_regex(r"[A-Za-z0-9.+$-]{1,5}", fullmatch=True)
QUOTED = st.text("ab,;()[]{} ", max_size=6).map(lambda text: f'"{text}"')
LISTED = st.recursive(st.one_of(WORD, QUOTED), lambda each: st.lists(each, max_size=3).map(lambda many: "(" + ", ".join(many) + ")"), max_leaves=5)


class Lists(unittest.TestCase):
    @given(st.lists(LISTED, min_size=1, max_size=5, unique=True), st.lists(st.sampled_from(("", " ", "  ")), min_size=6, max_size=6))
    def test_values_come_apart_where_they_were_put_together(self, values, gaps):
        text = ",".join(gap + value + gap for value, gap in zip(values, gaps))
        self.assertEqual(sweep_plan.listed(text), values)
        self.assertEqual(sweep_plan.settings([f"a/b = {text}"]), {"a/b": values})
