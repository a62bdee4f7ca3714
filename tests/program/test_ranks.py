# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 600
"""Numbers of ranks differ by round-off and its growth only; what they exchange follows the particles that are on another
rank than their gas cell, not all particles.

The bed is chaotic, so a difference in the last bit grows. How fast is measured, not assumed: the yardstick is the same run
on one rank with one coordinate of one parcel changed by 1e-15 of its value.
"""

import os

import numpy

import measured
import support
from interphase import stored

STEPS = 50
LONGEST = 300  # [s], for four ranks on two busy cores: they wait for each other some thousand times in a gas step
GAS_STEP = 1e-3  # of the case [s]
HEIGHT = 1.2192  # of the vessel [m]: the size that differences are seen against


class RoundOffGrowth(support.ProgramTest):
    """The first 50 coupling steps of sscp1, the same dem/bed.data in each run."""

    # Parcels at the bottom, in the middle and near the surface of the bed.
    PERTURBED = (2000, 6000, 10000)

    # Both the rank runs and the yardsticks are draws of one chaotic process. In the steps when single contacts close or
    # open a step earlier, draws were seen to lie three decades apart (a difference of 1e-10 becomes one of 1e-7 in one
    # such event, and another run has it 10 steps later), and agree within a factor 3 else.
    SPREAD = 1e3

    def scene(self, name, ranks=1):
        """Gas solved to round-off: with the case's own tolerances ranks differ by what their solvers leave.

        The residual of p_rgh comes to stand at 6e-12, after 40 to 100 cycles; it never gets to this tolerance, and further
        cycles up to the number that ends them change nothing but the time.
        """
        folder = self.prepared(
            "sscp1", name, ranks, until=STEPS * GAS_STEP,
            **{"system/fvSolution:solvers/p_rgh/tolerance": 1e-13, "system/fvSolution:solvers/p_rgh/relTol": 0,
               'system/fvSolution:solvers/"(U|UFinal)"/tolerance': 1e-13},
        )  # fmt: skip
        self.edit(folder, "system/fvSolution", r"^ *smoother +GaussSeidel;$", "smoother GaussSeidel; maxIter 100;")
        self.set_entry(folder, "system/couplingDict", "records/snapshotInterval", 0.01)
        return folder

    def perturbed(self, number):
        folder = self.scene(f"perturbed{number}")
        path = os.path.join(folder, "dem/bed.data")
        lines = support.read(path).splitlines()
        at = lines.index("Atoms") + 1 + number
        words = lines[at].split()
        self.assertEqual(words[0], str(number))
        words[4] = repr(float(words[4]) * (1 + 1e-15))
        self.assertNotEqual(lines[at], " ".join(words))
        lines[at] = " ".join(words)
        support.write(path, "\n".join(lines) + "\n")
        return folder

    def positions(self, folder, ranks=1):
        """[time, particle, 3], rows by id."""
        snapshots = self.run_case(folder, ranks, LONGEST).snapshots()
        return numpy.stack([snapshots[time]["position"] for time in sorted(snapshots)])

    def test_ranks_agree_to_round_off_growth(self):
        one = self.positions(self.scene("one"))
        self.assertEqual(one.shape, (6, 11875, 3))

        def apart(other):
            self.assertEqual(other.shape, one.shape)
            return numpy.abs(other - one).max(axis=(1, 2)) / HEIGHT

        yardsticks = [apart(self.positions(self.perturbed(number))) for number in self.PERTURBED]
        yardstick = numpy.maximum.accumulate(numpy.max(yardsticks, axis=0))
        by_ranks = {ranks: apart(self.positions(self.scene(f"on{ranks}", ranks), ranks)) for ranks in (2, 4)}
        print("differences of positions relative to the vessel's height, every 10 coupling steps")
        print("  perturbed " + " ".join(f"{x:.0e}" for x in yardstick))
        for ranks, difference in by_ranks.items():
            print(f"  {ranks} ranks   " + " ".join(f"{x:.0e}" for x in difference))

        # The start is the same file, and ten steps on nothing has grown much: a mistake in the exchange would stand
        # out here by decades (a parcel falls by 4e-4 of the height in this time).
        for ranks, difference in by_ranks.items():
            self.assertEqual(difference[0], 0, f"{ranks} ranks start from other positions")
            measured.below(self, f"bubbling bed (cases/sscp1), {ranks} ranks against 1: positions apart after 10 gas steps, of the vessel's height",
                           difference[1], 1e-10, "", "one rank")
            # below the floor both are round-off of the positions themselves
            allowed = numpy.maximum(self.SPREAD * yardstick, 1e-14)
            self.assertTrue((difference <= allowed).all(), f"{ranks} ranks: {difference} above {allowed}")
            measured.below(self, f"the same after 50 gas steps, of what a change of one coordinate by 1e-15 makes of a run on 1 rank ({yardstick[-1]:.0e})",
                           difference[-1] / yardstick[-1], self.SPREAD, "", "growth of round-off")
        # ... and the yardstick itself is one: it starts at round-off, and 50 steps do not make the runs unrelated
        self.assertLess(yardstick[0], 1e-15)
        self.assertLess(yardstick[-1], 1e-2)


class ExchangeVolume(support.ProgramTest):
    """Counted in bytes on two ranks. The gas is split along x by the case's decomposeParDict."""

    STEPS = 20
    MATCHING, ACROSS = "2 1 1", "1 2 1"  # LIGGGHTS's split: as the gas, and along y

    def volume(self, split, particles=95000, sideways=None):
        """Bytes sent in all coupling steps, by all ranks."""
        name = f"{split.replace(' ', '')}-{particles}-{sideways}"
        folder = self.prepared("sscp1", name, 2, until=self.STEPS * GAS_STEP, particleCount=particles)
        self.edit(folder, "dem/in.liggghts", r"^processors .*$", f"processors {split}")
        if sideways:
            self.edit(folder, "dem/in.liggghts", r"^read_data .*$", f"read_data dem/bed.data\nvelocity all set {sideways} 0 0")
        return stored.attributes(self.run_case(folder, 2).path("results.h5"), "exchange")["bytes_sent"]

    def test_volume_follows_the_particles_that_are_elsewhere(self):
        """Where both engines cut the vessel alike, only gas cells at the cut are exchanged: no more for twice the
        particles. Where LIGGGHTS cuts along y, half of the parcels have their gas cell on the other rank, and
        the volume grows with their number."""
        cells_only = self.volume(self.MATCHING)
        # but for the few parcels next to the cut that drift over it in the time
        self.assertAlmostEqual(self.volume(self.MATCHING, 47500) / cells_only, 1, delta=1e-3)
        all_across = self.volume(self.ACROSS) - cells_only
        half_across = self.volume(self.ACROSS, 47500) - cells_only
        # Half of the parcels lie beyond the cut but for the lattice's raggedness: two rows of about 120.
        self.assertAlmostEqual(all_across / half_across, 2, delta=0.1)
        per_visit = all_across / (self.STEPS * 11875 / 2)
        print(f"cells at the cut {cells_only / self.STEPS:.0f} bytes a step, {per_visit:.0f} bytes a particle elsewhere and step")
        # an id, a record and an answer, some tens of numbers: no particle's data travel twice
        self.assertLess(per_visit, 400)

        # Parcels that drift across the cut at 0.3 m/s stay with their LIGGGHTS rank until its lists are renewed, which
        # is when one of them has gone half the skin, a quarter of the diameter: no more can be elsewhere than lie
        # within that of the cut.
        crossing = self.volume(self.MATCHING, sideways=0.3) - cells_only
        self.assertGreater(crossing, 0)
        skin = 0.25 * 6.512e-3
        self.assertLess(crossing, per_visit * self.STEPS * 11875 * skin / 0.2286)
        print(f"drifting parcels: {crossing / all_across:.2%} of what half of them elsewhere cost")
