# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure drop of the held packing against gas velocity, beside the drag law's own, and the velocity at which it
carries the packing: minimum fluidization.

Runs tools/run once per velocity; with --read, evaluates the runs that an earlier sweep left in --out.
Exit code 0 only when every run ended well and lies within --tolerance of the law.
"""

import argparse
import math
import os
import sys

from interphase import Case, InputError, Run, StepFailed, parameters
from interphase.command_line import positive
from interphase.drag_laws import LAWS
from interphase.uniform_suspension import Suspension

CASE = os.path.dirname(os.path.realpath(__file__))
REPOSITORY = os.path.dirname(os.path.dirname(CASE))
OUT = os.path.join(REPOSITORY, "runs", "packed-bed-sweep")
MEASURED_U_MF = 1.05  # m/s, SSCP-I particles: Liu and van Wachem, Powder Technol. 343 (2019) 145


class Scene:
    """The numbers of `parameters` in `folder`, and what follows from them; `at_rest`, by the drag law, None for a law not written down."""

    def __init__(self, folder):
        value = parameters.read(os.path.join(folder, parameters.PARAMETERS))
        weight, diameter, particle_density, self.voidage, density, viscosity, gravity, cells = (float(value[key]) for key in (
            "weight", "diameter", "particleDensity", "voidage", "gasDensity", "gasViscosity", "gravity", "cellsBed"))  # fmt: skip
        self.law = value["dragLaw"]
        self.weight_per_volume = (particle_density - density) * (1 - self.voidage) * gravity  # of the packing, less buoyancy [Pa/m]
        self.at_rest = Suspension(1 - self.voidage, diameter, particle_density, density, viscosity, self.law, gravity) if self.law in LAWS else None
        # as in system/blockMeshDict and couplingDict
        cell = 2 * (4 * math.pi / 6 * weight * diameter**3 / (1 - self.voidage)) ** (1 / 3)
        self.between_taps = (cells - 11) * cell  # [m]


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
    parser.add_argument("--velocities", nargs="+", type=positive, default=[0.3, 0.6, 0.9, 1.05, 1.2, 1.5], metavar="U",
                        help="superficial [m/s] (default 0.3 0.6 0.9 1.05 1.2 1.5)")  # fmt: skip
    parser.add_argument("--out", default=OUT, metavar="DIR", help="one folder per velocity goes there (default runs/packed-bed-sweep)")
    parser.add_argument("--read", action="store_true", help="run nothing, read the runs in --out")
    parser.add_argument("--ranks", type=int, default=1, metavar="N", help="of each run (default 1)")
    parser.add_argument("--method", help="handed to tools/run")
    parser.add_argument("--weight", metavar="W", help="handed to tools/run")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="handed to tools/run, e.g. voidage=0.45")
    parser.add_argument("--tolerance", type=float, default=1.0, metavar="PERCENT", help="allowed off the law (default 1)")
    return parser.parse_args()


def run(velocity, folder, options):
    entries = {"inletVelocity": f"{velocity:g}", **dict(setting.partition("=")[::2] for setting in options.set)}
    entries.update({name: text for name, text in (("method", options.method), ("weight", options.weight)) if text})
    try:
        ran = Case(CASE).set(entries).run(folder, ranks=options.ranks, overwrite=True, quiet=False)
    except (InputError, StepFailed) as error:
        sys.exit(f"sweep: {error}")
    if not ran.ok:
        sys.exit(f"sweep: the run at {velocity:g} m/s {ran.state}; its folder is {folder}")


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
        rows.append((velocity, drop, spread, drop / scene.between_taps, scene.at_rest and scene.at_rest.pressure_gradient(velocity)))

    weight = scene.weight_per_volume
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
    print(f"  simulated {shown(velocity_by_runs(points, weight))}, by the law {shown(scene.at_rest and scene.at_rest.carrying_velocity())}", end="")
    print(f", measured for the bed of SSCP-I {MEASURED_U_MF:g} m/s (Liu and van Wachem 2019)")
    if worst > options.tolerance:
        sys.exit(f"sweep: {worst:.2f} % off the drag law, more than the {options.tolerance:g} % allowed")


if __name__ == "__main__":
    main()
