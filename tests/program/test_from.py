# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 600
"""A run with the bed of another (tools/run --from): particles are those of the snapshot to the last bit, the gas that of the same
time under the new case's boundaries, and what does not fit is refused with the reason."""

import os
import shutil

import numpy
import starting_runs
import support
from starting_runs import COUNT, DENSITY, DEPTH, DIAMETER, WIDTH, record, run, series, snapshots

from interphase import foam_field

STATE = ("id", "position", "velocity", "angular_velocity", "diameter")


def cells(folder, time, name):
    """Values of a field's cells, as text with every digit."""
    return foam_field.internal_values(os.path.join(folder, time, name))


def numbers(text):
    """The rows of such a text."""
    rows = text[text.index("(\n") + 2 : text.rindex("\n)")].replace("(", " ").replace(")", " ").splitlines()
    return numpy.array([row.split() for row in rows], dtype=float)


class StartingRuns(support.ProgramTest):
    """`bed`: the case; `hard` and `soft`: runs of it, TDHS (W = 1) until 0.1 s and CGPM (W = 8) until 0.04 s."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.bed = starting_runs.case(cls.shared)
        cls.hard, cls.soft = (os.path.join(cls.shared, name) for name in ("hard", "soft"))
        for out, words in ((cls.hard, ("TDHS", "--weight", "1", "--until", "0.1")), (cls.soft, ("CGPM", "--weight", "8", "--until", "0.04"))):
            done = run(cls.bed, out, "--method", *words)
            if done.returncode != 0:
                raise AssertionError(done.stdout + done.stderr)

    def start(self, start, *words, case=None, name="new", until="0.005", **changes):
        """The folder of a run from `start`, and what tools/run said."""
        out = os.path.join(self.root, name)
        done = run(case or self.bed, out, "--from", start, "--until", until, *words, **changes)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return out, done.stdout + done.stderr

    def refused(self, start, *words, case=None, **changes):
        """What is said of a start that is refused."""
        out = os.path.join(self.root, f"refused-{len(os.listdir(self.root))}")
        done = run(case or self.bed, out, "--from", start, *words, program="true", **changes)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done.stderr

    def same_particles(self, old, new):
        """The first snapshot of `new` is the last of `old`, or that at a time: (folder, time)."""
        folder, time = old if isinstance(old, tuple) else (old, None)
        known = snapshots(folder)
        before = known[-1][1] if time is None else min(known, key=lambda each: abs(each[0] - time))[1]
        at, after = snapshots(new)[0]
        self.assertEqual(at, 0)
        for name in STATE:
            numpy.testing.assert_array_equal(after[name], before[name], name)

    def same_particles_are_read(self, old, new):
        """What read_data finds in `new` is the last snapshot of `old`."""
        before = snapshots(old)[-1][1]
        atoms, velocities = support.read(new, "dem/bed.data").split("Atoms\n\n")[1].split("\nVelocities\n\n")
        atoms, velocities = (numpy.array([line.split() for line in text.splitlines()], dtype=float) for text in (atoms, velocities))
        for name, rows in (("id", atoms[:, 0]), ("diameter", atoms[:, 2]), ("position", atoms[:, 4:]), ("velocity", velocities[:, 1:4]),
                           ("angular_velocity", velocities[:, 4:])):  # fmt: skip
            numpy.testing.assert_array_equal(rows, before[name], name)
        numpy.testing.assert_array_equal(atoms[:, 3], DENSITY)

    def books_begin_alike(self, old, new):
        """Number, mass and momentum of the particles: sums over the same numbers, in another order."""
        def sums(snapshot):
            mass = DENSITY * numpy.pi / 6 * snapshot["diameter"] ** 3
            return len(mass), mass.sum(), (mass[:, None] * snapshot["velocity"]).sum(axis=0).tolist()

        self.assertEqual(sums(snapshots(old)[-1][1]), sums(snapshots(new)[0][1]))


class TestOtherMethods(StartingRuns):
    def test_springs_begin_where_hard_spheres_were(self):
        new, said = self.start(self.hard, "--method", "DEM", "--weight", "1", until="0.04")
        self.same_particles(self.hard, new)
        self.books_begin_alike(self.hard, new)
        self.assertIn(f"from {self.hard}/particles.h5:/snapshots/000010 (t = 0.1 s): {COUNT} spheres", said)
        self.assertEqual(series(new, "time")[0], 0)  # its clock began anew
        self.assertAlmostEqual(series(new, "time")[1], 1e-3, delta=1e-9)  # after the first gas step
        # The bed has fallen and rests. Springs give under its weight; what that sets free is weight times settling, some 1e-3 d (the
        # weight of 12 layers over springs of 800 N/m, summed). A hundredth of a diameter is ten times that.
        weight = COUNT * DENSITY * numpy.pi / 6 * DIAMETER**3 * 9.81
        before = series(self.hard, "kinetic_energy")
        self.assertLess(series(new, "kinetic_energy").max(), before[-1] + 0.01 * DIAMETER * weight)
        self.assertLess(0.01 * DIAMETER * weight, 0.1 * before.max())

    def test_provenance(self):
        new, _ = self.start(self.hard, "--method", "DEM", "--weight", "1")
        told = record(new)["from"]
        self.assertEqual((told["run"], told["method"], told["weight"], told["particles"]), (self.hard, "TDHS", 1, COUNT))
        self.assertAlmostEqual(told["time"], 0.1, delta=1e-9)
        self.assertEqual(len(told["results_sha256"]), 64)
        self.assertIn("U, p_rgh, phi", told["gas"])
        scene = os.path.join(self.root, "scene")
        support.write(scene, "overlaps { shares (0.01); percentiles (50); }\n")
        done = support.tool("report", new, "--scene", scene, "--no-write")
        self.assertIn(f"note: new: starts from t = 0.1 s of {self.hard} (TDHS, results.h5 of sha256 {told['results_sha256'][:12]})", done.stdout + done.stderr)

    def test_parcels_of_the_same_weight(self):
        for method in ("MPPIC", "CGHS"):
            with self.subTest(method):
                new, _ = self.start(self.soft, "--method", method, "--weight", "8", name=method)
                self.same_particles_are_read(self.soft, new)
                if method == "MPPIC":  # hard spheres that touch collide before the first snapshot
                    self.same_particles(self.soft, new)
                    self.books_begin_alike(self.soft, new)

    def test_other_weights_are_refused(self):
        message = self.refused(self.hard, "--method", "CGHS", "--weight", "8")
        self.assertIn("stand for 1 particles each, and bed has weight 8", message)
        self.assertIn("parcels can neither be split nor joined", message)
        self.assertIn("give --weight 8 with --method CGPM, CGHS or MPPIC", self.refused(self.soft, "--method", "DEM"))

    def test_springs_are_not_started_on_overlaps_that_burst(self):
        """Parcels of MP-PIC lie in one another; hard spheres part them."""
        through, _ = self.start(self.soft, "--method", "MPPIC", "--weight", "8", name="guided", until="0.15")
        message = self.refused(through, "--method", "CGPM", "--weight", "8")
        self.assertRegex(message, r"\d+ pairs of .* overlap by more than 20 % of a radius")
        self.assertIn(f"--method CGHS --from {through}@0.15", message)
        parted, _ = self.start(through, "--method", "CGHS", "--weight", "8", name="parted", until="0.1")
        new, _ = self.start(parted, "--method", "CGPM", "--weight", "8", until="0.02")
        weight = COUNT * DENSITY * numpy.pi / 6 * DIAMETER**3 * 9.81
        self.assertLess(series(new, "kinetic_energy").max(), series(parted, "kinetic_energy")[-1] + 0.01 * 2 * DIAMETER * weight)


class TestGas(StartingRuns):
    def test_the_same_mesh_takes_the_cells_values_and_keeps_the_new_inlet(self):
        new, _ = self.start(self.soft + "@0.02", "--weight", "8", inletVelocity=0.6)
        self.same_particles((self.soft, 0.02), new)
        for name in ("U", "p_rgh", "phi"):
            self.assertEqual(cells(new, "0", name), cells(self.soft, "0.02", name), name)
        self.assertRegex(support.read(new, "0/U"), r"inlet\s*\{\s*type\s+fixedValue;\s*value\s+uniform \(0 0 \$inletVelocity\)")

    def test_what_boundaries_take_from_the_cells_is_the_case_s_own_value(self):
        case = starting_runs.case(self.root, "macro")
        self.edit(case, "0/U", r"value   uniform \(0 0 \$inletVelocity\);", "value   $internalField;", count=2)
        new, _ = self.start(self.soft, "--weight", "8", case=case)
        self.assertEqual(cells(new, "0", "U"), cells(self.soft, "0.04", "U"))

    def test_another_level_of_the_pressure_changes_nothing(self):
        """Only gradients count: the same start under an outlet at 0 Pa."""
        drops = {}
        for outlet in (101325, 0):
            new, said = self.start(self.soft, "--weight", "8", name=f"outlet-{outlet}", outletPressure=outlet)
            drops[outlet] = series(new, "pressure_drop")
            self.assertEqual("p_rgh moved by -101325 Pa" in said, outlet == 0)
        # Digits of 1e5 Pa: 1.5e-11; the first step would be wrong by the whole drop without the level
        numpy.testing.assert_allclose(drops[0], drops[101325], atol=1e-5)

    def test_another_mesh_of_the_vessel(self):
        case = starting_runs.case(self.root, "fine", cells="(16 8 32)")
        new, said = self.start(self.soft, "--weight", "8", case=case)
        self.same_particles(self.soft, new)
        self.assertIn("interpolated to another mesh by mapFields: U, p_rgh", said)
        old, mapped = numbers(cells(self.soft, "0.04", "U")), numbers(cells(new, "0", "U"))
        self.assertEqual((len(old), len(mapped)), (8 * 4 * 16, 16 * 8 * 32))
        # Each old cell holds eight new ones. The mean flow upwards is that of the inlet over the voidage; what interpolation changes of it is
        # of the second order in the cells: a few per cent.
        self.assertAlmostEqual(mapped[:, 2].mean(), old[:, 2].mean(), delta=0.05 * old[:, 2].mean())
        fine = mapped[:, 2].reshape(16, 2, 4, 2, 8, 2).mean(axis=(1, 3, 5)).ravel()
        self.assertGreater(numpy.corrcoef(fine, old[:, 2])[0, 1], 0.95)

    def test_gas_that_is_torn(self):
        torn = os.path.join(self.root, "torn")
        shutil.copytree(self.soft, torn)
        field = os.path.join(torn, "0.04/U")
        os.truncate(field, os.path.getsize(field) // 2)
        message = self.refused(torn, "--weight", "8")
        self.assertIn("0.04/U: its 512 values are not all there: the file is torn; take another time", message)
        self.start(torn + "@0.02", "--weight", "8")

    def test_a_run_that_started_from_another_goes_on(self):
        """A checkpoint and what is read anew go together."""
        case = starting_runs.case(self.root, "kept")
        coupling = os.path.join(case, "system/couplingDict")
        support.write(coupling, support.read(coupling) + "\ncheckpoint { interval 0.005; }\n")
        new, _ = self.start(self.soft, "--weight", "8", case=case)
        done = starting_runs.plain(case, new, "--resume", "--until", "0.01")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("Reached t = 0.01 s", done.stdout)
        self.assertEqual(record(new)["from"]["run"], self.soft)

    def test_a_time_at_which_no_gas_was_written(self):
        new, said = self.start(self.soft + "@0.03", "--weight", "8")
        self.same_particles((self.soft, 0.03), new)
        self.assertIn("the gas starts from the case's own 0/: ", said)
        self.assertIn("wrote none at t = 0.03 s, but at 0.02, 0.04 s", said)
        self.assertIn("uniform (0 0 $inletVelocity)", support.read(new, "0/U"))

    def test_ranks(self):
        """Two from one, and one from the parts of two."""
        two, _ = self.start(self.soft, "--weight", "8", "--ranks", "2", name="two", until="0.02")
        self.same_particles(self.soft, two)
        whole = numbers(cells(two, "0.02", "U"))
        for name in ("0.02", "0.01"):
            shutil.rmtree(os.path.join(two, name), ignore_errors=True)
        new, said = self.start(two, "--weight", "8", name="one")
        self.same_particles(two, new)
        self.assertIn("on the same mesh: U, p_rgh, phi", said)
        numpy.testing.assert_array_equal(numbers(cells(new, "0", "U")), whole)
        self.assertFalse(os.path.exists(os.path.join(two, "0.02")), "the run that is started from stays as it is")


class TestRefusals(StartingRuns):
    def test_what_is_no_run(self):
        self.assertIn("no such folder", self.refused(os.path.join(self.root, "nowhere")))
        os.mkdir(os.path.join(self.root, "empty"))
        self.assertIn("there is no particles.h5 in it", self.refused(os.path.join(self.root, "empty")))
        self.assertIn("'soon' is no time in s", self.refused(self.soft + "@soon"))

    def test_a_time_without_snapshot_gets_the_nearest(self):
        message = self.refused(self.soft + "@0.0123", "--weight", "8")
        self.assertIn("no whole snapshot at t = 0.0123 s; the nearest is at 0.01 s", message)

    def test_a_torn_last_snapshot_is_passed_over(self):
        torn = os.path.join(self.root, "torn")
        shutil.copytree(self.soft, torn)
        last = os.path.join(torn, "snapshots/000004.h5")
        os.truncate(last, os.path.getsize(last) // 2)
        new, said = self.start(torn, "--weight", "8")
        self.assertIn("snapshot 000004 is torn", said)
        self.assertAlmostEqual(record(new)["from"]["time"], 0.03, delta=1e-9)

    def test_a_vessel_that_does_not_hold_them(self):
        x = snapshots(self.soft)[-1][1]["position"][:, 0]
        message = self.refused(self.soft, "--weight", "8", width=WIDTH / 2, depth=2 * DEPTH, inletVelocity=0.4)
        self.assertIn(f"{(x >= WIDTH / 2).sum()} of {COUNT // 8} particles of", message)
        self.assertIn("are outside of the box of dem/bed.data in bed", message)

    def test_other_spheres(self):
        message = self.refused(self.soft, "--weight", "8", diameter=1.9e-3)
        self.assertIn("have another diameter than those of bed: 0.004 m, and dem/bed.data has 0.0038", message)
        self.assertIn("another density", self.refused(self.soft, "--weight", "8", particleDensity=1000))

    def test_a_clock_that_does_not_begin_at_0(self):
        case = starting_runs.case(self.root, "late")
        self.set_entry(case, "system/controlDict", "startTime", 0.5)
        self.assertIn("late begins at startTime 0.5 s", self.refused(self.soft, "--weight", "8", case=case))
        self.set_entry(case, "system/controlDict", "startFrom", "latestTime")
        os.mkdir(os.path.join(case, "0.3"))
        self.assertIn("a time folder that it has, 0.3", self.refused(self.soft, "--weight", "8", case=case))

    def test_scripts_that_make_their_particles(self):
        for name, place in (("hopper-feed", "fix feed all insert/stream"), ("settling", "create_atoms")):
            with self.subTest(name):
                out = os.path.join(self.root, name)
                done = starting_runs.plain(os.path.join(support.SOURCE, "cases", name), out, "--from", self.hard, "--method", "DEM", "--weight", "1")
                self.assertEqual(done.returncode, 2, done.stdout)
                self.assertIn(f"the script of {name} makes its particles itself (dem/in.liggghts:", done.stderr)
                self.assertIn(place, done.stderr)
                self.assertIn("put `read_data dem/bed.data` in its place", done.stderr)

    def test_contradictions(self):
        both = starting_runs.plain(self.bed, os.path.join(self.root, "both"), "--from", self.soft, "--resume")
        self.assertEqual(both.returncode, 2)
        self.assertIn("--resume and --from", both.stderr)
        done = run(self.bed, self.soft, "--from", self.soft, "--overwrite", "--weight", "8", program="true")
        self.assertEqual(done.returncode, 2)
        self.assertIn("must lie apart", done.stderr)
        self.assertTrue(os.path.exists(os.path.join(self.soft, "results.h5")))
