# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured trades: what is near to a scene, what is warned of, which method is named, and what is said where nothing was measured."""

import csv
import os
import unittest

from interphase import evidence, plan_choice
from interphase.input_error import InputError
from interphase.plan_choice import Planned
from scratch import InFolder

LIKE_SSCP1 = {"velocity_over_minimum": 2.0, "archimedes": 1.4e6, "parcel_over_depth": 0.0855, "parcel_over_cell": 0.41}
TRADES = evidence.everything()


def planned(method, weight, wall, steps=1.0, **numbers):
    return Planned(method, weight, steps, wall, {**LIKE_SSCP1, **numbers})


PARTICLES = {"parcel_over_depth": 0.0427, "parcel_over_cell": 0.207}
ALL = [planned("MPPIC", 8, 100, None), planned("CGHS", 8, 150), planned("TDHS", 1, 1500, **PARTICLES), planned("DEM", 1, 10000, 20, **PARTICLES)]


class Tables(InFolder):
    def write(self, **changed):
        path = os.path.join(self.root, "trades.csv")
        values = {name: getattr(TRADES[0], name) for name in evidence.COLUMNS}
        with open(path, "w", newline="", encoding="utf-8") as stream:
            rows = csv.DictWriter(stream, evidence.COLUMNS)
            rows.writeheader()
            rows.writerow({**values, **changed})
        return path

    def test_what_is_written_is_read(self):
        self.assertEqual(evidence.read(self.write()), [TRADES[0]])
        self.assertIsNone(evidence.read(self.write(error=""))[0].error)

    def test_bad_tables(self):
        with self.assertRaisesRegex(InputError, r"trades.csv, line 2: deviation = 'much' is no number"):
            evidence.read(self.write(deviation="much"))
        path = os.path.join(self.root, "other.csv")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write("scene,method\n")
        with self.assertRaisesRegex(InputError, "lacks the columns weight"):
            evidence.read(path)


class Near(unittest.TestCase):
    def test_its_own_scene_is_near(self):
        self.assertEqual({each.scene for each in ALL[1].near(TRADES)}, {"sscp1"})

    def test_another_is_said_to_be_far_by_what(self):
        fine = planned("CGHS", 8, 10, archimedes=20.0)
        self.assertEqual(fine.near(TRADES), [])
        self.assertRegex(plan_choice.nothing_near(fine, TRADES), r"nearest is \S+: .*Ar \S+ there, 20 here")

    def test_long_steps_are_no_evidence_of_short_ones(self):
        self.assertEqual({each.steps_per_collision for each in ALL[2].near(TRADES)}, {1.0})

    def test_wide_parcels_are_warned_of(self):
        """van-wachem: CGHS lost half of the pressure's deviation with parcels of 0.31 of the depth, 63 % with 0.39."""
        self.assertEqual(evidence.warnings(TRADES, "TDHS", 0.5), [])
        said = " ".join(evidence.warnings(TRADES, "CGHS", 0.4))
        self.assertIn("van-wachem, parcels of W = 8, 0.39 of the depth: pressure_drop_deviation -63 +- 2 % of DEM", said)
        self.assertFalse([words for words in evidence.warnings(TRADES, "CGHS", 0.09) if "pressure_drop_deviation" in words])
        self.assertIn("pressure_drop_deviation -77", " ".join(evidence.warnings(TRADES, "MPPIC", 0.09)))


class Choice(unittest.TestCase):
    def test_the_cheapest_within_an_accuracy(self):
        """On sscp1 MP-PIC has a quarter of TDHS's deviation of the pressure, CGHS 89 +- 10 %."""
        chosen, lines = plan_choice.cheapest(ALL, TRADES, [("pressure_drop_deviation", 0.35)], None)
        self.assertEqual(chosen.method, "CGHS")
        self.assertRegex(lines[0], r"MPPIC W = 8: not within: sscp1 .*at worst 83 %, above 35 %")

    def test_a_budget_that_is_too_small_for_it(self):
        chosen, lines = plan_choice.cheapest(ALL, TRADES, [("pressure_drop_deviation", 0.3)], 120)
        self.assertIsNone(chosen)
        self.assertIn("no method is known to be that accurate", lines[-1])
        chosen, lines = plan_choice.cheapest(ALL, TRADES, [], 5)
        self.assertIsNone(chosen)
        self.assertRegex(lines[0], r"none is done in 5 s: the cheapest, MPPIC W = 8, takes 100 s. Take larger parcels")

    def test_only_a_budget(self):
        self.assertEqual(plan_choice.cheapest(ALL, TRADES, [], 200)[0].method, "CGHS")
        self.assertEqual(plan_choice.cheapest(ALL, TRADES, [], 1e6)[0].method, "DEM")

    def test_nothing_is_guessed(self):
        far = [planned(each.method, each.weight, each.wall, each.steps_per_collision, archimedes=20.0) for each in ALL[:3]]
        chosen, lines = plan_choice.cheapest(far, TRADES, [("pressure_drop", 0.3)], None)
        self.assertIsNone(chosen)
        self.assertIn("CGHS W = 8: not known: nothing near was measured of its pressure_drop", lines[1])

    def test_words_of_the_command_line(self):
        self.assertEqual([plan_choice.duration(text) for text in ("2h", "90 min", "30s", "1.5 d")], [7200, 5400, 30, 129600])
        self.assertEqual(plan_choice.accuracy("pressure_drop 5%", TRADES), ("pressure_drop", 0.05))
        for function, words in ((plan_choice.duration, ("2", "0h", "soon", "-1h")), (lambda text: plan_choice.accuracy(text, TRADES), ("pressure_drop", "pressure_drop -5%", "5%"))):
            for word in words:
                with self.assertRaises(InputError):
                    function(word)
        with self.assertRaisesRegex(InputError, "did you mean 'pressure_drop"):
            plan_choice.accuracy("presure_drop 5%", TRADES)


if __name__ == "__main__":
    unittest.main()
