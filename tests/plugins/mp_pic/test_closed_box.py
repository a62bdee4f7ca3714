# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 600
# processors: 4
"""Parcels in a closed box: no stress where they are spread evenly, of one weight or of several, books that close, tracers that
fly as DEM's do, the same on any number of ranks, and bad input refused.
"""

import os

import numpy

import boxes
import measured
import support
from closed_box import CELLS, DENSITY, DIAMETER, FROZEN, MASS, SIZE, SUMS, THIN, BoxTest, crowd, heaped


class ClosedBox(BoxTest):
    def test_no_force_where_the_bed_is_uniform(self):
        """27 parcels in every cell, each in its own: the gradient is 0 to round-off, whatever velocities they have."""
        parcels = crowd()
        done = self.run_box("uniform", parcels=parcels, fluid=THIN, gas=FROZEN, mapping="type cellCentre;", step=1e-4, end=1e-4,
                            integrator="fix move all mp_pic\n" + SUMS)  # fmt: skip
        change = done.last()["velocity"] - parcels[1]
        # against 0.2 m/s; the stress of 27 parcels is 0.4 Pa
        measured.below(self, "MP-PIC: uniform bed: velocity that the stress gives in a step", abs(change).max(), 1e-12, "m/s", "no gradient")

    def test_no_force_where_a_bed_of_mixed_weights_is_uniform(self):
        """Weights of 1 to 4 in every cell, in each the same: the solid fraction is the parcels', whatever number makes it."""
        position, velocity = crowd()
        inside = numpy.floor(position / SIZE * (12, 12, 24)).astype(int) % 3 @ (9, 3, 1)  # place in the cell, 0 to 26
        weights = (1.0 + inside % 4).tolist()
        done = self.run_box("mixed", parcels=(position, velocity), diameter=DIAMETER * numpy.cbrt(weights), more=boxes.weighted(weights),
                            fluid=THIN, gas=FROZEN, mapping="type cellCentre;", step=1e-4, end=1e-4, integrator="fix move all mp_pic\n" + SUMS)  # fmt: skip
        last = done.last()
        change = last["velocity"] - velocity
        numpy.testing.assert_array_equal(last["weight"], weights)
        fraction = sum(1.0 + k % 4 for k in range(27)) * MASS / DENSITY / numpy.prod(numpy.array(SIZE) / CELLS)
        print(f"uniform bed of mixed weights, solid fraction {fraction:.2f}: velocities change by {abs(change).max():.1e} m/s")
        self.assertLess(abs(change).max(), 1e-12)  # against 0.2 m/s

    def test_momentum_comes_from_stress_and_walls_alone(self):
        parcels = heaped()
        done = self.run_box("heap", parcels=parcels, fluid=THIN, gas=FROZEN, step=5e-4, end=0.1, integrator="fix move all mp_pic overfilled count\n" + SUMS)
        change = self.momentum(done.last()) - MASS * parcels[1].sum(axis=0)
        by_stress, by_walls = self.sums(done)
        scale = MASS * abs(parcels[1]).sum()
        off = abs(change - by_stress - by_walls).max() / scale
        # round-off of 200 steps
        measured.below(self, "MP-PIC: heap in a closed box: change of momentum less what stress and walls gave", off, 1e-12, "", "conservation")
        self.assertGreater(abs(by_stress).max() / scale, 1e-3)  # the stress does something

    def test_books_with_the_gas_close(self):
        done = self.run_box("books", parcels=heaped(), gravity=9.81, step=5e-4, end=0.1, integrator="fix move all mp_pic overfilled count\n")
        self.assert_books_close(done, ("momentum", "volume"))
        self.assertIn("cells_beyond_close_packing", done.run.ledger)

    def test_an_adjusted_step_heeds_the_parcels(self):
        """Eq. 28: where the gas step may change, none crosses more than its share of a cell."""
        speed, share, longest = 2.0, 0.25, 4e-3
        position, velocity = crowd(speed=0.0, counts=(4, 4, 8))
        velocity[5] = (0, 0, speed)
        box = boxes.Box(SIZE, CELLS, DIAMETER, DENSITY, position, velocity, fluid=THIN, e=1.0, en=1.0, step=2.5e-4, end=0.05,
                        particles="solidStep 2.5e-4;", integrator=f"fix move all mp_pic courant {share}\n")  # fmt: skip
        folder = box.write(os.path.join(self.root, "adjusted"))
        with open(os.path.join(folder, "system", "controlDict"), "a") as file:
            file.write(f"adjustTimeStep yes; maxCo 1000; maxDeltaT {longest};\n")
        done = self.run_case(folder)
        steps = numpy.diff(done.column("ledger/time"))
        self.assertEqual(done.column("ledger/step_crosses_cells")[-1], 0)
        allowed = share * SIZE[2] / CELLS[2] / speed
        print(f"eq. 28 allows {allowed} s of {longest} s; steps grew from {steps[0]:.3g} to {steps.max():.3g} s")
        self.assertAlmostEqual(steps.max(), allowed, delta=1e-9)  # a whole number of solid steps, so it is met

    def test_tracers_fly_as_dem_s_do(self):
        """Stress off, W = 1: the same trajectory as nve/sphere's, through gas that drags and gravity."""
        draw = numpy.random.default_rng(4)
        position = draw.uniform(0.3, 0.7, (20, 3)) * SIZE
        velocity = draw.normal(scale=0.05, size=position.shape)  # none gets to a wall
        found = {}
        for name, method, integrator in (("mp_pic", "MPPIC", "fix move all mp_pic stress off\n"), ("dem", "DEM", "fix move all nve/sphere\n")):
            done = self.run_box(name, parcels=(position, velocity), method=method, integrator=integrator, gravity=9.81, step=5e-4, end=0.04,
                                walls=boxes.PLANES if name == "mp_pic" else "", particles="solidStep 2.5e-4;")  # fmt: skip
            found[name] = done.last()
        for what in ("position", "velocity"):
            off = abs(found["mp_pic"][what] - found["dem"][what]).max()
            # the same operations in another library; gas solvers start from the same numbers
            measured.below(self, f"MP-PIC: 20 parcels of W = 1 without stress: {what} off nve/sphere's after 160 solid steps", off, 1e-13, {"position": "m"}.get(what, "m/s"),
                           "LIGGGHTS's nve/sphere")  # fmt: skip

    def test_ranks_conserve_alike_and_agree(self):
        means = {}
        for ranks in (1, 2, 4):
            done = self.run_box(f"ranks{ranks}", ranks, parcels=heaped(), gravity=9.81, step=5e-4, end=0.2, write_every=0.01,
                                integrator="fix move all mp_pic overfilled count\n")  # fmt: skip
            self.assert_books_close(done, ("momentum",))
            self.assertEqual(done.column("series/particles")[-1], 5000)
            means[ranks] = [done.column(f"series/{name}")[-10:].mean() for name in ("bed_height", "kinetic_energy", "lowest_voidage")]
            print(f"{ranks} ranks: bed height, kinetic energy, lowest voidage {means[ranks]}")
        for ranks in (2, 4):
            # sums in another order, 1e-16, which 400 steps make grow to 1e-12 or so
            measured.below(self, f"MP-PIC: heap in a closed box, {ranks} ranks against 1: bed height, kinetic energy, lowest voidage off, relative",
                           abs(numpy.divide(means[ranks], means[1]) - 1).max(), 1e-6, "", "one rank")


class BadInput(BoxTest):
    def test_words_of_the_fix(self):
        for words, expected in (
            ("close_packing 1", "close_packing 1: give a solid fraction between 0 and 1"),
            ("close_packing 0", "close_packing 0: give a solid fraction"),
            ("close_packing -0.6", "close_packing -0.6: give"),
            ("stress harris_crighton 0 3", r"P_s 0: give a number above 0, in Pa \(1 to 100 are published\)"),
            ("stress harris_crighton -10 3", "P_s -10: give"),
            ("stress harris_crighton 10 0", r"xi 0: give a number above 0 \(2 to 5 are published\)"),
            ("stress harris_crighton ten 3", "P_s ten': no number"),
            ("stress harris_crighton 10", "'stress harris_crighton xi' needs a value"),
            ("stress harris_crighton 1e308 3", r"stress harris_crighton is inf Pa at a solid fraction of 0\.\d+; it must be a finite number"),
            ("stress hooke", "stress hooke: give harris_crighton P_s xi, lun density temperature restitution, or off"),
            ("stress lun 1000 0.01 1.5", "restitution 1.5: give 0 to 1"),
            ("courant 0", "courant 0: give"),
            ("too_fast no", "too_fast no: give stop or count"),
            ("table nowhere/table", "table nowhere/table: this file cannot be written; give one in a folder that is there"),
            ("stress off table there", "table there: with `stress off` there is no stress to write"),
            ("packing 0.6", "unknown word 'packing'; known: stress, close_packing"),
        ):
            with self.subTest(words):
                self.ended(expected, integrator=f"fix move all mp_pic {words}\n")

    def test_numbers_beyond_what_is_published(self):
        """... run, with a warning in LIGGGHTS's log; those within the range, both ends included, without."""
        for words, number, value, published in (("10 1.9", "xi", "1.9", "2 to 5"), ("10 12", "xi", "12", "2 to 5"), ("0.5 3", "P_s", "0.5", "1 to 100")):
            with self.subTest(words):
                self.ended(f"WARNING: Fix mp_pic: {number} of the stress harris_crighton is {value}, outside the published range of {published}", good=True, integrator=f"fix move all mp_pic stress harris_crighton {words}\n")  # fmt: skip
        for words in ("stress harris_crighton 1 2", "stress harris_crighton 100 5", "stress lun 1000 0.01 0.9", "stress off", ""):
            with self.subTest(words):
                done = self.ended("Reached t = 0.002 s", good=True, integrator=f"fix move all mp_pic {words}\n")
                self.assertIn("fix move all mp_pic", done.told)  # the log is there
                self.assertNotIn("published", done.told)

    def test_restitution(self):
        self.ended(r"coefficientRestitution is 1\.5", e=1.5)

    def test_company(self):
        self.ended(r"fix other \(nve/sphere, of group all\) and fix move \(mp_pic, of group all\) both move the same particles",
                   integrator="fix other all nve/sphere\nfix move all mp_pic\n")
        self.ended("both move the same particles", integrator="fix other all mp_pic\nfix move all mp_pic\n")
        self.ended("there is no fix mp_pic that heeds this wall|no fix", integrator="fix move all nve/sphere\n")

    def test_without_a_gas(self):
        self.ended("no solid stress has arrived", gas="model none;")

    def test_a_cell_that_is_overfilled_at_the_start(self):
        place = numpy.random.default_rng(1).uniform(-1, 1, (200, 3)) * 3e-3 + [0.015, 0.015, 0.035]
        parcels = (place, numpy.zeros_like(place))
        self.ended(r"beyond close packing at the start.*0\.8.*where: in the cell at \(0\.015 0\.015 0\.035\)", parcels=parcels,
                   mapping="type cellCentre; maximumPacking 0.95;")  # fmt: skip
        done = self.ended("cells beyond close packing +[1-9]", good=True, parcels=parcels, mapping="type cellCentre; maximumPacking 0.95;",
                          integrator="fix move all mp_pic overfilled count\n")  # fmt: skip
        self.assertEqual(done.code, 0)

    def test_mapping_by_centres_with_the_gas_s_answer(self):
        self.ended("do not go together: single cells fill and empty .* remedy: set `type kernel;`", mapping="type cellCentre;",
                   gas="model pimple; coupling twoWay;")  # fmt: skip

    def test_steps_that_cross_cells(self):
        position, velocity = crowd(speed=0.0, counts=(4, 4, 8))
        velocity[5] = (0, 0, 30.0)
        self.ended("steps too long for a particle's cell +[1-9]", good=True, parcels=(position, velocity))
        self.ended(r"particle 6 moves at \(0 0 29\.\d+\) m/s.*remedy: give a gas step below", parcels=(position, velocity),
                   integrator="fix move all mp_pic too_fast stop\n")  # fmt: skip
