# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 600
# processors: 4
"""Each particle may have its own weight: fix property/atom `weight` of the script, set as the README says.

Parcels of different weights fly as the particles that they stand for; weights keep to their particles from rank to rank,
over restart files and where particles are inserted; books close and ranks agree; contradictions are refused.
"""

import os
import shutil
import unittest

import numpy

import boxes
import measured
import support

SIZE, CELLS = (0.06, 0.03, 0.24), (6, 3, 24)
DIAMETER, DENSITY = 2e-4, 2500.0
AIR = (1.2, 1.8e-5)
FREE = "fix move all nve/sphere\n"


def box(position, weights, velocity=None, **how):
    """Parcels of real particles of one diameter."""
    weights = numpy.asarray(weights, float)
    how = {"method": "CGPM", "integrator": FREE, "walls": "", "particles": "solidStep 1e-4;", "gravity": 9.81, "fluid": AIR,
           "more": boxes.weighted(weights.tolist()), **how}  # fmt: skip
    return boxes.Box(SIZE, CELLS, DIAMETER * weights ** (1 / 3), DENSITY, position, velocity, **how)


class Flight(support.ProgramTest):
    WEIGHTS = [1, 8, 27, 1, 2.5, 8, 1000]

    def fall(self, ranks):
        """Far from each other at the same height, through gas at rest, over half of the ranks' parts."""
        n = len(self.WEIGHTS)
        place = numpy.column_stack([numpy.linspace(0.1, 0.9, n) * SIZE[0], numpy.full(n, 0.5 * SIZE[1]), numpy.full(n, 0.93 * SIZE[2])])
        scene = box(place, self.WEIGHTS, gas="model frozen; coupling oneWay;", mapping="type cellCentre;", step=1e-3, end=0.2, write_every=0.02)
        return self.run_case(scene.write(os.path.join(self.root, f"fall{ranks}"), ranks), ranks)

    def test_parcels_fall_as_their_particles_do(self):
        for ranks in (1, 2, 4):
            snapshots = self.fall(ranks).snapshots()
            self.assertGreater(numpy.ptp([s["position"][0, 2] for s in snapshots.values()]), 0.5 * SIZE[2])
            for time, snapshot in snapshots.items():
                # after having changed rank, too
                numpy.testing.assert_array_equal(snapshot["weight"], self.WEIGHTS)
                numpy.testing.assert_allclose(snapshot["diameter"], DIAMETER * numpy.cbrt(self.WEIGHTS), rtol=1e-12)
                # the fluid force is kept in single precision, 6e-8 of some 1 m/s
                off = abs(snapshot["velocity"] - snapshot["velocity"][0]).max()
                self.assertLess(off, 1e-7, f"{ranks} ranks, t = {time}")
            measured.below(self, f"parcels of W = 1 to 1000 of 0.2 mm spheres falling in air at {-snapshot['velocity'][0, 2]:.3g} m/s, ranks: {ranks}: velocities apart",
                           off, 1e-7, "m/s", "W = 1")  # fmt: skip

    def test_a_particle_alone_falls_the_same_way(self):
        """Without the property, with `weight 1;`: to the last bit that of W = 1 above."""
        many = self.fall(1).snapshots()
        place = many[0.0]["position"][:1]
        scene = box(place, [1], more="", gas="model frozen; coupling oneWay;", mapping="type cellCentre;", step=1e-3, end=0.2, write_every=0.02)
        alone = self.run_case(scene.write(os.path.join(self.root, "alone"))).snapshots()
        self.assertNotIn("weight", alone[0.0])
        last = max(alone)
        numpy.testing.assert_array_equal(alone[last]["velocity"][0], many[last]["velocity"][0])


def crowd(seed=3, count=400):
    draw = numpy.random.default_rng(seed)
    weights = draw.choice([1.0, 8.0, 27.0, 125.0], count)
    place = draw.uniform(0.1, 0.9, (count, 3)) * SIZE
    return place, weights, draw.normal(size=place.shape) * (0.03, 0.03, 0.3)


class WithTheGas(support.ProgramTest):
    def run_crowd(self, ranks):
        place, weights, velocity = crowd()
        scene = box(place, weights, velocity, step=5e-4, end=0.02)
        return self.run_case(scene.write(os.path.join(self.root, f"crowd{ranks}"), ranks), ranks)

    def test_books_close_and_ranks_agree(self):
        weights = crowd()[1]
        found = {}
        for ranks in (1, 2, 4):
            done = self.run_crowd(ranks)
            self.assert_books_close(done, ("momentum", "volume"))
            meta = done.meta
            self.assertEqual((meta["particles"], meta["real_particles"]), (len(weights), weights.sum()))
            self.assertAlmostEqual(meta["weight"], weights.mean(), delta=1e-9)
            self.assertEqual((meta["lowest_weight"], meta["highest_weight"]), (1, 125))
            self.assertRegex(done.out, rf"400 of weights 1 to 125, for {weights.sum():g} real ones of 0\.0002 m")
            found[ranks] = done.last()
            numpy.testing.assert_array_equal(found[ranks]["weight"], weights)
        for ranks in (2, 4):
            off = abs(found[ranks]["velocity"] - found[1]["velocity"]).max()
            print(f"{ranks} ranks against one: velocities differ by {off:.1e} m/s")
            # the gas solver's tolerance, 1e-8 of the pressure's residual, and sums in another order
            self.assertLess(off, 1e-6)

    def test_books_close_with_the_plug_ins(self):
        """Parcels that a stress guides, and hard spheres that collide (each of its own mass and size, whatever its weight)."""
        place, weights, velocity = crowd()
        friction = "fix mu all property/global coefficientFriction peratomtypepair 2 0.3 0.3 0.3 0.3\n"
        for method, plugin, style in (("MPPIC", "mp_pic", "mp_pic"), ("CGHS", "hard_sphere", "tdhs")):
            scene = box(place, weights, 10 * velocity, method=method, plugins=plugin, integrator=f"fix move all {style}\n",
                        walls=boxes.PLANES.replace("mp_pic", style), more=friction + boxes.weighted(weights.tolist()),
                        step=5e-4, end=0.05)  # fmt: skip
            with self.subTest(method):
                done = self.run_case(scene.write(os.path.join(self.root, method)))
                self.assert_books_close(done, ("momentum", "volume"))
                self.assertEqual(done.meta["real_particles"], weights.sum())

    def test_real_particles_of_one_weight(self):
        done = self.run_case(box([[0.03, 0.015, 0.2]] * 1, [8], more="", weight=8, end=1e-3).write(os.path.join(self.root, "one")))
        self.assertEqual([done.meta[name] for name in ("weight", "particles", "real_particles")], [8, 1, 8])
        self.assertRegex(done.out, r"1 of weight 8, for 8 real ones of 0\.0002 m")


@unittest.skipUnless(shutil.which("liggghts"), "needs the liggghts binary")
class Restart(support.ProgramTest):
    def test_weights_are_in_restart_files(self):
        place, weights, velocity = crowd(count=50)
        scene = box(place, weights, velocity, end=1e-3)
        folder = scene.write(os.path.join(self.root, "case"))
        script = support.read(folder, "dem/in.liggghts")
        for name, value in (("first", script + "timestep 1e-4\nrun 10\nwrite_restart dem/bed.restart\n"),
                            ("in", script.replace("read_data dem/parcels.data", "read_restart dem/bed.restart")
                             .replace(scene.more, boxes.weighted([1])))):  # fmt: skip
            support.write(os.path.join(folder, f"dem/{name}.liggghts"), value)
        support.must(folder, "liggghts", "-in", "dem/first.liggghts")
        snapshots = self.run_case(folder).snapshots()
        numpy.testing.assert_array_equal(snapshots[0.0]["weight"], weights)


class Insertion(support.ProgramTest):
    """A template whose particles get weight 8, beside one particle that is there."""

    def insertion(self, weight):
        return (
            boxes.weighted([1])
            + f"fix one all particletemplate/sphere 15485863 atom_type 1 density constant {DENSITY!r} radius constant {DIAMETER!r}\n"
            + "fix all_of all particledistribution/discrete 32452843 1 one 1.0\n"
            + "region above block 0.01 0.05 0.01 0.02 0.15 0.2 units box\n"
            + f"fix pour all insert/pack seed 86028121 distributiontemplate all_of set_property weight {weight} insert_every once "
            + "overlapcheck no all_in yes particles_in_region 20 region above\n"
        )

    def test_inserted_parcels_have_their_weight(self):
        scene = box([[0.03, 0.015, 0.1]], [1], more=self.insertion(8), step=1e-3, end=0.02)
        done = self.run_case(scene.write(os.path.join(self.root, "case")))
        last = done.last()
        numpy.testing.assert_array_equal(last["weight"], [1] + [8] * 20)
        numpy.testing.assert_allclose(last["diameter"], [DIAMETER] + [2 * DIAMETER] * 20, rtol=1e-12)
        self.assert_books_close(done, ("momentum",))

    def test_an_inserted_weight_below_one(self):
        scene = box([[0.03, 0.015, 0.1]], [1], more=self.insertion(0.5), step=1e-3, end=0.02)
        done = support.execute(scene.write(os.path.join(self.root, "case")))
        self.assertEqual(done.code, 1, done.text)
        self.assertRegex(done.text, r"inserts particles with a weight of 0\.5.*\n  where:  .*set_property weight.*\n  remedy: give it a weight of 1")


class BadInput(support.ProgramTest):
    def refused(self, *expected, ranks=(1, 2), **how):
        """Told once, before anything moved."""
        place = numpy.array([[0.02, 0.015, 0.03], [0.04, 0.015, 0.2]])
        for count in ranks:
            scene = box(place, [1, 1], end=1e-3, **how)
            folder = scene.write(os.path.join(self.root, f"box{len(os.listdir(self.root))}"), count)
            done = support.execute(folder, count)
            self.assertEqual(done.code, 1, done.text)
            self.assertEqual(done.text.count("remedy:"), 1, done.text)
            for pattern in expected:
                self.assertRegex(done.text, pattern)
            self.assertFalse(os.path.exists(done.path("results.h5")))

    def test_values(self):
        # LIGGGHTS takes a word for 0
        for word, told in (("0.5", r"0\.5"), ("-8", "-8"), ("0", "0"), ("nan", "nan"), ("inf", "inf"), ("many", "0")):
            with self.subTest(word):
                ids = "fix weights all property/atom weight scalar yes no no 1\nrun 0\nset atom 2 property/atom weight "
                self.refused(rf"the weight of particle 2 \(rank \d\) is {told}, which is no number of real particles",
                             r"where:  at \(0\.04 0\.015 0\.2\)", "set ... property/atom weight W", more=ids + word + "\n")  # fmt: skip

    def test_kinds(self):
        other = r"the property `weight` is not one number of each particle"
        for line, where in (
            ("fix w all property/atom weight vector yes no no 1 1", "fix w property/atom"),
            ("fix w all property/global weight scalar 8", "fix w property/global"),
            ("fix w all property/global weight peratomtype 8 8", "fix w property/global"),
            ("fix w all property/global weight peratomtypepair 2 8 8 8 8", "fix w property/global"),
        ):
            with self.subTest(line):
                self.refused(other, where, "fix ID all property/atom weight scalar yes no no W", more=line + "\n")

    def test_a_property_without_default(self):
        self.refused("the property `weight` has no default", "fix w property/atom", "W: the default",
                     more="fix w all property/atom weight scalar yes no no none\n")  # fmt: skip

    def test_a_property_that_restart_files_would_lose(self):
        self.refused("would not go into restart files", "scalar yes no no", more="fix w all property/atom weight scalar no no no 1\n")

    def test_methods_that_track_real_particles(self):
        given = boxes.weighted([1, 8])
        self.refused("weights up to 8, and method DEM tracks real particles", "fix property/atom weight", "CGPM", method="DEM", more=given)

    def test_against_the_weight_of_the_case(self):
        self.refused("the case says `weight 27;`, and the script gives its particles weights 1 to 8", "couplingDict", r"\$\{weight\}",
                     weight=27, more=boxes.weighted([1, 8]))  # fmt: skip
        # the case's number for those that the script gives no other
        scene = box([[0.02, 0.015, 0.03], [0.04, 0.015, 0.2]], [27, 8], weight=27, end=1e-3,
                    more=boxes.weighted([27, 8], default=27).replace("no no 27", "no no ${weight}"))  # fmt: skip
        done = self.run_case(scene.write(os.path.join(self.root, "agreed")))
        numpy.testing.assert_array_equal(done.snapshots()[0.0]["weight"], [27, 8])
