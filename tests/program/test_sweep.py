# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 200
"""tools/sweep with the program itself: the pressure drop of a held packing over the velocity is Ergun's, and runs go on to a later end."""

import csv
import math
import os

import support

VOIDAGE, DIAMETER, DENSITY, VISCOSITY = 0.42, 3.256e-3, 1.204, 1.825e-5  # of cases/packed-bed
TAPS = 2 * (4 * math.pi / 6 * DIAMETER**3 / (1 - VOIDAGE)) ** (1 / 3)  # apart: a cell, in a packing of 12 [m]


def ergun(velocity):
    """Ergun, Chem. Eng. Prog. 48 (1952) 89: pressure gradient at a superficial velocity [m/s], Pa/m."""
    solids = 1 - VOIDAGE
    return (150 * VISCOSITY * solids**2 * velocity / DIAMETER**2 + 1.75 * DENSITY * solids * velocity**2 / DIAMETER) / VOIDAGE**3


class Sweep(support.ProgramTest):
    def sweep(self, *given):
        entries = {"inletVelocity": "0.2,0.4", "drag/law": "Ergun", "cellsAcross": 2, "cellsBed": 12}
        done = support.tool("sweep", os.path.join(support.SOURCE, "cases", "packed-bed"), *support.settings_of(entries), "--out",
                            os.path.join(self.root, "sweep"), *given)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with open(os.path.join(self.root, "sweep", "sweep.csv"), encoding="utf-8", newline="") as stream:
            rows = [row for row in csv.DictReader(stream) if row["quantity"] == "pressure_drop"]
        self.assertEqual([(row["inletVelocity"], row["unit"], row["runs"]) for row in rows], [("0.2", "Pa", "1"), ("0.4", "Pa", "1")])
        for row in rows:
            # The law itself but for what the gas's own steps leave; cases/packed-bed asserts 1 % over the whole bed.
            right = ergun(float(row["inletVelocity"])) * TAPS
            self.assertAlmostEqual(float(row["mean"]) / right, 1, delta=0.01)
        return done.stdout

    def test_pressure_drop_over_velocity(self):
        self.assertIn("2 to make", self.sweep("--until", "0.1", "--after", "0.05"))
        self.assertIn("2 to go on", self.sweep("--until", "0.12", "--after", "0.05"))
        self.assertIn("2 there", self.sweep("--until", "0.12"))
