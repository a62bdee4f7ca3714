# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure drop of the held packing against gas velocity, beside the drag law's own, and the velocity at which it
carries the packing: minimum fluidization.

Runs tools/run once per velocity; with --read, evaluates the runs that an earlier sweep left in --out.
Exit code 0 only when every run ended well and lies within --tolerance of the law.
"""

import argparse
import math
import os
import subprocess
import sys

from interphase import parameters
from interphase.drag_laws import LAWS
from interphase.run import Run

CASE = os.path.dirname(os.path.realpath(__file__))
REPOSITORY = os.path.dirname(os.path.dirname(CASE))
RUN = os.path.join(REPOSITORY, "tools", "run")
OUT = os.path.join(REPOSITORY, "runs", "packed-bed-sweep")
MEASURED_U_MF = 1.05  # m/s, SSCP-I particles: Liu and van Wachem, Powder Technol. 343 (2019) 145


class Scene:
    """The numbers of `parameters` in `folder`, and what follows from them."""

    NUMBERS = (
        "weight", "diameter", "particleDensity", "voidage", "gasDensity", "gasViscosity", "gravity", "cellsBed",
    )  # fmt: skip

    def __init__(self, folder):
        value = parameters.read(os.path.join(folder, parameters.PARAMETERS))
        self.law = value["dragLaw"]
        for key in self.NUMBERS:
            setattr(self, key, float(value[key]))
        # as in system/blockMeshDict and couplingDict
        cell = 2 * (4 * math.pi / 6 * self.weight * self.diameter**3 / (1 - self.voidage)) ** (1 / 3)
        self.between_taps = (self.cellsBed - 11) * cell

    def gradient(self, velocity):
        """Of the pressure by the drag law [Pa/m] at superficial `velocity` [m/s]; None for a law not written here.

        Steady uniform flow: -eps dp/dz = beta U/eps.
        """
        if self.law not in LAWS:
            return None
        re_ = self.gasDensity * velocity * self.diameter / self.gasViscosity
        factor = LAWS[self.law](self.voidage, re_)
        return 18 * self.gasViscosity * (1 - self.voidage) * factor * velocity / (self.voidage * self.diameter**2)

    def weight_per_volume(self):
        """Of the packing, less buoyancy [Pa/m]."""
        return (self.particleDensity - self.gasDensity) * (1 - self.voidage) * self.gravity


def velocity_by_law(scene):
    """Where the law's gradient meets the weight [m/s]; None for a law not written here."""
    low, high = 1e-6, 1e3
    if scene.gradient(low) is None:
        return None
    for _ in range(200):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if scene.gradient(middle) < scene.weight_per_volume() else (low, middle)
    return low


def velocity_by_runs(points, weight):
    """Where the simulated gradient meets `weight` [m/s]; None when the runs do not enclose it.

    Between two runs gradient/U is taken linear in U, as for any sum of a viscous and an inertial part.
    """
    points = sorted(points)
    for (u1, g1), (u2, g2) in zip(points, points[1:]):
        if g1 <= weight <= g2:
            slope = (g2 / u2 - g1 / u1) / (u2 - u1)
            start = g1 / u1 - slope * u1
            if abs(slope) * u2 < 1e-12 * start:
                return weight / start
            return (-start + math.sqrt(start**2 + 4 * slope * weight)) / (2 * slope)
    return None


def mean_pressure_drop(folder):
    """Over the second half of the run [Pa], and the spread (standard deviation) in it."""
    series = Run(folder).series["pressure_drop"]
    drop = series.between(after=0.5 * series.time[-1]).values
    return float(drop.mean()), float(drop.std())


def arguments():
    parser = argparse.ArgumentParser(prog="sweep", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--velocities", nargs="+", type=float, default=[0.3, 0.6, 0.9, 1.05, 1.2, 1.5], metavar="U",
        help="superficial [m/s] (default 0.3 0.6 0.9 1.05 1.2 1.5)",
    )  # fmt: skip
    parser.add_argument(
        "--out", default=OUT, metavar="DIR", help="one folder per velocity goes there (default runs/packed-bed-sweep)"
    )
    parser.add_argument("--read", action="store_true", help="run nothing, read the runs in --out")
    parser.add_argument("--ranks", default="1", metavar="N", help="of each run (default 1)")
    parser.add_argument("--method", help="handed to tools/run")
    parser.add_argument("--weight", metavar="W", help="handed to tools/run")
    parser.add_argument(
        "--set", action="append", default=[], metavar="KEY=VALUE", help="handed to tools/run, e.g. voidage=0.45"
    )
    parser.add_argument(
        "--tolerance", type=float, default=1.0, metavar="PERCENT", help="allowed off the law (default 1)"
    )
    options = parser.parse_args()
    if min(options.velocities) <= 0:
        parser.error(f"velocities must be positive, got {min(options.velocities):g} m/s")
    return options


def run(velocity, folder, options):
    command = [RUN, CASE, "--ranks", options.ranks, "--out", folder, "--overwrite", "--no-picture"]
    command += ["--set", f"inletVelocity={velocity:g}"]
    for name in ("method", "weight"):
        if getattr(options, name):
            command += [f"--{name}", getattr(options, name)]
    for setting in options.set:
        command += ["--set", setting]
    code = subprocess.run(command).returncode
    if code != 0:
        sys.exit(f"sweep: the run at {velocity:g} m/s ended with exit code {code}; its folder is {folder}")


def main():
    options = arguments()
    points, rows = [], []
    for velocity in sorted(set(options.velocities)):
        folder = os.path.join(options.out, f"U{velocity:g}")
        if not options.read:
            run(velocity, folder, options)
        elif not os.path.exists(os.path.join(folder, "results.h5")):
            sys.exit(f"sweep: there is no run to read at {velocity:g} m/s: {folder} has no results.h5")
        scene = Scene(folder)
        drop, spread = mean_pressure_drop(folder)
        points.append((velocity, drop / scene.between_taps))
        rows.append((velocity, drop, spread, drop / scene.between_taps, scene.gradient(velocity)))

    weight = scene.weight_per_volume()
    print(f"\ndrag law {scene.law}, voidage {scene.voidage:g}, taps {scene.between_taps:.4f} m apart")
    print("U [m/s]   drop [Pa]   spread   drop/L [Pa/m]   law [Pa/m]     off   carries")
    worst = 0.0
    for velocity, drop, spread, gradient, law in rows:
        against = "         -       -"
        if law is not None:
            off = 100 * (gradient / law - 1)
            worst = max(worst, abs(off))
            against = f"{law:10.1f} {off:+6.2f}%"
        carried = f"{100 * gradient / weight:8.1f}%"
        print(f"{velocity:7.3f} {drop:11.2f} {spread:8.2g} {gradient:15.1f}   {against} {carried}")

    def shown(velocity):
        return "-" if velocity is None else f"{velocity:.3f} m/s"

    print(f"minimum fluidization, where drop/L = (rho_p - rho_g)(1 - eps) g = {weight:.1f} Pa/m:")
    print(f"  simulated {shown(velocity_by_runs(points, weight))}, by the law {shown(velocity_by_law(scene))}", end="")
    print(f", measured for the bed of SSCP-I {MEASURED_U_MF:g} m/s (Liu and van Wachem 2019)")
    if worst > options.tolerance:
        sys.exit(f"sweep: {worst:.2f} % off the drag law, more than the {options.tolerance:g} % allowed")


if __name__ == "__main__":
    main()
