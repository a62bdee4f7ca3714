# SPDX-License-Identifier: GPL-3.0-or-later
"""How fast the bed turns with the stirrer, what that takes, and how it mixes: the numbers of README.md, of runs of this case.

    cases/stirred-bed/turning runs/a runs/b ... [--from T]

  angular velocity   sum(r x v)/sum(r^2) about the vessel's axis, of the spheres within the blades' radius and between their lower and upper edge;
                     the mean over snapshots from T s on (default 0.2) with its standard error
  torque             of the blades on the particles about the vessel's axis (dem/blades.liggghts writes that on the blades, torque.txt); the mean from T s on
  mixing             of spheres that stand left and right of the middle plane at T: what is left after a further 0.5 s of the difference between their mean places
                     across, over that at T
"""

import argparse
import os
import sys

import numpy

from interphase import InputError, Run, ave_time, parameters, tables
from interphase.time_statistics import mean_with_error

MIXED_AFTER = 0.5  # s
TORQUE = "torque.txt"  # of dem/blades.liggghts: solid step, N m


def turning(snapshot, p):
    """rad/s."""
    r = snapshot.positions[:, :2] - (p["width"] / 2, p["depth"] / 2)
    v, height = snapshot.velocities, snapshot.positions[:, 2] - p["bladeClearance"]
    swept = ((r**2).sum(axis=1) < p["bladeRadius"] ** 2) & (height > 0) & (height < p["bladeHeight"])
    return (r[:, 0] * v[:, 1] - r[:, 1] * v[:, 0])[swept].sum() / (r[swept] ** 2).sum()


def torque(run, start):
    """N m, its mean from `start` s on with an error; None where the run has no record of it."""
    written = ave_time.read(run, TORQUE)
    return mean_with_error(-written[1][written[0] >= start, 0]) if written else None


def shown(mean, scale=1):
    return f"{scale * mean.value:.2f} +- {scale * mean.error:.2f}" + ("?" if mean.reason else "") if mean else "-"


def unmixed(first, then, width):
    """1: as at the start, 0: mixed."""
    left = set(first.ids[first.positions[:, 0] < width / 2])
    def apart(snapshot):
        mine = numpy.isin(snapshot.ids, list(left))
        return snapshot.positions[~mine, 0].mean() - snapshot.positions[mine, 0].mean()
    return apart(then) / apart(first)


def row(folder, start):
    run = Run(folder)
    p = {name: parameters.numbers(value) for name, value in parameters.read(os.path.join(folder, parameters.PARAMETERS)).items()}
    snapshots = [each for each in run.snapshots if each.time >= start - 1e-9]
    if len(snapshots) < 20:
        raise InputError(f"{folder}: {len(snapshots)} snapshots from {start:g} s on; 20 are needed for a mean with an error")
    mean = mean_with_error(numpy.array([turning(each, p) for each in snapshots]))
    later = [each for each in snapshots if each.time >= start + MIXED_AFTER - 1e-9]
    mixing = f"{unmixed(snapshots[0], later[0], p['width']):.2f}" if later else "-"
    return [run.meta["method"], f"{run.meta['weight']:g}", shown(mean), shown(torque(run, start), 1000), mixing,
            f"{run.meta['wall_time']:.0f}", os.path.basename(os.path.normpath(folder))]  # fmt: skip


def main():
    parser = argparse.ArgumentParser(prog="cases/stirred-bed/turning", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", metavar="RUN", nargs="+", help="folders of runs of this case")
    parser.add_argument("--from", metavar="T", dest="start", type=float, default=0.2, help="s (default 0.2)")
    given = parser.parse_args()
    rows = [["method", "W", "angular velocity [rad/s]", "torque [mN m]", "mixing", "wall [s]", "run"], *(row(each, given.start) for each in given.runs)]
    print("\n".join(tables.columns(rows, right=range(1, 6))))


if __name__ == "__main__":
    try:
        main()
    except InputError as error:
        sys.exit(f"cases/stirred-bed/turning: {error}")
