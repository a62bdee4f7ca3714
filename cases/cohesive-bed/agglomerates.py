# SPDX-License-Identifier: GPL-3.0-or-later
"""What cohesion does to the bed: the table and the picture of README.md, of runs of this case.

    cases/cohesive-bed/agglomerates runs/a runs/b ... [--out bed.png]

Two particles hold together where they touch (gap below 0.02 diameters of what is tracked) in two snapshots one after the other; an agglomerate is what holds
together.

  at rest       solid fraction phi before the gas comes: of all below twice the centre of mass
  lifts at      highest pressure drop, mean of 10 ms, over the weight of the bed, while the gas speeds up and until the bed's height has grown by a tenth,
                and the superficial velocity then [m/s]; >: it has not grown so far
  floor, sides  what could hold the bed down, over its weight: the pull-off forces of all that touch the floor, and friction by those of all that touch the sides
  drop, swing   mean and deviation of the pressure drop over the weight once the gas has its velocity
  height        twice the centre of mass then [mm]
  bonds         contacts that last, for each particle
  singles       share of particles that hold to no other one
  largest       share of particles in the largest agglomerate
"""

import argparse
import dataclasses
import os
import sys

import numpy
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from interphase import InputError, Run, parameters, tables
from interphase.time_statistics import mean_with_error

TOUCHING = 0.02  # gap, in diameters
SMOOTHED = 0.01  # s
HEADS = ["Bo", "W", "at rest", "lifts at", "[m/s]", "floor", "sides", "drop", "swing", "height [mm]", "bonds", "singles", "largest", "run"]


def numbers_of(run):
    return {name: parameters.numbers(value) for name, value in parameters.read(os.path.join(run.path, parameters.PARAMETERS)).items()}


def height_of(series, p):
    """Twice the centre of mass above the floor of the particles, which is not the mesh's: a series [m]."""
    found = series["bed_height"]
    return dataclasses.replace(found, values=found.values - 2 * p["below"])


def holds(snapshot, p):
    """What could hold a bed at rest down, over its weight: (bonds to the floor, friction along the sides by the bonds to them)."""
    reach = (0.5 + TOUCHING) * p["diameter"] * p["weight"] ** (1 / 3)
    x, _, z = snapshot.positions.T
    bond = p["bondNumber"] / len(x)
    return bond * (z < reach).sum(), bond * p["wallFriction"] * ((x < reach) | (p["width"] - x < reach)).sum()


def contacts(snapshot, diameter, depth):
    """{(id, id)} of spheres that touch, as numbers of one integer for each pair; y repeats."""
    place = snapshot.positions.copy()
    place[:, 1] %= depth
    pairs = cKDTree(place, boxsize=[0, depth, 0]).query_pairs((1 + TOUCHING) * diameter, output_type="ndarray")
    ids = numpy.sort(snapshot.ids[pairs].astype(numpy.int64), axis=1)
    return ids[:, 0] * 2**32 + ids[:, 1]


def lasting(snapshots, p):
    """[pairs, 2] of ids that touch in both of two snapshots."""
    diameter = p["diameter"] * p["weight"] ** (1 / 3)
    both = numpy.intersect1d(*(contacts(each, diameter, p["depth"]) for each in snapshots))
    return numpy.stack([both // 2**32, both % 2**32], axis=1)


def sizes(ids, pairs):
    """How many are in the agglomerate of each of `ids` [n]."""
    order = numpy.argsort(ids)
    i, j = order[numpy.searchsorted(ids[order], pairs)].T
    n = len(ids)
    _, member = connected_components(coo_matrix((numpy.ones(len(i)), (i, j)), shape=(n, n)), directed=False)
    return numpy.bincount(member)[member]


def smoothed(series, p):
    """(time, pressure drop over the weight) of a run, means of SMOOTHED."""
    count = max(1, round(SMOOTHED / p["recordInterval"]))
    ratio = series["pressure_drop"].values / series["bed_weight_per_area"].values
    kernel = numpy.ones(count) / count
    return numpy.convolve(series["pressure_drop"].time, kernel, "valid"), numpy.convolve(ratio, kernel, "valid")


def velocity(time, p):
    """Superficial, of the gas that comes in [m/s]."""
    return p["inletVelocity"] * numpy.clip((time - p["rampStart"]) / (p["rampEnd"] - p["rampStart"]), 0, 1)


def lift(run, p):
    """(highest pressure drop over the weight before the bed's height has grown by a tenth, time of it [s], whether it has grown so far) of the ramp."""
    height = height_of(run.series, p)
    grown = height.time[(height.time > p["rampStart"]) & (height.values > 1.1 * height.between(until=p["rampStart"]).values[-1])]
    end = min([p["rampEnd"], *grown[:1]])
    time, ratio = smoothed(run.series, p)
    before = (time > p["rampStart"]) & (time <= end)
    highest = numpy.flatnonzero(before)[ratio[before].argmax()]
    return ratio[highest], time[highest], end < p["rampEnd"]


def with_error(values, digits):
    found = mean_with_error(numpy.asarray(values))
    return f"{found.value:.{digits}f} +- {found.error:.{digits}f}" + "?" * bool(found.reason)


def row(run):
    p, series = numbers_of(run), run.series
    floor, sides = holds([each for each in run.snapshots if each.time < p["rampStart"] + 1e-9][-1], p)
    snapshots = [each for each in run.snapshots if each.time > p["rampEnd"] + 1e-9]
    if len(snapshots) < 3:
        raise InputError(f"{run.path}: {len(snapshots)} snapshots after the gas has its velocity at {p['rampEnd']:g} s; three are needed")
    lifting, moment, lifted = lift(run, p)
    drop, height = series["pressure_drop"], height_of(series, p)
    then = drop.time > p["rampEnd"]
    over_weight = drop.values[then] / series["bed_weight_per_area"].values[then]
    solids = p["particleCount"] * numpy.pi / 6 * p["diameter"] ** 3 / (p["width"] * p["depth"])
    phi = solids / height.between(until=p["rampStart"]).values[-1]
    held = [(each.ids, lasting((each, after), p)) for each, after in zip(snapshots, snapshots[1:])]
    grown = [sizes(*one) for one in held]
    return [f"{p['bondNumber']:g}", f"{p['weight']:g}", f"{phi:.3f}", f"{'' if lifted else '> '}{lifting:.2f}", f"{velocity(moment, p):.2f}", f"{floor:.2f}",
            f"{sides:.2f}", with_error(over_weight, 3), f"{over_weight.std():.3f}", with_error(1e3 * height.values[height.time > p["rampEnd"]], 1),
            f"{numpy.mean([2 * len(pairs) / len(ids) for ids, pairs in held]):.2f}", f"{numpy.mean([(size == 1).mean() for size in grown]):.3f}",
            f"{numpy.mean([size.max() / len(size) for size in grown]):.3f}", os.path.basename(run.path)]  # fmt: skip


def draw(runs, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import colors, pyplot
    from matplotlib.collections import EllipseCollection

    figure = pyplot.figure(figsize=(1.2 * len(runs) + 5, 4.6), layout="constrained")
    grid = figure.add_gridspec(1, len(runs) + 1, width_ratios=[1] * len(runs) + [3.4])
    curves = figure.add_subplot(grid[-1])
    scale = colors.LogNorm(1, 1000)
    for k, run in enumerate(runs):
        p = numbers_of(run)
        snapshots = list(run.snapshots)[-2:]
        last, diameter = snapshots[0], p["diameter"] * p["weight"] ** (1 / 3)
        shown = numpy.argsort(-last.positions[:, 1])  # from the front
        axes = figure.add_subplot(grid[k], aspect="equal", xlim=(0, 1e3 * p["width"]), ylim=(-1, 1e3 * p["height"]), xticks=[], title=f"Bo {p['bondNumber']:g}, W {p['weight']:g}")
        axes.title.set_fontsize(9)
        spheres = axes.add_collection(EllipseCollection(
            numpy.full(len(shown), 1e3 * diameter), numpy.full(len(shown), 1e3 * diameter), numpy.zeros(len(shown)), units="xy", cmap="viridis", norm=scale,
            offsets=1e3 * last.positions[shown][:, [0, 2]], transOffset=axes.transData, array=sizes(last.ids, lasting(snapshots, p))[shown], linewidths=0,
        ))  # fmt: skip
        if k:
            axes.set_yticks([])
        else:
            axes.set_ylabel("height [mm]")
        time, ratio = smoothed(run.series, p)
        ramp = (time > p["rampStart"]) & (time < p["rampEnd"])
        curves.plot(velocity(time[ramp], p), ratio[ramp], lw=1, label=axes.get_title())
    figure.colorbar(spheres, ax=axes, label="particles or parcels in the agglomerate", fraction=0.25, aspect=40)
    curves.axhline(1, color="0.7", lw=0.8)
    curves.set(xlabel="superficial velocity, rising [m/s]", ylabel="pressure drop over the bed's weight", xlim=(0, None), ylim=(0, None))
    curves.legend(frameon=False, fontsize=8)
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(prog="cases/cohesive-bed/agglomerates", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", metavar="RUN", nargs="+", help="folders of runs of this case")
    parser.add_argument("--out", metavar="FILE", help="draw them side by side, and their pressure drop against the velocity")
    given = parser.parse_args()
    runs = [Run(each) for each in given.runs]
    for run in runs:
        if not run.ok:
            raise InputError(f"{run.path}: the run has not come to its end, it is {run.state}; its means are not those of the page")
    print("\n".join(tables.columns([HEADS, *(row(each) for each in runs)], right=range(len(HEADS) - 1))))
    if given.out:
        draw(runs, given.out)


if __name__ == "__main__":
    try:
        main()
    except InputError as error:
        sys.exit(f"cases/cohesive-bed/agglomerates: {error}")
