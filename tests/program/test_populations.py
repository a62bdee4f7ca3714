# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 400
"""Spheres that come and go while the gas blows: vessels that start empty, feeding, outlets, losses. Who came and went is counted by
cause, the books close to round-off on 1, 2 and 4 ranks, and the gas gives way without a jolt."""

import os
import re

import h5py
import numpy

import measured
import support
import vessel
from vessel import DENSITY, DEPTH, DIAMETER, HEIGHT, WIDTH

# Round-off: sums over some 1e3 particles and 5e2 cells a step, relative to the totals.
CLOSED = 1e-12
ACCOUNTS = ("momentum", "volume", "gas_volume", "solids")

SPHERES = """\
fix one all particletemplate/sphere 15485863 atom_type 1 density constant {density} radius constant {radius}
fix kinds all particledistribution/discrete 32452843 1 one 1.0
"""
# a thousand at once, in the middle
PACK = """\
region fill block 0.001 {x} 0.001 {y} 0.03 0.07 units box
fix pour all insert/pack seed 49979687 distributiontemplate kinds {more} maxattempt 100 insert_every once overlapcheck yes all_in yes &
    vel constant 0 0 0 region fill particles_in_region {count}
"""
# twenty in a millisecond, below the top
RATE = """\
region fill block 0.001 {x} 0.001 {y} 0.075 0.094 units box
fix pour all insert/rate/region seed 49979687 distributiontemplate kinds nparticles 100000 particlerate 20000 insert_every {every} &
    overlapcheck yes all_in yes vel constant 0 0 -1.0 region fill
"""
STREAM = """\
fix face all mesh/surface/planar file dem/face.stl type 2
fix pour all insert/stream seed 49979687 distributiontemplate kinds nparticles 100000 particlerate 20000 overlapcheck yes all_in no &
    vel constant 0 0 -0.5 insertion_face face extrude_length 0.008
"""
OUTLET = """\
fix outlet all mesh/surface/planar file dem/outlet.stl type 2
fix gone all massflow/mesh mesh outlet vec_side 0. 0. -1. count once {delete}
"""


def spheres(diameter=DIAMETER):
    return SPHERES.format(density=DENSITY, radius=diameter / 2)


def pack(count=1000, more=""):
    return PACK.format(x=WIDTH - 0.001, y=DEPTH - 0.001, count=count, more=more)


def rate(every):
    return RATE.format(x=WIDTH - 0.001, y=DEPTH - 0.001, every=every)


def outlet(deletes=True):
    return OUTLET.format(delete="delete_atoms yes" if deletes else "")


def write_plane(path, z, left=0.0, right=WIDTH):
    """Two triangles across the depth."""
    corners = [(left, 0.0, z), (right, 0.0, z), (right, DEPTH, z), (left, DEPTH, z)]
    facets = ""
    for triangle in ((0, 1, 2), (0, 2, 3)):
        points = "".join("vertex {} {} {}\n".format(*corners[n]) for n in triangle)
        facets += f"facet normal 0 0 1\nouter loop\n{points}endloop\nendfacet\n"
    support.write(path, f"solid plane\n{facets}endsolid plane\n")


class Populations(support.ProgramTest):
    def case(self, name, particles="", fixes="", face=0.085, out=0.01, **more):
        folder = vessel.case(os.path.join(self.root, name), particles, fixes, **more)
        write_plane(os.path.join(folder, "dem/face.stl"), face, 0.01, WIDTH - 0.01)
        write_plane(os.path.join(folder, "dem/outlet.stl"), out)
        return folder

    def finished(self, folder, method, ranks=1, until=0.03, **settings):
        return self.run_case(vessel.prepared(self, folder, method, ranks, until, **settings), ranks)

    def stopped(self, folder, method, *parts, ranks=1, until=0.03, **settings):
        done = support.execute(vessel.prepared(self, folder, method, ranks, until, **settings), ranks)
        self.assertNotEqual(done.code, 0, done.out)
        for part in parts:
            self.assertRegex(done.err, part)

    def assert_closed(self, done):
        """The ledgers; and the number of spheres is what came less what went, in every row."""
        self.assert_books_close(done, ACCOUNTS, CLOSED)
        start = done.meta["particles_at_start"]
        here, came, went = (done.column(f"series/{name}") for name in ("particles", "particles_in", "particles_out"))
        numpy.testing.assert_array_equal(here, start + came - went)
        self.assertEqual(done.meta["particles"], here[-1])
        # what made room, or was filled, is what the gas books say of the solids that came and went
        ledger = done.table("ledger")
        return ledger, here

    def test_a_vessel_that_starts_empty(self):
        """1,000 spheres at once weigh 40 Pa over the cross-section. As a change of voidage in one step their volume would be a
        flow of 3.6 m/s through the top, and a pressure of 200 Pa to start it."""
        for method in ("DEM", "TDHS"):
            with self.subTest(method=method):
                done = self.finished(self.case(f"pack{method}", fixes=spheres() + pack()), method)
                ledger, here = self.assert_closed(done)
                self.assertEqual(here[-1], 1000)
                self.assertIn("none yet; spheres of 0.002 m are to be inserted", done.out)
                self.assertRegex(done.out, r"mapping +spheres up to 0.002 m: \S+ m wide")
                volume = 1000 * numpy.pi / 6 * DIAMETER**3
                self.assertAlmostEqual(ledger["inserted_volume"][-1] / volume, 1, delta=1e-12)
                self.assertAlmostEqual(ledger["gas_displaced_volume"][-1] / volume, 1, delta=1e-12)
                measured.below(self, f"1,000 spheres poured into a vessel at once, {method}: pressure drop at most, the weight being 40 Pa",
                               abs(done.column("series/pressure_drop")).max(), 40, "Pa", "weight of all")
                # of the shortest t_c: two spheres of 2 mm, 800 N/m, e = 0.84
                contact = numpy.sqrt(DENSITY * numpy.pi / 12 * DIAMETER**3 / 800 * (numpy.pi**2 + numpy.log(0.84) ** 2))
                self.assertLessEqual(done.meta["solid_step"], contact / (20 if method == "DEM" else 1) * (1 + 1e-6))
                weight = done.column("series/bed_weight_per_area")[-1]
                self.assertAlmostEqual(weight, volume * DENSITY * 9.81 / (WIDTH * DEPTH), delta=1e-6 * weight)
                self.assertAlmostEqual(weight / done.meta["bed_weight_per_area"], 1, delta=1e-9)

    def test_pouring_onto_a_bed(self):
        """The bed's pressure drop of 9 Pa goes on; as a change of voidage the spheres gave -388 to +330 Pa."""
        lines, count = vessel.bed(4)
        done = self.finished(self.case("bed", lines, spheres() + pack()), "TDHS")
        _, here = self.assert_closed(done)
        self.assertEqual(here[-1], count + 1000)
        drop = done.column("series/pressure_drop")[1:]  # the start's field knows of no bed
        self.assertGreater(drop.min(), 4)
        self.assertLess(drop.max(), 18)

    def test_a_snapshot_of_nobody(self):
        done = self.finished(self.case("stream", fixes=spheres() + STREAM), "TDHS")
        _, here = self.assert_closed(done)
        self.assertGreater(here[-1], 100)
        with h5py.File(done.path("particles.h5")) as file:
            self.assertEqual(file["/snapshots/000000/position"].shape, (0, 3))
        self.assertIn('NumberOfElements="0"', support.read(done.path("particles.xdmf")))

    def test_feeding_and_an_outlet_that_deletes(self):
        for method, every in (("DEM", 100), ("TDHS", 6)):
            lines, count = vessel.bed(6, above=4)
            folder = self.case(f"feed{method}", lines, spheres() + rate(every) + outlet())
            for ranks in (1, 2, 4):
                with self.subTest(method=method, ranks=ranks):
                    done = self.finished(folder, method, ranks, until=0.06)
                    ledger, here = self.assert_closed(done)
                    came, went = ledger["inserted"], ledger["deleted_by_mesh"]
                    self.assertGreater(came[-1], 800)
                    self.assertGreater(went[-1], 200)
                    self.assertTrue(((numpy.diff(came) > 0) & (numpy.diff(went) > 0)).any(), "both in one gas step")
                    self.assertEqual(here[-1], count + came[-1] - went[-1])
                    one = numpy.pi / 6 * DIAMETER**3
                    numpy.testing.assert_allclose(ledger["deleted_by_mesh_volume"], went * one, rtol=1e-12)
                    # they fall: their momentum goes down with them, at 0.1 to 1 m/s
                    speed = ledger["deleted_by_mesh_momentum_z"][-1] / (went[-1] * one * DENSITY)
                    self.assertTrue(-1 < speed < -0.1, speed)
                    # what deletes is found at the gas's last step, which knows all but those of the first
                    numpy.testing.assert_allclose(ledger["gas_restored_volume"], went * one, rtol=1e-12)
                    # 50 Pa of bed; a layer of 253 spheres that vanishes as a change of voidage gave 120 Pa
                    self.assertLess(abs(done.column("series/pressure_drop")).max(), 50)

    def test_an_outlet_that_sees_spheres_late(self):
        """0.9 of a radius in a solid step: LIGGGHTS lists three of four for the outlet when they are below it already, and
        neither counted nor deleted them; they came to lie on the floor without a word."""
        lines, count = vessel.bed(4, above=8)
        fall = "velocity all set 0.0 0.0 -5.5 units box\n"
        counted = "thermo_style custom step atoms f_gone[2] f_gone[6]\nthermo 1\n"
        folder = self.case("late", lines, fall + outlet() + counted)
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                done = self.finished(folder, "TDHS", ranks, until=0.015)
                ledger, here = self.assert_closed(done)
                self.assertEqual(here[-1], 0)
                self.assertEqual(ledger["deleted_by_mesh"][-1], count)
                self.assertRegex(done.out, r"particles that an outlet saw late +\d+")
                # as LIGGGHTS counts them: crossed, deleted
                last = re.findall(r"^ +\d+ +(\d+) +(\d+) +(\d+) *$", support.read(done.path("dem/log.liggghts")), re.M)[-1]
                self.assertEqual([int(number) for number in last], [0, count, count])

    def test_leaving_through_the_boundary(self):
        """No floor and no wall below: spheres fall out of the gas mesh and then out of their box."""
        lines, count = vessel.bed(4, above=2)
        walls = ("left", "right", "front", "back", "top")
        box = f"0 {WIDTH} 0 {DEPTH} -0.01 {HEIGHT}"
        ignore = [("system/couplingDict", "^mapping", "outsideMesh ignore;\nmapping")]
        for method in ("DEM", "TDHS"):
            folder = self.case(f"fall{method}", lines, box=box, walls=walls, edits=ignore)
            for ranks in (1, 4):
                with self.subTest(method=method, ranks=ranks):
                    done = self.finished(folder, method, ranks, until=0.08, inletVelocity=0.1)
                    ledger, here = self.assert_closed(done)
                    self.assertLess(here[-1], 0.6 * count)
                    self.assertEqual(ledger["left_through_boundary"][-1], count - here[-1])
                    self.assertGreaterEqual(ledger["left_gas_mesh"][-1], ledger["left_through_boundary"][-1])
                    self.assertLess(abs(done.column("series/pressure_drop")).max(), 20)
                    self.assertIn("left through the boundary of the particles' domain", done.out)
        folder = self.case("refused", lines, walls=walls)
        self.stopped(folder, "DEM", "in no gas cell|were lost", "outsideMesh ignore", until=0.08, inletVelocity=0.1)

    def test_a_loss_is_seen_beside_a_counter_an_outlet_and_a_feed(self):
        """One of them is pushed out of the box at 1 km/s while others are counted, deleted and inserted."""
        lines, _ = vessel.bed(4, above=8)
        push = 'group lost id 11\nvariable push equal "(step>{start})*1e3"\nfix push lost addforce 0.0 0.0 v_push\n'
        walls = ("left", "right", "front", "back", "bottom")
        scenes = {"counter": outlet(False), "outlet": outlet(), "feed": spheres() + rate(100)}
        for name, fixes in scenes.items():
            with self.subTest(scene=name):
                folder = self.case(f"loss-{name}", lines, fixes + push.format(start=1000), walls=walls)
                self.stopped(folder, "DEM", r"1 of \d+ particles were lost", r"particle 11 \(rank \d\)", r"at \(\S+ \S+ \S+\)")

    def test_the_step_is_that_of_the_smallest_to_come(self):
        """Spheres of 1 mm after such of 2 mm: t_c goes with d^1.5."""
        lines, _ = vessel.bed(2)
        steps = {}
        for name, fixes in {"alone": "", "mixed": spheres(0.5 * DIAMETER) + pack(50)}.items():
            done = self.finished(self.case(name, lines, fixes), "DEM", until=0.003)
            steps[name] = done.meta["solid_step"]
        self.assertAlmostEqual(steps["mixed"] / steps["alone"], 0.5**1.5, delta=0.02)  # both divide the gas step

    def test_parcels_among_real_particles(self):
        weights = "fix weights all property/atom weight scalar yes no no 1\natom_modify sort 0 0\nrun 0\n"
        default = weights.replace("no no 1", "no no 8").replace("run 0", "run 0\nset group all property/atom weight 1")
        lines, _ = vessel.bed(2)
        for method, instead in (("DEM", "CGPM"), ("TDHS", "CGHS")):
            folder = self.case(f"weight{method}", lines + weights, spheres() + pack(20, "set_property weight 8"))
            self.stopped(folder, method, "the script inserts", "weight of 8", f"method {method} tracks real particles", instead)
            folder = self.case(f"default{method}", lines + default, spheres() + pack(20))
            self.stopped(folder, method, "was inserted", "weight of 8", f"method {method} tracks real particles", instead)

    def test_a_closed_vessel(self):
        """No gas comes or goes: what is poured in replaces as much of it."""
        wall = [("0/U", r"(?s)inlet\s*\{.*?\}\s*outlet\s*\{.*?\}", "inlet { type noSlip; } outlet { type noSlip; }"),
                ("0/p_rgh", r"(?s)outlet\s*\{\s*type\s+fixedValue;", "outlet { type fixedFluxPressure; gradient uniform 0;"),
                ("system/fvSolution", r"momentumPredictor", "p_rghRefCell 0; p_rghRefValue 101325; momentumPredictor")]  # fmt: skip
        done = self.finished(self.case("closed", fixes=spheres() + pack(), edits=wall), "TDHS", inletVelocity=0)
        ledger, here = self.assert_closed(done)
        self.assertEqual(here[-1], 1000)
        drop = done.column("series/pressure_drop")
        weight = done.meta["bed_weight_per_area"]
        self.assertLess(abs(drop).max(), weight)
