# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 600
"""A packed slug under an outlet that only gas may pass: held where the gas bears it, which is told; a bed below and one that falls are not."""

import re
import tempfile
import unittest

import support
import vessel

LAYERS, ALL_LAYERS = 10, int(vessel.HEIGHT / (1.02 * vessel.DIAMETER))
COUNTED = r"particles held under an outlet by the gas +([\d,]+)(?: +([\d.]+) % +(look at it)?)?"
TOLD = r't = 0\.04 s: look at "particles held under an outlet by the gas": [\d,]+, (2|3|4)\d %, in the last 100 gas steps'


class Held(support.ProgramTest):
    def ended(self, velocity, above, method="TDHS", ranks=1, edits=(), **settings):
        lines, _ = vessel.bed(LAYERS, above)
        folder = vessel.case(tempfile.mkdtemp(dir=self.root), lines, edits=edits)
        return self.run_case(vessel.prepared(self, folder, method, ranks, 0.06, inletVelocity=velocity, **settings), ranks)

    def counted(self, done):
        """Particles held, step by step, their share [%], and whether to look at it; the same number is in the records."""
        number, share, look = re.search(COUNTED, done.out).groups()
        self.assertEqual(int(number.replace(",", "")), done.column("ledger/held_at_outlet")[-1])
        return int(number.replace(",", "")), float(share or 0), bool(look)

    def test_a_slug_under_the_ceiling_is_told(self):
        """2.5 m/s are four times minimum fluidization. The uppermost cells are 6 mm high, three of ten layers; kernels, 5 mm wide, and the way to the ceiling, which
        takes some steps, leave a fifth at least."""
        for method, ranks in (("TDHS", 1), ("TDHS", 2), ("DEM", 1)):
            with self.subTest(method=method, ranks=ranks):
                done = self.ended(2.5, ALL_LAYERS - LAYERS, method, ranks)
                self.assertGreater(done.last()["position"][:, 2].mean(), 0.08)
                _, share, look = self.counted(done)
                self.assertGreater(share, 20)
                self.assertLess(share, 45)
                self.assertTrue(look)

    def test_by_other_steps_and_cells(self):
        """Cells of 9.6 mm hold five of the ten layers."""
        for name, edits, settings, most in (
            ("steps of 0.4 ms", (), {"system/controlDict:deltaT": 4e-4}, 45),
            ("steps of 2 ms", (), {"system/controlDict:deltaT": 2e-3}, 45),
            ("cells of 8 x 8 x 9.6 mm", [("system/blockMeshDict", r"\(8 4 16\)", "(6 3 10)")], {}, 60),
        ):
            with self.subTest(name):
                done = self.ended(2.5, ALL_LAYERS - LAYERS, edits=edits, **settings)
                _, share, look = self.counted(done)
                told = 0.06 >= 100 * settings.get("system/controlDict:deltaT", 1e-3)
                self.assertEqual(len(re.findall(TOLD, done.out)), told)
                self.assertGreater(share, 20)
                self.assertLess(share, most)
                self.assertTrue(look)

    def test_what_falls_or_lies_below_is_not(self):
        for name, velocity, above in (("falls", 0.3, ALL_LAYERS - LAYERS), ("lies", 0.3, 0), ("bubbles", 1.0, 0)):
            with self.subTest(name):
                done = self.ended(velocity, above)
                self.assertEqual(self.counted(done)[0], 0)
                self.assertNotIn("particles held under an outlet by the gas\"", done.out)


if __name__ == "__main__":
    unittest.main()
