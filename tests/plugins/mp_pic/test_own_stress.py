# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 900
"""A stress of one's own: written once more it is the built-in one to the last bit, and keeps what that keeps; one that is none is refused on every
rank, with the value and where, before anything moves.
"""

import os
import shutil

import numpy

import boxes
from closed_box import FROZEN, MASS, SUMS, THIN, BoxTest, crowd, heaped
from hard_spheres import BUILD
from resumed_run import ResumedRun

LIBRARY = os.path.join(BUILD, "tests", "plugins", "libstresses.so")
PLUGINS = f'mp_pic "{LIBRARY}"'


def own(stress, numbers="", words=""):
    """What a Box has that moves by a stress of the plug-in."""
    return {"plugins": PLUGINS, "walls": boxes.PLANES.replace("wall/mp_pic", f"wall/mp_pic/{stress}"),
            "integrator": f"fix move all mp_pic/{stress} stress {stress} {numbers} {words}\n"}  # fmt: skip


class OwnStress(BoxTest):
    HEAP = {"parcels": heaped(), "gravity": 9.81, "step": 5e-4, "end": 0.05}

    def test_is_the_built_in_one_to_the_last_bit(self):
        built_in = self.run_box("built_in", **self.HEAP, integrator="fix move all mp_pic stress harris_crighton 50 2.5 close_packing 0.62 overfilled count\n")
        rewritten = self.run_box("rewritten", **self.HEAP, **own("rewritten", "50 2.5", "close_packing 0.62 overfilled count"))
        for name, expected in built_in.last().items():
            self.assertEqual(rewritten.last()[name].tobytes(), expected.tobytes(), name)
        self.assertIn("cells_beyond_close_packing", rewritten.run.ledger)
        self.assertIn("put_out_of_walls", rewritten.run.counters)

    def test_no_force_where_the_bed_is_uniform(self):
        parcels = crowd()
        more = own("plain")
        more["integrator"] += SUMS
        done = self.run_box("uniform", parcels=parcels, fluid=THIN, gas=FROZEN, mapping="type cellCentre;", step=1e-4, end=1e-4, **more)
        # the round-off of a stress of some Pa over cells of 1 cm, against velocities of 0.2 m/s
        self.assertLess(abs(done.last()["velocity"] - parcels[1]).max(), 1e-12)

    def test_momentum_comes_from_stress_and_walls_alone(self):
        parcels = heaped()
        more = own("plain", words="overfilled count")
        more["integrator"] += SUMS
        done = self.run_box("heap", parcels=parcels, fluid=THIN, gas=FROZEN, step=5e-4, end=0.05, **more)
        change = self.momentum(done.last()) - MASS * parcels[1].sum(axis=0)
        by_stress, by_walls = self.sums(done)
        scale = MASS * abs(parcels[1]).sum()
        self.assertLess(abs(change - by_stress - by_walls).max() / scale, 1e-12)  # round-off of 100 steps
        self.assertGreater(abs(by_stress).max() / scale, 1e-3)  # the stress does something

    def test_ranks_agree_and_books_close(self):
        means = {}
        for ranks in (1, 2):
            done = self.run_box(f"ranks{ranks}", ranks, **self.HEAP, write_every=0.01, **own("plain", words="overfilled count"))
            self.assert_books_close(done, ("momentum", "volume"))
            means[ranks] = [done.column(f"series/{name}")[-1] for name in ("bed_height", "kinetic_energy", "lowest_voidage")]
        print(f"own stress, 2 ranks over 1: bed height, kinetic energy, lowest voidage {numpy.divide(means[2], means[1]) - 1}")
        numpy.testing.assert_allclose(means[2], means[1], rtol=1e-6)  # sums in another order, which 100 steps make grow


class Table(BoxTest):
    def test_is_the_stress_as_the_script_gives_it(self):
        more = own("rewritten", "50 2.5", "close_packing 0.62345678 table dem/stress.txt")
        done = self.run_box("box", parcels=crowd(speed=0.05, counts=(4, 4, 8)), gas=FROZEN, end=2e-3, **more)
        phi, stress = numpy.loadtxt(done.path("dem", "stress.txt"), unpack=True)
        self.assertEqual(len(phi), 10002)
        self.assertIn(0.62345678, phi)
        below = phi < 0.62
        numpy.testing.assert_allclose(stress[below], 50 * phi[below] ** 2.5 / (0.62345678 - phi[below]), rtol=1e-13)  # round-off


class BadStresses(BoxTest):
    def test_answers(self):
        for stress, expected in (
            ("draws", "Fix mp_pic/draws: the stress draws is -1 Pa at a solid fraction of 0; it must be a finite number, not below 0"),
            ("falls", "the stress falls falls from 5 Pa at a solid fraction of 0.1571 to 3 Pa at a solid fraction of 0.4712; it must not"),
            ("has_a_pole", "the stress has_a_pole is inf Pa at a solid fraction of 0.6;"),
            ("has_no_number", r"the stress has_no_number is -?nan Pa at a solid fraction of 0.6301;"),
        ):
            for ranks in (1, 2):
                with self.subTest(stress, ranks=ranks):
                    words = "close_packing 0.61 close_packing 0.6"  # the last word counts
                    done = self.ended(expected, ranks=ranks, **own(stress, words=words))
                    self.assertEqual(done.text.count(f"Fix mp_pic/{stress}"), 1, done.text)
                    self.assertFalse(os.path.exists(done.path("results.h5")), "nothing half done")

    def test_a_pole_at_close_packing_between_the_points_of_the_grid(self):
        self.ended("is inf Pa at a solid fraction of 0.600012", **own("has_a_pole", words="close_packing 0.600012"))

    def test_numbers(self):
        for words, expected in (
            ("", "Fix mp_pic/rewritten: the script does not give the stress; add `stress rewritten P_s xi`"),
            ("stress rewritten", "'stress rewritten P_s' needs a value"),
            ("stress rewritten 100", "'stress rewritten xi' needs a value"),
            ("stress rewritten 100 overfilled count", "'stress rewritten xi overfilled': no number"),
            ("stress rewritten -1 3", "stress rewritten P_s -1: give a number above 0, in Pa"),
            ("stress rewritten 100 3 4", "unknown word '4'"),
            ("stress harris_crighton 100 3", "stress harris_crighton: give rewritten P_s xi, or off"),
        ):
            with self.subTest(words):
                self.ended(expected, **{**own("rewritten"), "integrator": f"fix move all mp_pic/rewritten {words}\n"})
        self.ended("WARNING: Fix mp_pic/rewritten: xi of the stress rewritten is 6, outside the published range of 2 to 5", good=True, **own("rewritten", "50 6"))
        self.ended("Reached t = 0.002 s", good=True, **{**own("rewritten"), "integrator": "fix move all mp_pic/rewritten stress off\n"})

    def test_company(self):
        two = own("plain")
        two["integrator"] += "fix other all mp_pic\n"
        self.ended("both move the same particles", **two)
        # of two groups, they move none of the same
        halves = "region low block 0 0.04 0 0.04 0 0.04 units box\ngroup low region low\ngroup high subtract all low\n"
        two["integrator"] = halves + "fix move low mp_pic/plain stress plain\nfix other high mp_pic\n"
        self.ended("two fixes want the solids' stress on the gas mesh: move and other", **two)
        self.ended("wall/mp_pic: there is no fix mp_pic that heeds this wall", **{**own("plain"), "walls": boxes.PLANES})
        one = own("plain")
        one["walls"] += "fix more all wall/mp_pic primitive type 2 zplane 0.07\n"
        self.ended("more wall/mp_pic: there is no fix mp_pic that heeds this wall", **one)

    def test_a_name_that_is_there(self):
        """The same plug-in under another name brings styles that are there."""
        copy = os.path.join(self.root, "libtwice.so")
        shutil.copy(LIBRARY, copy)
        self.ended("the fix style `mp_pic/rewritten` of the plug-in stresses .* is brought by the plug-in stresses .* already", **{**own("plain"), "plugins": f'{PLUGINS} "{copy}"'})


class Resumed(ResumedRun, BoxTest):
    stop, end = 0.02, 0.04

    def test_is_the_run_that_was_not_stopped(self):
        replaced = {"wall/mp_pic": "wall/mp_pic/rewritten",
                    "fix move   all mp_pic ${stress}": "fix move all mp_pic/rewritten stress rewritten 100 3 close_packing 0.6"}  # fmt: skip
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                self.check_plugin(PLUGINS, replaced, ranks, method="MPPIC")
