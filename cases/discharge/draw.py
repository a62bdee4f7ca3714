# SPDX-License-Identifier: GPL-3.0-or-later
"""Draw two runs of `run` side by side: spheres at three times, in stripes by the height they lay at before the opening, and what has left.

    cases/discharge/draw runs/discharge/dem-0.05tc-seed1 runs/discharge/tdhs-1tc-seed1 --out discharge.png
"""

import argparse
import os

import matplotlib

matplotlib.use("Agg")

import numpy  # noqa: E402
from matplotlib import pyplot  # noqa: E402
from matplotlib.collections import EllipseCollection  # noqa: E402

import discharge as run  # noqa: E402



def spheres(axes, run, rows, layers, depth):
    """Those in the front half, drawn from behind."""
    d = run.DIAMETER
    shown = rows[rows[:, 2] < 0.5 * depth]
    shown = shown[numpy.argsort(-shown[:, 2])]
    axes.add_collection(EllipseCollection(
        numpy.full(len(shown), d), numpy.full(len(shown), d), numpy.zeros(len(shown)), units="xy",
        offsets=shown[:, [1, 3]], transOffset=axes.transData, cmap="viridis", array=layers[shown[:, 0].astype(int)],
        linewidths=0,
    ))  # fmt: skip
    left, right = 0.5 * (run.WIDTH - run.SLOT), 0.5 * (run.WIDTH + run.SLOT)
    for x in ((0, left), (right, run.WIDTH)):
        axes.plot(x, (0, 0), "k", lw=1.5)
    axes.plot((0, 0), (0, 20 * d), "k", (run.WIDTH, run.WIDTH), (0, 20 * d), "k", lw=1)
    axes.set(xlim=(-d, run.WIDTH + d), ylim=(-8 * d, 17 * d), aspect="equal", xticks=[], yticks=[])


def main():
    parser = argparse.ArgumentParser(prog="draw", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs=2, metavar="RUN")
    parser.add_argument("--out", default="discharge.png", metavar="FILE")
    options = parser.parse_args()
    figure = pyplot.figure(figsize=(11, 4.2), layout="constrained")
    grid = figure.add_gridspec(2, 4, width_ratios=(1, 1, 1, 1.1))
    curves = figure.add_subplot(grid[:, 3])
    for row, folder in enumerate(options.folders):
        name = os.path.basename(os.path.normpath(folder)).split("-")[0].upper()
        t, above, _ = numpy.loadtxt(os.path.join(folder, "record.txt"), skiprows=1).T
        curves.plot(t - run.FILL, 1e3 * run.MASS * (above[0] - above), label=name, ls="-" if row == 0 else "--")
        frames = list(run.snapshots(os.path.join(folder, "snapshots.dump")))
        layers = numpy.zeros(int(frames[0][1][:, 0].max()) + 1)
        filled = frames[round(run.FILL / run.SNAPSHOT)][1]
        layers[filled[:, 0].astype(int)] = numpy.floor(filled[:, 3] / (2 * run.DIAMETER)) % 2
        start = round(run.FILL / run.SNAPSHOT)
        for column, frame in enumerate((start + 1, start + 3, start + 11)):
            axes = figure.add_subplot(grid[row, column])
            spheres(axes, run, frames[frame][1], layers, run.scene_of(folder)["depth"])
            axes.set_title(f"{name}, {frame * run.SNAPSHOT - run.FILL:.2f} s", fontsize=9)
    curves.set(xlabel="time since the opening [s]", ylabel="discharged [g]", xlim=(0, None), ylim=(0, None))
    curves.legend(frameon=False)
    figure.savefig(options.out, dpi=100)


if __name__ == "__main__":
    main()
