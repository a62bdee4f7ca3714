# SPDX-License-Identifier: GPL-3.0-or-later
"""The check that momentum and solid volume balance over a run of cases/sscp1, at some length and numbers of ranks."""

import numpy

import measured
import support

# Round-off: the ledger sums some 1e4 particles and 5e3 cells a step, relative to what has been exchanged.
CLOSED = 1e-12
GAS_STEP = 1e-3  # of the case [s]


class BalancesOfSscp1:
    """CGPM with parcels of 8; `steps` coupling steps."""

    steps = None

    def check(self, ranks):
        folder = self.prepared("sscp1", ranks=ranks, until=self.steps * GAS_STEP)
        done = self.run_case(folder, ranks, timeout=max(support.LONGEST, self.steps))
        ledger = done.table("ledger")
        total, weight = (done.meta[name] for name in ("particles", "bed_weight_per_area"))
        drop = done.column("series/pressure_drop")[1:].mean()  # [Pa]; the start has none of the bed's
        count = len(ledger["time"])
        self.assertEqual(count, self.steps)
        numpy.testing.assert_allclose(ledger["time"], GAS_STEP * numpy.arange(1, count + 1), rtol=1e-9)
        self.assertEqual(float(total), 95000 / 8)
        for balance in ("momentum_residual", "volume_residual"):
            worst = int(ledger[balance].argmax())
            self.assertTrue(numpy.isfinite(ledger[balance]).all(), balance)
            name = balance.replace("volume", "solid volume").replace("_", " ").replace("residual", "imbalance")
            measured.below(self, f"bubbling bed of 95,000 spheres as 11,875 parcels (cases/sscp1), {self.steps} steps, ranks: {ranks}: {name}",
                           ledger[balance][worst], CLOSED, "", "conservation")
        # A ledger of zeros would balance, too. What is asked for is that momentum was exchanged, not that books are off by a
        # round-off: the gas carried at least half of the bed (the rest falls or lies on the floor), and the bed moved.
        self.assertGreater(drop, 0.5 * weight)
        moved = done.snapshots()
        start, end = moved[min(moved)]["position"], moved[max(moved)]["position"]
        self.assertGreater(float(numpy.linalg.norm(end - start, axis=1).max()), 1e-3)
        # no particle leaves the mesh, and what the program did to cells above the packing limit is on record
        self.assertEqual(ledger["particles_outside_mesh"].max(), 0)
        for name in ("cells_relieved", "beyond_drag_range"):
            self.assertTrue((numpy.diff(ledger[name]) >= 0).all(), f"{name} counts up")

    def test_one_rank(self):
        self.check(1)

    def test_two_ranks(self):
        self.check(2)

    def test_four_ranks(self):
        self.check(4)
