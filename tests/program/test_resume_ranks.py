# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 1200
"""A run goes on from its last checkpoint on more or fewer ranks, or on parts of the mesh that are cut otherwise. What was saved is there to
the last bit, in other places; 20 gas steps later it is the run that was not stopped, within the growth of round-off."""

import json
import os
import shutil

import numpy

import support
import test_mean_fields
import test_populations
import vessel
from interphase import foam_file
from resumed_run import WEIGHTS, ResumedMethods

FIELDS = ("U", "p_rgh", "p", "phi", "voidage")
BOOKS = ("momentum", "volume", "gas_volume", "solids")
POURED = 60

# how far positions of spheres of 2 mm may be apart after 20 gas steps [m]. With springs round-off grows: 5e-12 m were seen, and
# 4e-8 m after 40 steps between runs on one and two ranks. Hard spheres on several ranks do not agree within a pass
# (plugins/hard_sphere/README.md): 2e-5 m were seen, and 5e-4 m between such runs.
APART = {"DEM": 1e-9, "CGPM": 1e-9, "MPPIC": 1e-9, "TDHS": 1e-4, "CGHS": 1e-4}
CHANGES = {"DEM": (1, 2, 4), "CGPM": (2, 4), "TDHS": (4, 3, 1), "CGHS": (3, 2), "MPPIC": (2, 1, 3)}

PROFILE = " ".join(f"(0 0 {0.7 + 0.01 * face})" for face in range(32))
INLET = f"inlet {{ type fixedValue; value nonuniform List<vector> 32({PROFILE}); }}"
OUTLET = f"outlet {{ type inletOutlet; inletValue nonuniform List<vector> 32({PROFILE}); value uniform (0 0 0.8); }}"


def at_time(run, time):
    """The snapshot that is nearest."""
    snapshots = run.snapshots()
    return snapshots[min(snapshots, key=lambda one: abs(one - time))]


class ResumeOnOtherRanks(ResumedMethods, support.ProgramTest):
    stop, end = 0.02, 0.04
    periods = None  # [3, m]
    fields = FIELDS

    def bed(self, method):
        """At rest, so that a difference does not grow by collisions."""
        diameter = vessel.DIAMETER * WEIGHTS[method] ** (1 / 3)
        lines, self.count = vessel.bed(6 if WEIGHTS[method] == 1 else 4, diameter=diameter)
        return vessel.case(os.path.join(self.root, f"bed{len(os.listdir(self.root))}"), particles=lines)

    def poured(self, method):
        """Onto it come so many, in half as much time again as there is to the stop."""
        case = super().bed(method)
        script = os.path.join(case, "dem/in.liggghts")
        support.write(script, support.read(script).replace("nparticles 100000 particlerate 5000", f"nparticles {POURED} particlerate 2000"))
        return case

    def parted(self, case, method, ranks, cut=None, **settings):
        """The case on so many ranks. The gas is solved to round-off, since with other tolerances ranks differ by what their solvers leave, and
        written with all digits at the stop."""
        settings = {"system/fvSolution:solvers/p_rgh/tolerance": 1e-13, "system/fvSolution:solvers/p_rgh/relTol": 0,
                    'system/fvSolution:solvers/"(U|UFinal)"/tolerance': 1e-13, **settings}
        if cut:
            settings["system/decomposeParDict:simpleCoeffs/n"] = "({} {} {})".format(*cut)
        folder = vessel.prepared(self, case, method, ranks, self.end, weight=WEIGHTS[method], **settings)
        if cut:
            folder = shutil.move(folder, folder + "-{}{}{}".format(*cut))
        self.edit(folder, "system/fvSolution", r"^ *smoother +GaussSeidel;$", "smoother GaussSeidel; maxIter 100;")
        return self.recording(folder)

    def recording(self, folder):
        coupling = os.path.join(folder, "system/couplingDict")
        support.write(coupling, support.read(coupling) + f"\ncheckpoint {{ interval {self.stop}; }}\n")
        self.set_entry(folder, "system/couplingDict", "records/snapshotInterval", self.stop)
        for entry, value in (("writeFormat", "ascii"), ("writePrecision", 17), ("writeInterval", self.stop)):
            self.set_entry(folder, "system/controlDict", entry, value)
        return folder

    def go_on(self, source, target, ranks, end):
        """The run `target` to its end [s], from the stop of `source`."""
        checkpoint = os.path.join("checkpoints", f"{self.stop:g}")
        shutil.rmtree(os.path.join(target, "checkpoints"), ignore_errors=True)
        shutil.copytree(os.path.join(source, checkpoint), os.path.join(target, checkpoint))
        self.set_entry(target, "system/controlDict", "endTime", end)
        return self.run_case(target, ranks, options=["-resume"])

    def gas_at_stop(self, folder, ranks):
        """{field: text of cells, boundaries and conditions with all digits}; nothing where there is no gas."""
        if foam_file.value(support.read(folder, "system/couplingDict"), "gas/model") == "none":
            return dict.fromkeys(self.fields)
        if ranks > 1:
            command = ["reconstructPar", "-case", folder, "-time", f"{self.stop:g}"]
            support.launch.step(command, os.path.join(folder, "log.reconstructPar"), support.environment(), folder)
        return {name: support.read(folder, f"{self.stop:g}", name).split("dimensions", 1)[1] for name in self.fields}

    def expect_same_at_stop(self, source, target, whole, stopped, ranks):
        expected, found = at_time(whole, self.stop), at_time(stopped, self.stop)
        if self.periods is not None:  # a sphere beyond a side is put back to the other one as the run goes on: two roundings
            moved = expected.pop("position") - found.pop("position")
            numpy.testing.assert_allclose(moved, numpy.round(moved / self.periods) * self.periods, rtol=0, atol=1e-16)
        for name, values in expected.items():
            self.assertEqual(values.tobytes(), found[name].tobytes(), name)
        gas, here = self.gas_at_stop(source, ranks[0]), self.gas_at_stop(target, ranks[1])
        self.assertEqual([name for name in self.fields if gas[name] != here[name]], [])

    def expect_closed_books(self, run):
        if len(run.run.ledger):  # else the gas does not feel the particles
            self.assert_books_close(run, BOOKS)

    def expect_close(self, method, whole, done, limit=None):
        expected, found = at_time(whole, self.end), at_time(done, self.end)
        numpy.testing.assert_array_equal(expected["id"], found["id"])
        apart = expected["position"] - found["position"]
        if self.periods is not None:
            apart -= numpy.round(apart / self.periods) * self.periods
        apart = numpy.abs(apart).max()
        print(f"{method}: apart by {apart:.1e} m")
        self.assertLess(apart, limit or APART[method])
        self.expect_closed_books(done)

    def change(self, case, method, changes, **settings):
        """`changes`: numbers of ranks, or cuts (nx, ny, nz) of the gas mesh; the first is that of the run that is not stopped."""
        def ready(to):
            ranks = numpy.prod(to) if isinstance(to, tuple) else to
            return int(ranks), self.parted(case, method, int(ranks), to if isinstance(to, tuple) else None, **settings)

        first, source = ready(changes[0])
        whole = self.run_case(source, first)
        for to in changes[1:]:
            with self.subTest(method=method, ranks=(changes[0], to)):
                ranks, target = ready(to)
                self.expect_same_at_stop(source, target, whole, self.go_on(source, target, ranks, self.stop), (first, ranks))
                self.expect_close(method, whole, self.go_on(source, target, ranks, self.end))

    def check(self, method, ranks=None):
        """For the tests that are inherited, of each method."""
        self.change(self.bed(method), method, CHANGES[method])

    def test_while_spheres_are_poured_in(self):
        """Ranks draw their own random numbers, so the spheres that are still to come are others; as many, all told."""
        for method, first, ranks in (("DEM", 2, 1), ("TDHS", 1, 4)):
            with self.subTest(method=method):
                case = self.poured(method)
                source, target = self.parted(case, method, first), self.parted(case, method, ranks)
                whole = self.run_case(source, first)
                self.assertTrue(0 < len(at_time(whole, self.stop)["id"]) - self.count < POURED)
                self.expect_same_at_stop(source, target, whole, self.go_on(source, target, ranks, self.stop), (first, ranks))
                done = self.go_on(source, target, ranks, self.end)
                self.expect_closed_books(done)
                for run in (whole, done):
                    end = at_time(run, self.end)
                    self.assertEqual(len(set(end["id"])), self.count + POURED)
                    self.assertEqual(run.column("ledger/inserted")[-1], POURED)
                    distance = numpy.linalg.norm(end["position"][:, None] - end["position"][None], axis=2) + numpy.eye(len(end["id"]))
                    self.assertGreater(distance.min(), 0.9 * vessel.DIAMETER)  # none is drawn where another is

    def test_steps_before_and_values_by_face(self):
        """The scheme looks at two steps before; conditions have values of their own for each face, beside those of the field."""
        case = self.bed("CGPM")
        self.edit(case, "0/U", r"inlet\s*\{[^}]*\}", INLET)
        self.edit(case, "0/U", r"outlet\s*\{[^}]*\}", OUTLET)
        self.change(case, "CGPM", (1, 3, (1, 2, 2)), **{"system/fvSchemes:ddtSchemes/default": "backward"})

    def test_mean_fields_go_with_their_cells(self):
        case = self.bed("CGPM")
        self.edit(case, "system/couplingDict", r"^statistics\n\{", "statistics\n{\n    fields { from 0; }")
        self.set_entry(case, "system/couplingDict", "statistics/interval", 2 * vessel.GAS_STEP)
        self.fields = FIELDS + test_mean_fields.NAMES
        self.change(case, "CGPM", (2, 3, 1))

    def test_other_cuts_for_as_many_ranks(self):
        self.change(self.bed("DEM"), "DEM", ((2, 1, 1), (1, 1, 2)))

    def test_a_stream_through_a_face_and_an_outlet(self):
        """A mesh draws places with random numbers of its own; another deletes: none comes or goes that is not counted."""
        for method, first, ranks in (("DEM", 1, 2), ("TDHS", 3, 2)):
            with self.subTest(method=method):
                lines, self.count = vessel.bed(6, above=4)
                fixes = test_populations.spheres() + test_populations.STREAM + test_populations.outlet()
                case = vessel.case(os.path.join(self.root, f"stream-{method}"), lines, fixes)
                test_populations.write_plane(os.path.join(case, "dem/face.stl"), 0.085, 0.01, vessel.WIDTH - 0.01)
                test_populations.write_plane(os.path.join(case, "dem/outlet.stl"), 0.01)
                source, target = self.parted(case, method, first), self.parted(case, method, ranks)
                whole = self.run_case(source, first)
                self.expect_same_at_stop(source, target, whole, self.go_on(source, target, ranks, self.stop), (first, ranks))
                done = self.go_on(source, target, ranks, self.end)
                self.expect_closed_books(done)
                came, went = (done.column(f"ledger/{name}") for name in ("inserted", "deleted_by_mesh"))
                self.assertGreaterEqual(came[0], whole.column("ledger/inserted")[19])  # as many had come, and went, at the stop
                self.assertGreaterEqual(went[0], whole.column("ledger/deleted_by_mesh")[19])
                self.assertGreater(came[-1], came[0])
                self.assertEqual(len(at_time(done, self.end)["id"]), self.count + came[-1] - went[-1])

    def test_without_gas_and_in_a_given_flow(self):
        for model in ("none", "frozen"):
            self.change(self.bed("DEM"), "DEM", (1, 2), **{"system/couplingDict:gas/model": model, "system/couplingDict:gas/coupling": "oneWay"})

    def test_sides_that_repeat(self):
        """Faces of a pair of sides become those of a cut, and back."""
        def ready(*cut):
            settings = {"ends": "cyclic", "method": "DEM", "until": self.end, "gasStep": 1e-3, "system/fvSolution:solvers/p_rgh/tolerance": 1e-12,
                        "system/decomposeParDict:simpleCoeffs/n": "({} {} {})".format(*cut)}
            ranks = int(numpy.prod(cut))
            return ranks, self.recording(self.prepared("periodic-duct", "duct-{}{}{}".format(*cut), ranks, **settings))

        self.end, self.periods = 0.03, numpy.array([0.01, 0.01, 0.06])
        first, source = ready(1, 1, 2)
        whole = self.run_case(source, first)
        for cut in ((1, 1, 1), (2, 2, 1)):
            with self.subTest(cut=cut):
                ranks, target = ready(*cut)
                self.expect_same_at_stop(source, target, whole, self.go_on(source, target, ranks, self.stop), (first, ranks))
                # spheres meet often: 3e-10 m were seen
                self.expect_close("DEM", whole, self.go_on(source, target, ranks, self.end), limit=1e-8)

    def case_of_tools_run(self):
        case = vessel.numbered(self.bed("DEM"), "DEM")
        self.set_entry(case, "system/controlDict", "writeInterval", 0.005)
        return case

    def tools_run(self, case, folder, *words):
        done = support.tool("run", case, "--out", folder, "--no-picture", *words)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done

    def test_tools_run_cuts_anew(self):
        """No time that the gas was written at is lost, and rows go on."""
        case, folder = self.case_of_tools_run(), os.path.join(self.root, "run")
        cut_for = []
        for words in (["--ranks", "2", "--until", "0.01"], ["--resume", "--ranks", "3", "--until", "0.015"], ["--resume", "--until", "0.02"],
                      ["--resume", "--ranks", "1", "--until", "0.025"], ["--resume", "--ranks", "2", "--until", "0.03"]):
            self.assertNotIn("tools/run: warning", self.tools_run(case, folder, *words).stderr)
            cut_for.append((json.loads(support.read(folder, "run.json"))["ranks"], sum(name.startswith("processor") for name in os.listdir(folder))))
        self.assertEqual(cut_for, [(2, 2), (3, 3), (3, 3), (1, 0), (2, 2)])
        for time in ("0.005", "0.01", "0.015", "0.02", "0.025", "0.03"):
            self.assertTrue(os.path.isfile(os.path.join(folder, time, "U")), time)
        done = support.Finished(folder)
        self.assertEqual(list(done.column("parts/ranks")), [2, 3, 3, 1, 2])
        numpy.testing.assert_allclose(done.column("ledger/time"), vessel.GAS_STEP * numpy.arange(1, 31), atol=1e-9)
        self.assert_books_close(done, BOOKS)

    def test_parts_that_cannot_be_put_together_are_put_aside(self):
        case, folder = self.case_of_tools_run(), os.path.join(self.root, "run")
        self.tools_run(case, folder, "--ranks", "2", "--until", "0.005")
        shutil.rmtree(os.path.join(folder, "0.005"))  # as of a run that was killed before
        support.write(os.path.join(folder, "processor1/0.005/U"), "FoamFile { version 2.0; format ascii; class volVectorField; object U; }\n")
        done = self.tools_run(case, folder, "--resume", "--ranks", "1", "--until", "0.01")
        self.assertIn("reconstructPar failed", done.stderr)
        self.assertIn("the parts of the ranks so far are in", done.stderr)
        self.assertTrue(os.path.isfile(os.path.join(folder, "parts-of-2-ranks/processor0/0.005/U")))

    def test_the_program_alone_wants_the_case_cut(self):
        folder = self.parted(self.bed("DEM"), "DEM", 2)
        self.set_entry(folder, "system/controlDict", "endTime", 0.002)
        self.run_case(folder, 2)
        done = support.execute(folder, 3, options=["-resume"])
        self.assertEqual(done.code, 1)
        self.assertIn("the case is decomposed into 2 parts, and the run has 3 ranks", done.err)
        self.assertIn("`reconstructPar` takes out what the parts hold of written times", done.err)

    def test_parts_that_do_not_know_their_cells_are_refused(self):
        case = self.bed("DEM")
        source, target = self.parted(case, "DEM", 1), self.parted(case, "DEM", 2)
        self.set_entry(source, "system/controlDict", "endTime", self.stop)
        self.run_case(source)
        os.remove(os.path.join(target, "processor1/constant/polyMesh/cellProcAddressing"))
        with self.assertRaisesRegex(AssertionError, "the parts of the mesh now do not say which cells of the whole mesh they have"):
            self.go_on(source, target, 2, self.end)
