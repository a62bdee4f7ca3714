# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/compare finds the one number that differs, by particle and time.

Dumps and records are written by hand here, so that what must be found is known; LIGGGHTS's own dumps come at the end.
"""

import contextlib
import glob
import gzip
import io
import json
import math
import os
import shutil
import subprocess
import unittest

import h5py
import numpy
from hypothesis import given, strategies as st

from interphase import comparison, statistical_comparison
from interphase.commands import compare as compare_tool
from interphase.liggghts_dump import Dump
from interphase.matching_times import merged
from interphase.tree import TOOLS
from made_up import correlated
from scratch import InFolder, write_results, write_snapshots

SCRIPT = os.path.join(TOOLS, "compare")

COLUMNS = "id type x y z vx vy vz fx fy fz omegax omegay omegaz radius"
STEP = 1e-5
PARTICLES = 7
QUANTITIES = {"position", "velocity", "spin", "force", "diameter"}


def particles(step, count=PARTICLES):
    """Made-up particles [count, 15] in the order of COLUMNS; digits to the last bit."""
    random = numpy.random.default_rng(step + 1)
    table = random.uniform(0.001, 0.019, (count, 15))
    table[:, 0] = numpy.arange(1, count + 1)
    table[:, 1] = 1
    table[:, 14] = 0.0015
    return table


def dump_text(step, table, columns=COLUMNS, bounds="pp ff ff", form="%.17g", edge=0.02):
    lines = ["ITEM: TIMESTEP", str(step), "ITEM: NUMBER OF ATOMS", str(len(table)), f"ITEM: BOX BOUNDS {bounds}"]
    lines += [f"0 {edge}"] * 3 + [f"ITEM: ATOMS {columns} "]
    whole = {"id", "type"}
    for row in table:
        lines.append(" ".join(str(int(v)) if c in whole else form % v for c, v in zip(columns.split(), row)) + " ")
    return "\n".join(lines) + "\n"


STEPS = (0, 100, 200, 300)


class Folder(InFolder):
    def path(self, name):
        return os.path.join(self.root, name)

    def write(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)
        return self.path(name)

    def dump(self, name, tables=None, **how):
        tables = {step: particles(step) for step in STEPS} if tables is None else tables
        return self.write(name, "".join(dump_text(step, table, **how) for step, table in tables.items()))

    def run_folder(self, name, tables=None, solid_step=STEP, series=None):
        """A run of ours with the particles of a dump, its times as sums of steps, which carry round-off."""
        tables = {step: particles(step) for step in STEPS} if tables is None else tables
        if tables:
            columns = (("position", 2), ("velocity", 5), ("force", 8), ("angular_velocity", 11))
            write_snapshots(self.path(name), [(sum([STEP] * step), {
                "id": table[:, 0].astype(numpy.int32), "diameter": 2 * table[:, 14], **{each: table[:, at:at + 3] for each, at in columns},
            }) for step, table in tables.items()])  # fmt: skip
        write_results(self.path(name), series, **({} if solid_step is None else {"solid_step": solid_step}))
        return self.path(name)

    def compare(self, *given):
        """(exit code, report as a dict, text of errors)."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = compare_tool.main([*given, "--json"])
        report = json.loads(out.getvalue())
        self.assertEqual(report["exit_code"], code)
        return code, report, err.getvalue()

    def text(self, *given):
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            compare_tool.main(list(given))
        return out.getvalue()

    def quantity(self, report, name):
        return next(q for q in report["quantities"] if q["name"] == name)

    def assert_refused(self, *given, says=()):
        code, report, message = self.compare(*given)
        self.assertEqual(code, 2, message)
        self.assertEqual(report["verdict"], "cannot be compared")
        for words in says:
            self.assertIn(words, message)


class DumpAgainstDump(Folder):
    @given(st.lists(st.lists(st.floats(-8e307, 8e307), min_size=13, max_size=13), max_size=4), st.randoms(use_true_random=False))
    def test_every_number_is_read_as_it_was_written(self, rows, shuffle):
        table = numpy.array([[number, 1, *row] for number, row in enumerate(rows, 1)]).reshape(-1, 15)
        order = list(range(len(table)))
        shuffle.shuffle(order)
        frames = Dump("made up", [self.write("made_up", dump_text(7, table[order]))]).frames()
        frame = next(frames)
        state = frame.load()
        self.assertEqual((frame.step, state.ids.tolist()), (7, list(range(1, len(table) + 1))))
        for name, at in (("position", 2), ("velocity", 5), ("force", 8), ("spin", 11)):
            self.assertEqual(state.quantities[name].tobytes(), numpy.ascontiguousarray(table[:, at:at + 3]).tobytes(), name)
        self.assertEqual(state.quantities["diameter"].tobytes(), (2 * table[:, 14]).tobytes())

    def test_same_numbers_are_bit_equal(self):
        code, report, _ = self.compare(self.dump("a"), self.dump("b"))
        self.assertEqual((code, report["verdict"], report["common_times"]), (0, "bit-equal", 4))
        self.assertEqual({q["name"] for q in report["quantities"]}, {*QUANTITIES, "type"})

    def test_one_flipped_last_bit_is_found(self):
        for column, name in ((3, "position"), (7, "velocity"), (9, "force"), (13, "spin")):
            tables = {step: particles(step) for step in STEPS}
            before = tables[200][4, column]
            tables[200][4, column] = numpy.nextafter(before, 1)
            code, report, _ = self.compare(self.dump("a"), self.dump("b", tables))
            self.assertEqual((code, report["verdict"]), (1, "different"))
            found = self.quantity(report, name)
            self.assertEqual((found["particle"], found["at"], found["differing"]), (5, "timestep 200", 1))
            self.assertEqual((found["first_particle"], found["first"]), (5, "timestep 200"))
            self.assertEqual(found["largest"], numpy.nextafter(before, 1) - before)
            self.assertEqual([q["name"] for q in report["quantities"] if q["differing"]], [name])

    def test_last_bit_of_the_smallest_numbers_is_found(self):
        tables = {0: particles(0)}
        tables[0][:, 5:8] = 5e-324  # its square is 0
        other = {0: tables[0].copy()}
        other[0][2, 6] = 1e-323
        code, report, _ = self.compare(self.dump("a", tables), self.dump("b", other))
        self.assertEqual((code, self.quantity(report, "velocity")["particle"]), (1, 3))
        self.assertGreater(self.quantity(report, "velocity")["largest"], 0)

    def test_sign_of_zero_is_a_bit(self):
        tables, other = {0: particles(0)}, {0: particles(0)}
        tables[0][2, 8], other[0][2, 8] = 0.0, -0.0
        code, report, _ = self.compare(self.dump("a", tables), self.dump("b", other))
        self.assertEqual(code, 1)
        force = self.quantity(report, "force")
        self.assertEqual((force["particle"], force["largest"]), (3, 0))

    def test_relative_is_to_the_rms_of_both_sides_and_all_times(self):
        tables, other = {step: particles(step) for step in STEPS}, {step: particles(step) for step in STEPS}
        other[100][0, 5:8] += (0.3, 0.0, 0.4)
        velocity = numpy.concatenate([table[:, 5:8] for table in (*tables.values(), *other.values())])
        found = self.quantity(self.compare(self.dump("a", tables), self.dump("b", other))[1], "velocity")
        self.assertAlmostEqual(found["largest"], 0.5, places=12)
        rms = math.sqrt(numpy.mean(numpy.sum(velocity**2, axis=1)))
        self.assertAlmostEqual(found["relative"], 0.5 / rms, delta=1e-12 * found["relative"])

    def test_order_of_particles_and_columns_means_nothing(self):
        names = COLUMNS.split()
        order = numpy.random.default_rng(5).permutation(len(names))
        tables = {}
        for step in STEPS:
            table = particles(step)
            tables[step] = table[numpy.random.default_rng(step).permutation(len(table))][:, order]
        other = self.dump("b", tables, columns=" ".join(names[i] for i in order))
        self.assertEqual(self.compare(self.dump("a"), other)[0], 0)
        tables[300][0, list(order).index(5)] += 1e-9
        other = self.dump("b", tables, columns=" ".join(names[i] for i in order))
        code, report, _ = self.compare(self.dump("a"), other)
        self.assertEqual(code, 1)
        self.assertEqual(self.quantity(report, "velocity")["particle"], tables[300][0, list(order).index(0)])

    def test_a_lost_particle_is_a_difference(self):
        tables = {step: particles(step) for step in STEPS}
        tables[200] = numpy.delete(tables[200], 3, axis=0)
        code, report, _ = self.compare(self.dump("a"), self.dump("b", tables), "--tolerance", "1")
        self.assertEqual(code, 1)
        self.assertEqual(report["particles_only_in"]["A"], {"count": 1, "examples": ["4 at timestep 200"]})
        self.assertEqual(report["particles_only_in"]["B"]["count"], 0)
        self.assertFalse(any(q["differing"] for q in report["quantities"]))

    def test_times_of_one_side_are_told_and_count_on_demand(self):
        a, b = self.dump("a"), self.dump("b", {step: particles(step) for step in (100, 150, 300, 400)})
        code, report, _ = self.compare(a, b)
        self.assertEqual((code, report["common_times"]), (0, 2))
        self.assertEqual(report["times_only_in"]["A"], {"count": 2, "examples": ["timestep 0", "timestep 200"]})
        self.assertEqual(report["times_only_in"]["B"]["examples"], ["timestep 150", "timestep 400"])
        self.assertEqual(self.compare(a, b, "--same-times")[0], 1)
        self.assertEqual(self.compare(a, b, "--same-times", "--from", "300", "--until", "300")[0], 0)

    def test_from_skips_what_differs_before(self):
        tables = {step: particles(step) for step in STEPS}
        tables[100][0, 4] += 1e-3
        a, b = self.dump("a"), self.dump("b", tables)
        self.assertEqual(self.compare(a, b)[0], 1)
        self.assertEqual(self.compare(a, b, "--from", "200")[0], 0)
        self.assertEqual(self.compare(a, b, "--from", "0.0015", "--timestep", "1e-5")[0], 0)

    def test_only(self):
        tables = {step: particles(step) for step in STEPS}
        tables[100][0, 9] += 1
        a, b = self.dump("a"), self.dump("b", tables)
        self.assertEqual(self.compare(a, b, "--only", "position,velocity")[0], 0)
        self.assert_refused(a, b, "--only", "velocty", says=["velocty", "did you mean 'velocity'?"])

    def test_tolerances(self):
        tables = {step: particles(step) for step in STEPS}
        tables[100][0, 5] += 1e-6
        tables[200][1, 9] += 1e-3
        a, b = self.dump("a"), self.dump("b", tables)
        force = self.quantity(self.compare(a, b)[1], "force")
        self.assertEqual(self.compare(a, b, "--absolute", "1e-4")[0], 1)
        code, report, _ = self.compare(a, b, "--absolute", "2e-6", "--absolute", "force=2e-3")
        self.assertEqual((code, report["verdict"]), (0, "equal within tolerance"))
        self.assertEqual(self.compare(a, b, "--absolute", "velocity=2e-6")[0], 1)
        self.assertEqual(self.compare(a, b, "--tolerance", str(1.01 * force["relative"]))[0], 0)
        self.assertEqual(self.compare(a, b, "--tolerance", str(0.99 * force["relative"]))[0], 1)
        self.assertEqual(self.compare(a, b, "--tolerance", "0")[0], 1)
        self.assertIn("beyond", self.text(a, b, "--absolute", "1e-4"))

    def test_periodic_images(self):
        tables, other = {0: particles(0)}, {0: particles(0)}
        tables[0][2, 2], other[0][2, 2] = 0.02, 0.0
        code, report, _ = self.compare(self.dump("a", tables), self.dump("b", other))
        self.assertEqual((code, report["verdict"]), (0, "bit-equal up to periodic images"))
        self.assertEqual(self.quantity(report, "position")["periodic_images"], 1)
        # Not quite an image: what is left over is the difference.
        other[0][2, 2] = 1e-6
        code, report, _ = self.compare(self.dump("a", tables), self.dump("b", other))
        self.assertEqual(code, 1)
        self.assertAlmostEqual(self.quantity(report, "position")["largest"], 1e-6, delta=1e-17)
        self.assertIn("nearest image", self.text(self.dump("a", tables), self.dump("b", other)))
        # y has walls.
        other = {0: tables[0].copy()}
        tables[0][2, 3], other[0][2, 3] = 0.02, 0.0
        code, report, _ = self.compare(self.dump("a", tables), self.dump("b", other))
        self.assertEqual((code, self.quantity(report, "position")["largest"]), (1, 0.02))

    def test_nan_on_one_side_is_never_within_tolerance(self):
        tables, other = {0: particles(0)}, {0: particles(0)}
        other[0][5, 6] = math.nan
        a, b = self.dump("a", tables), self.dump("b", other)
        code, report, _ = self.compare(a, b, "--tolerance", "1e9", "--absolute", "1e9")
        self.assertEqual((code, self.quantity(report, "velocity")["particle"]), (1, 6))
        code, report, _ = self.compare(b, b)
        self.assertEqual((code, self.quantity(report, "velocity")["nan_on_both_sides"]), (0, 1))

    def test_few_digits_are_told(self):
        _, report, _ = self.compare(self.dump("a", form="%g"), self.dump("b", form="%g"))
        self.assertEqual(sum("shows 6 digits" in note for note in report["notes"]), 2)
        self.assertFalse(self.compare(self.dump("a"), self.dump("b"))[1]["notes"])

    def test_folder_pattern_and_gzip(self):
        whole = self.dump("whole", {step: particles(step) for step in (0, 200, 1000)})
        os.mkdir(self.path("post"))
        for step in (0, 200, 1000):  # sorted by name, 1000 would come before 200
            with gzip.open(self.path(f"post/dump{step}.liggghts.gz"), "wt") as file:
                file.write(dump_text(step, particles(step)))
        self.write("post/notes.txt", "not a dump")
        self.assertEqual(self.compare(whole, self.path("post"), "--same-times")[0], 0)
        self.assertEqual(self.compare(whole, self.path("post/dump*.gz"), "--same-times")[0], 0)
        self.assertEqual(self.compare(whole, self.path("post/dump200.liggghts.gz"))[1]["common_times"], 1)

    def test_columns_of_text_and_of_one_side_are_left_out(self):
        rows = dump_text(0, particles(0)).replace("omegaz radius", "omegaz radius element")
        rows = rows.replace("0015 \n", "0015 glass \n")
        self.assertEqual(rows.count("glass"), PARTICLES)
        a = self.write("a", rows)
        code, report, _ = self.compare(a, a)
        self.assertEqual(code, 0)
        self.assertTrue(any("text" in note and "element" in note for note in report["notes"]))
        names = COLUMNS.split()[:8]
        b = self.dump("b", {0: particles(0)[:, :8]}, columns=" ".join(names))
        code, report, _ = self.compare(self.dump("a"), b)
        self.assertEqual(code, 0)
        self.assertEqual(report["quantities_only_in"]["A"], ["diameter", "force", "spin"])

    def test_scaled_positions_are_positions(self):
        table = particles(0)
        scaled = table.copy()
        scaled[:, 2:5] /= 0.02
        b = self.dump("b", {0: scaled}, columns=COLUMNS.replace(" x y z", " xs ys zs"))
        self.assertEqual(self.compare(self.dump("a", {0: table}), b, "--absolute", "1e-17")[0], 0)

    def test_no_particles_at_a_time(self):
        tables = {0: numpy.zeros((0, 15)), 100: particles(100)}
        code, report, _ = self.compare(self.dump("a", tables), self.dump("b", tables))
        self.assertEqual((code, report["common_times"]), (0, 2))


class RunAgainstOthers(Folder):
    def test_run_and_its_native_dump_are_bit_equal(self):
        run, dump = self.run_folder("run"), self.dump("dump")
        for given in ((run, dump), (dump, run), (os.path.join(run, "particles.h5"), dump)):
            code, report, _ = self.compare(*given)
            self.assertEqual((code, report["verdict"], report["common_times"]), (0, "bit-equal", 4))
        self.assertEqual({q["name"] for q in report["quantities"]}, QUANTITIES)

    def test_flipped_bit_names_particle_time_and_step(self):
        tables = {step: particles(step) for step in STEPS}
        tables[300][6, 12] = numpy.nextafter(tables[300][6, 12], 0)
        found = self.quantity(self.compare(self.run_folder("run"), self.dump("dump", tables))[1], "spin")
        self.assertEqual((found["particle"], found["at"]), (7, "t = 0.003 s, timestep 300"))

    def test_two_runs(self):
        tables = {step: particles(step) for step in STEPS}
        series = {"time": [0.0, 0.1, 0.2], "pressure_drop": [1.0, 2.0, 3.0], "taps": numpy.ones((3, 2))}
        a, b = self.run_folder("a", series=series), self.run_folder("b", series=series)
        code, report, _ = self.compare(a, b)
        self.assertEqual(code, 0)
        self.assertIn("series/taps[1]", [q["name"] for q in report["quantities"]])
        series["pressure_drop"] = [1.0, 2.5, 3.0]
        c = self.run_folder("c", tables, series=series)
        code, report, _ = self.compare(a, c)
        self.assertEqual(code, 1)
        found = self.quantity(report, "series/pressure_drop")
        self.assertEqual((found["at"], found["largest"], found["particle"]), ("t = 0.1 s", 0.5, None))
        self.assertEqual(self.compare(a, c, "--only", "position,series/taps[0]")[0], 0)
        self.assertEqual(self.compare(*(os.path.join(x, "results.h5") for x in (a, c)))[0], 1)

    def test_solid_step_is_needed_and_can_be_given(self):
        run, dump = self.run_folder("run", solid_step=None), self.dump("dump")
        self.assert_refused(run, dump, says=["solid_step", "--timestep DT"])
        self.assertEqual(self.compare(run, dump, "--timestep", "1e-5")[0], 0)
        late = self.dump("late", {17: particles(0)})
        self.assert_refused(run, late, "--timestep", "1e-5", says=["no time in common", "timestep 17"])


class BadInput(Folder):
    def test_paths(self):
        a = self.dump("a")
        self.assert_refused(a, self.path("none"), says=["B = ", "no such file"])
        self.assert_refused(self.path("n*ne"), a, says=["A = ", "no dump file matches"])
        self.assert_refused(a, self.write("empty", ""), says=["empty"])
        self.assert_refused(a, self.write("vtk", "# vtk DataFile Version 2.0\n"), says=["VTK"])
        os.mkdir(self.path("folder"))
        self.assert_refused(a, self.path("folder"), says=["particles.h5"])
        with h5py.File(self.path("other.h5"), "w"):
            pass
        self.assert_refused(a, self.path("other.h5"), says=["/snapshots"])

    def test_dumps(self):
        a, text = self.dump("a"), dump_text(0, particles(0))
        lines = text.split("\n")
        words = lines[10].split()
        cases = {
            "no column `id`": text.replace("ATOMS id type", "ATOMS nr type"),
            "the file ends after 5": "\n".join(lines[:14]) + "\n",
            "ends in the heading of timestep 0": "\n".join(lines[:4]) + "\n",
            "line 10: 15 values expected": "\n".join([*lines[:9], "1 1 0.5", *lines[10:]]),
            "line 11: column vy: a number expected, found 'oops'":
                "\n".join([*lines[:10], " ".join([*words[:6], "oops", *words[7:]]), *lines[11:]]),
            "particle id 1 occurs more than once": "\n".join([*lines[:10], lines[9], *lines[11:]]),
            "time steps must ascend": text + text,
            "line 2: a time step expected, found 'zero'": text.replace("TIMESTEP\n0", "TIMESTEP\nzero"),
            "triclinic": text.replace("BOX BOUNDS", "BOX BOUNDS xy xz yz"),
            "more particles than NUMBER OF ATOMS": text.replace("ATOMS\n7", "ATOMS\n6"),
            "dump custom": text.replace("NUMBER OF ATOMS", "NUMBER OF ENTRIES"),
        }
        for message, content in cases.items():
            with self.subTest(message):
                self.assert_refused(a, self.write("bad", content), says=[message, self.path("bad")])
        for count in (PARTICLES, 30000):  # damaged in the heading's buffer, and among the particles
            packed = gzip.compress(dump_text(0, particles(0, count)).encode(), 1)
            with open(self.path("bad.gz"), "wb") as file:
                file.write(packed[:len(packed) // 2])
            self.assert_refused(a, self.path("bad.gz"), says=["damaged", self.path("bad.gz"), "line"])

    def test_nothing_in_common(self):
        a = self.dump("a")
        self.assert_refused(a, self.dump("late", {7: particles(7)}), says=["no time in common", "timestep 7"])
        strangers = particles(0)
        strangers[:, 0] += 100
        self.assert_refused(a, self.dump("ids", {0: strangers}), says=["no particle in common"])
        ids_alone = self.dump("columns", {0: particles(0)[:, :1]}, columns="id")
        self.assert_refused(a, ids_alone, says=["no quantity in common"])
        self.assert_refused(self.run_folder("empty", tables={}), a, "--timestep", "1", says=["no records in common"])

    def test_records(self):
        run, dump = self.run_folder("run"), self.dump("dump")
        path = os.path.join(run, "particles.h5")
        with h5py.File(path, "a") as file:
            del file["snapshots/000001/velocity"]
            file["snapshots/000001/velocity"] = numpy.zeros((2, 3))
        self.assert_refused(run, dump, says=["/snapshots/000001", "velocity", "(2, 3)", "(7, 3)"])
        with h5py.File(path, "a") as file:
            del file["snapshots/000001"].attrs["time"]
        self.assert_refused(run, dump, says=["/snapshots/000001", "time"])
        with open(path, "r+b") as file:
            file.truncate(600)
        self.assert_refused(run, dump, says=[path, "killed"])
        self.assert_refused(self.run_folder("negative", solid_step=-1.0), dump, says=["solid_step", "-1.0"])

    def test_options(self):
        a = self.dump("a")
        self.assert_refused(a, says=["required: B"])
        self.assert_refused(a, a, "--tolerance", "-1", says=["--tolerance -1"])
        self.assert_refused(a, a, "--tolerance", "speed=1", says=["speed"])
        self.assert_refused(a, a, "--timestep", "0", says=["'0' is not a number above 0"])
        self.assert_refused(a, a, "--from", "2", "--until", "1", says=["--from 2"])
        self.assert_refused(a, a, "--confidence", "0.9", says=["--statistics"])
        self.assert_refused(a, a, "--statistics", "--confidence", "95", says=["between 0 and 1"])
        self.assert_refused(a, a, "--statistics", "--tolerance", "1", says=["--tolerance"])


class Statistics(Folder):
    def chaotic(self, name, seed, shift=0.0, count=2000):
        random = numpy.random.default_rng(seed)
        pressure = 1000 + shift + 50 * correlated(random, [0.9], count)
        height = 0.1 + 0.01 * correlated(random, [0.8], count)
        time = 0.05 * numpy.arange(count)
        return self.run_folder(name, {}, series={"time": time, "pressure_drop": pressure, "bed_height": height})

    def test_same_flow(self):
        code, report, _ = self.compare(self.chaotic("a", 1), self.chaotic("b", 2), "--statistics")
        self.assertEqual((code, report["verdict"]), (0, "statistically indistinguishable"))
        self.assertEqual(self.compare(self.chaotic("c", 1), self.path("b"))[0], 1)  # number by number they differ

    def test_shifted_flow_is_told_by_quantity(self):
        # The error of each mean is 50 * 10 / sqrt(2000) = 11; 100 is 6 standard errors of the difference.
        a, b = self.chaotic("a", 1), self.chaotic("b", 2, shift=100)
        code, report, _ = self.compare(a, b, "--statistics")
        self.assertEqual(code, 1)
        verdicts = {row["name"]: row["verdict"] for row in report["statistics"]}
        self.assertEqual(verdicts, {"series/pressure_drop": "different", "series/bed_height": "indistinguishable"})
        self.assertEqual(self.compare(a, b, "--statistics", "--only", "series/bed_height")[0], 0)
        self.assertIn("99 % confidence", self.text(a, b, "--statistics"))

    def test_start_up_is_skipped(self):
        a, b = self.chaotic("a", 1), self.chaotic("b", 2)
        with h5py.File(os.path.join(b, "results.h5"), "a") as file:
            file["series/pressure_drop"][:100] += 5000
        self.assertEqual(self.compare(a, b, "--statistics", "--from", "5")[0], 0)
        _, report, _ = self.compare(a, b, "--statistics")
        self.assertNotEqual(report["statistics"][1]["verdict"], "indistinguishable")

    def test_too_short_to_judge(self):
        a, b = self.chaotic("a", 1, count=15), self.chaotic("b", 2, count=15)
        code, report, _ = self.compare(a, b, "--statistics")
        self.assertEqual((code, report["verdict"]), (3, "cannot be judged"))
        self.assertIn("15 samples", report["statistics"][0]["reason"])
        self.assertIn("both need about", " ".join(report["notes"]))

    def record(self, name, **series):
        count = len(next(iter(series.values())))
        return self.run_folder(name, {}, series={"time": 0.05 * numpy.arange(1, count + 1), **series})

    def test_constants_do_not_count(self):
        """Three constants that agree say nothing of a flow whose pressure drop is too short a record to be judged."""
        random = numpy.random.default_rng(3)
        sides = [
            self.record(name, particles=numpy.full(15, 7.0), mass=1 + 1e-14 * random.standard_normal(15), came=numpy.zeros(15),
                        pressure_drop=random.standard_normal(15))
            for name in "ab"
        ]
        code, report, _ = self.compare(*sides, "--statistics")
        self.assertEqual(code, 3, report)
        verdicts = {row["name"].split("/")[1]: row["verdict"] for row in report["statistics"]}
        self.assertEqual([verdicts[name] for name in ("particles", "mass", "came")], ["constant"] * 3)
        lost = self.record("c", particles=numpy.full(15, 6.0))
        self.assertEqual(self.compare(sides[0], lost, "--statistics")[0], 1)
        self.assertEqual(self.compare(sides[0], self.record("d", particles=numpy.full(15, 7.0)), "--statistics")[0], 3)

    def test_energies_ten_times_apart_are_never_alike(self):
        """Records that drift or are short: their errors are unknown, but all of the one lies above all of the other."""
        random = numpy.random.default_rng(4)
        steady = {side: correlated(random, [0.3], 60) for side in "ab"}
        pair = []
        for side, size in (("a", 1), ("b", 0.1)):
            drift = 1 + 0.04 * correlated(random, [0.98], 60)  # 60 samples, autocorrelation time 50; deviation 0.2
            slow = 1 + 0.05 * correlated(random, [0.78], 60)
            pair.append(self.record(side, kinetic_energy=size * drift, spin=size * slow, pressure_drop=steady[side]))
        code, report, _ = self.compare(*pair, "--statistics", "--only", "series/kinetic_energy,series/pressure_drop")
        rows = {row["name"]: row for row in report["statistics"]}
        self.assertEqual((code, rows["series/pressure_drop"]["verdict"]), (3, "indistinguishable"), report)
        self.assertTrue(rows["series/kinetic_energy"]["ranges_apart"])
        self.assertIn("ranges apart, ", self.text(*pair, "--statistics"))
        # Worth seven and three samples: 2 of 120 orders keep them apart, enough at 95 %, not at 99 %.
        for confidence, expected in (("0.95", 1), ("0.99", 3)):
            code, report, _ = self.compare(*pair, "--statistics", "--only", "series/spin", "--confidence", confidence)
            self.assertEqual((code, report["statistics"][0]["verdict"]), (expected, "differ grossly"), report)

    def verdicts(self, phi, count, quantities, pairs, shift=0.0):
        """How many of `pairs` end by each exit code at 95 %: AR series, one of the quantities shifted by `shift` errors."""
        random = numpy.random.default_rng(11)
        spread = math.sqrt(2 / count) / (1 - sum(phi))  # of the difference of two means
        codes = []
        for _ in range(pairs):
            a, b = ({str(at): correlated(random, phi, count) for at in range(quantities)} for _ in "ab")
            b["0"] = b["0"] + shift * spread
            codes.append(comparison.judged_means(statistical_comparison.compare(a, b, 0.95))[0])
        return {code: codes.count(code) for code in set(codes)}

    def test_one_flow_is_called_different_as_rarely_as_stated(self):
        """20 quantities at 95 % for all together: 5 of 100 pairs are expected at most, deviation 2.2; 11 are 2.8 of these above.
        Decaying, slugging (a damped oscillation of 20 samples), and records too short for their own motions."""
        for phi, count in (([0.9], 600), ([1.8, -0.9], 800), ([0.9], 50), ([0.98], 100)):
            found = self.verdicts(phi, count, 20, 100)
            self.assertLessEqual(found.get(1, 0), 11, (phi, count, found))
            # The first two are long enough to be judged, the others are not and must not read as alike.
            self.assertGreaterEqual(found.get(0 if count > 100 else 3, 0), 85, (phi, count, found))

    def test_differences_are_found(self):
        """Three standard errors: Student's test at 5 % finds 75 % of them with 8 degrees of freedom, the fewest there are. Among 20 quantities, at 0.25 %,
        six errors are found in 92 %. Less three binomial deviations of the pairs: 34 of 60 and 23 of 30."""
        for phi in ([0.9], [1.8, -0.9]):
            self.assertGreater(self.verdicts(phi, 2000, 1, 60, shift=3)[1], 34, phi)
            self.assertGreater(self.verdicts(phi, 2000, 20, 30, shift=6)[1], 23, phi)

    def test_nan_in_one_run_is_a_difference(self):
        a, b = self.chaotic("a", 1), self.chaotic("b", 2)
        with h5py.File(os.path.join(b, "results.h5"), "a") as file:
            file["series/bed_height"][7] = math.nan
        self.assertEqual(self.compare(a, b, "--statistics")[0], 1)

    def snapshots(self, seed, lift=0.0):
        random = numpy.random.default_rng(seed)
        tables = {}
        common = correlated(random, [0.5], 100)
        for i in range(100):
            table = particles(0, 50)
            table[:, 2:14] = random.standard_normal((50, 12))
            table[:, 7] += lift + common[i]  # vertical velocity: all particles move together
            tables[100 * i] = table
        return tables

    def test_particle_snapshots(self):
        a, b = self.dump("a", self.snapshots(1)), self.run_folder("b", self.snapshots(2))
        c = self.dump("c", self.snapshots(3, lift=3))
        code, report, _ = self.compare(a, b, "--statistics")
        rows = {row["name"]: row for row in report["statistics"]}
        self.assertEqual(code, 0, rows)
        # The common motion limits what a mean knows: 2 / sqrt(100), not 1 / sqrt(50 * 100).
        self.assertAlmostEqual(rows["particles/mean_vertical_velocity [m/s]"]["a"]["error"], 0.2, delta=0.06)
        code, report, _ = self.compare(a, c, "--statistics")
        different = {row["name"].split(" ")[0] for row in report["statistics"] if row["verdict"] == "different"}
        self.assertEqual(code, 1)
        self.assertTrue({"particles/mean_vertical_velocity", "particles/vertical_velocity_quantile_50%"} <= different)
        self.assertTrue(any(name.startswith("profile/moving_up") for name in different))
        self.assertNotIn("particles/mean_height", different)


class Merging(unittest.TestCase):
    @given(*2 * [st.sets(st.integers(0, 60)).map(sorted)], st.integers(0, 3))
    def test_each_item_comes_once_in_order(self, a, b, slack):
        a, b = ([(slack + 1) * 2 * each for each in items] for items in (a, b))  # of one side none within the slack
        b = [each + slack for each in b]
        pairs = list(merged(a, b, lambda each: each, lambda key: slack))
        self.assertEqual([left for left, _ in pairs if left is not None], a)
        self.assertEqual([right for _, right in pairs if right is not None], b)
        self.assertEqual([left for left, right in pairs if None not in (left, right)], [each for each in a if each + slack in b])

    def test_pairs_within_slack_in_order(self):
        pairs = list(merged([0.0, 1.0, 2.0], [1.0 + 1e-12, 1.5, 2.0], lambda x: x, lambda x: 1e-9))
        self.assertEqual(pairs, [(0.0, None), (1.0, 1.0 + 1e-12), (None, 1.5), (2.0, 2.0)])
        self.assertEqual(list(merged([], [3], lambda x: x, lambda x: 0)), [(None, 3)])


class Program(Folder):
    def execute(self, *given):
        return subprocess.run([SCRIPT, *given], capture_output=True, text=True)

    def test_exit_codes_and_first_line(self):
        tables = {step: particles(step) for step in STEPS}
        tables[100][0, 5] += 1e-6
        a, b = self.dump("a"), self.dump("b", tables)
        for given, code, line in (
            ((a, a), 0, "bit-equal"),
            ((a, b), 1, "different"),
            ((a, b, "--tolerance", "1"), 0, "equal within tolerance"),
        ):
            done = self.execute(*given)
            self.assertEqual((done.returncode, done.stdout.split("\n")[0], done.stderr), (code, line, ""))
        done = self.execute(a, self.path("none"))
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("none", done.stderr)

    def test_help_tells_exit_codes_and_shows_examples(self):
        done = self.execute("--help")
        self.assertEqual(done.returncode, 0)
        for words in ("exit code:", "examples:", "--statistics", "--tolerance", "bit-equal"):
            self.assertIn(words, done.stdout)


LIGGGHTS = shutil.which("liggghts")

COLLISIONS = """atom_style granular
atom_modify map array sort 0 0
boundary p f f
newton off
communicate single vel yes
units si
region box block 0 0.02 0 0.02 0 0.03 units box
create_box 1 box
neighbor 0.001 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.8
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
pair_style gran model hertz tangential history
pair_coeff * *
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix front all wall/gran model hertz tangential history primitive type 1 yplane 0.0
fix back all wall/gran model hertz tangential history primitive type 1 yplane 0.02
fix weight all gravity 9.81 vector 0.0 0.0 -1.0
create_atoms 1 single 0.001 0.010 0.010
create_atoms 1 single 0.003 0.0102 0.0125
create_atoms 1 single 0.010 0.010 0.005
create_atoms 1 single 0.012 0.011 0.008
set group all diameter 0.003 density 1100 vx -0.3 vy 0.05 vz -0.5
group one id 2
set group one vx SPEED
timestep 1e-5
fix move all nve/sphere
dump d all custom 200 particles.dump id type x y z vx vy vz fx fy fz omegax omegay omegaz radius
dump_modify d format "%d %d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
dump p all custom 1000 post*.dump id x y z vx vy vz
run 2000
"""


@unittest.skipUnless(LIGGGHTS, "liggghts is not installed")
class NativeLiggghts(Folder):
    """Four particles that collide, leave through a periodic side and bounce, 2,000 steps."""

    def native(self, name, speed="-0.6"):
        os.mkdir(self.path(name))
        with open(self.path(f"{name}/in.collisions"), "w") as file:
            file.write(COLLISIONS.replace("SPEED", speed))
        environment = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        done = subprocess.run([LIGGGHTS, "-in", "in.collisions"], cwd=self.path(name), env=environment,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])
        return self.path(f"{name}/particles.dump")

    def test_one_script_twice_is_bit_equal(self):
        a, b = self.native("a"), self.native("b")
        code, report, _ = self.compare(a, b, "--same-times")
        self.assertEqual((code, report["verdict"], report["common_times"]), (0, "bit-equal", 11))
        with open(a) as file:
            table = numpy.array([line.split() for line in file if len(line.split()) == 15], dtype=float)
        self.assertGreater(numpy.ptp(table[:, 2]), 0.015)  # the periodic side was crossed
        self.assertGreater(table[:, 7].max(), 0.1)  # the floor was hit
        self.assertGreater(numpy.abs(table[:, 13]).max(), 1)  # and so did particles: the floor gives no spin about z

    def test_last_bit_at_the_start_is_found(self):
        a, b = self.native("a"), self.native("b", speed="-0.6000000000000001")
        code, report, _ = self.compare(a, b)
        found = self.quantity(report, "velocity")
        self.assertEqual((code, found["first"], found["first_particle"]), (1, "timestep 0", 2))

    def test_files_per_step_show_fewer_digits(self):
        a = self.native("a")
        pattern = self.path("a/post*.dump")
        self.assertTrue(glob.glob(pattern))
        code, report, _ = self.compare(a, pattern, "--tolerance", "1e-5")
        self.assertEqual((code, report["common_times"]), (0, 3))
        self.assertTrue(any("6 digits" in note for note in report["notes"]))
