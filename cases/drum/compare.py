# SPDX-License-Identifier: GPL-3.0-or-later
"""Torque, angle of the surface and mixing of a turning drum: the table and the picture of README.md, of runs of this case.

    cases/drum/compare runs/a runs/b ... [--from T] [-o compare.png]

The first run is the one that others are held against. Means are over snapshots from T s on (default 1), with standard errors.

  torque     of the drum on the particles about its axis, with the turn: the moment of their weight, and by how much their angular momentum
             (of their motion and their spin) changes in the time of the mean [mN m]
  power      torque x angular velocity [mW]
  mesh       the same torque as LIGGGHTS sums it up of the contacts with the drum, in each solid step (torque.txt) [mN m]
  angle      of the free surface: of a line by least squares through its height in the columns within half a radius of the axis. Columns are a real
             diameter wide and as long as the drum; the height is where, from above, their solid fraction first passes 0.3, spheres counted by 64 points
             in each [deg]
  mixing     Lacey's index, 0 apart to 1 mixed, half a turn after spheres left and right of their middle were marked; cells of the cross-section four real
             diameters wide, weighted by what is in them. Each snapshot is taken for a start, as far as there is one half a turn later
  CPU        seconds of the processor
"""

import argparse
import math
import os
import sys

import numpy

from interphase import InputError, Run, ave_time, parameters, tables
from interphase.time_statistics import Mean, difference, mean_with_error

TORQUE = "torque.txt"  # of dem/scene.liggghts: solid step, N m
SURFACE = 0.3  # solid fraction
APART = 4  # real diameters, the width of a cell for mixing
POINTS = 64
CURVE = 0.1  # s between the starts of which the curves of mixing are means


class Drum:
    """What snapshots of the run in `folder` tell from `start` [s] on. Turning is positive as the drum turns, about -y."""

    def __init__(self, folder, start):
        self.run = Run(folder)
        self.name = os.path.basename(os.path.normpath(folder))
        self.p = {name: parameters.numbers(value) for name, value in parameters.read(os.path.join(folder, parameters.PARAMETERS)).items()}
        snapshots = [each for each in self.run.snapshots if each.time >= start - 1e-9]
        if len(snapshots) < 20:
            raise InputError(f"{folder}: {len(snapshots)} snapshots from {start:g} s on; 20 are needed for a mean with an error")
        self.time = numpy.array([each.time for each in snapshots])
        self.moment, self.momentum, self.tangent, self.heights, places = [], [], [], [], []
        for each in snapshots:
            data = each.arrays()
            x, v, diameter = data["position"], data["velocity"], data["diameter"]
            mass = data["density"] * math.pi / 6 * diameter**3
            self.moment.append((mass * x[:, 0]).sum() * self.p["gravity"])
            self.momentum.append((mass * (x[:, 0] * v[:, 2] - x[:, 2] * v[:, 0] - 0.1 * diameter**2 * data["angular_velocity"][:, 1])).sum())
            middle, height = self.surface(x, diameter)
            self.heights.append(height)
            self.tangent.append(numpy.polyfit(middle, height, 1)[0])
            places.append(x[:, (0, 2)])
        self.middle, self.places = middle, numpy.array(places)

    def surface(self, position, diameter):
        """(middle [n], height [n]) of the columns within half a radius, m."""
        radius = self.p["radius"]
        columns = max(4, round(radius / self.p["diameter"]))
        wide, thick = radius / columns, self.p["diameter"] / 2
        layers = math.ceil(2 * radius / thick)
        near = abs(position[:, 0]) < 0.5 * (radius + diameter)
        points = (position[near][:, None, (0, 2)] + 0.5 * diameter[near][:, None, None] * IN_SPHERE[:, (0, 2)]).reshape(-1, 2)
        column, layer = numpy.floor((points + (radius / 2, radius)) / (wide, thick)).astype(int).T
        volume = numpy.repeat(math.pi / 6 * diameter[near] ** 3 / POINTS, POINTS)
        inside = (column >= 0) & (column < columns)
        solids = numpy.bincount((column * layers + layer)[inside], volume[inside], columns * layers).reshape(columns, layers)
        solids /= wide * thick * self.p["length"]
        top = layers - 1 - numpy.argmax(solids[:, ::-1] > SURFACE, axis=1)
        here, above = (solids[numpy.arange(columns), numpy.minimum(at, layers - 1)] for at in (top, top + 1))
        if not (here > SURFACE).all():
            raise InputError(f"{self.name}: the bed does not reach half a radius from the axis on either side; is the drum too empty?")
        share = (here - SURFACE) / (here - above)  # of the way to the layer above
        return (numpy.arange(columns) + 0.5) * wide - radius / 2, (top + 0.5 + share) * thick - radius

    def torque(self):
        """`Mean`, N m."""
        mean = mean_with_error(self.moment)
        return shifted(mean, (self.momentum[-1] - self.momentum[0]) / (self.time[-1] - self.time[0]))

    def torque_on_mesh(self):
        """`Mean`, N m; None where the run has no record of it."""
        written = ave_time.read(self.run, TORQUE)
        return mean_with_error(written[1][written[0] >= self.time[0], 0]) if written else None

    def angle(self):
        """`Mean`, degrees."""
        return mean_with_error(numpy.degrees(numpy.arctan(self.tangent)))

    def mixing(self):
        """`Mean` half a turn after the marks."""
        later = numpy.searchsorted(self.time, self.time + self.p["period"] / 2 - 1e-6)
        if not (pairs := [(first, then) for first, then in enumerate(later) if then < len(self.time)]):
            return None
        return mean_with_error([self.mixed(first, then) for first, then in pairs])

    def mixing_curve(self):
        """(s since the marks [n], index [n])"""
        stride = max(1, round(CURVE / (self.time[1] - self.time[0])))
        starts = range(0, len(self.time), stride)
        lags = [lag for lag in starts if lag <= len(self.time) // 2]
        index = [numpy.mean([self.mixed(first, first + lag) for first in starts if first + lag < len(self.time)]) for lag in lags]
        return numpy.array(lags) * (self.time[1] - self.time[0]), numpy.array(index)

    def mixed(self, first, then):
        """Lacey, J. Appl. Chem. 4 (1954) 257: (s_0^2 - s^2)/(s_0^2 - s_r^2), s_r^2 that of spheres that stand anywhere."""
        marked = self.places[first, :, 0] < numpy.median(self.places[first, :, 0])
        reach, width = self.p["radius"], APART * self.p["diameter"]
        edges = numpy.arange(-reach, reach + width, width)
        every, mine = (numpy.histogram2d(*self.places[then][which].T, bins=edges)[0].ravel() for which in (slice(None), marked))
        every, mine = every[every > 0], mine[every > 0]
        share = marked.mean()
        apart, random = share * (1 - share), share * (1 - share) * len(every) / every.sum()
        spread = (every * (mine / every - share) ** 2).sum() / every.sum()
        return (apart - spread) / (apart - random)

    def seconds(self):
        """Of the processor."""
        return sum(series.values[-1] for series in self.run.processor_time.values())


def in_sphere(count):
    """[count, 3] points that fill the unit sphere evenly: golden spiral, as many within each part of its volume."""
    k = numpy.arange(count) + 0.5
    height, turn = 1 - 2 * k / count, math.pi * (3 - math.sqrt(5)) * k
    across = numpy.sqrt(1 - height**2)
    deep = ((k * math.sqrt(2)) % 1) ** (1 / 3)
    return deep[:, None] * numpy.column_stack([across * numpy.cos(turn), across * numpy.sin(turn), height])


IN_SPHERE = in_sphere(POINTS)


def shifted(mean, by):
    return Mean(**{**vars(mean), "value": mean.value + by})


def scaled(mean, factor):
    return Mean(**{**vars(mean), "value": mean.value * factor, "error": mean.error * abs(factor)})


def cell(mean, digits, first=None):
    """Mean and error, "?" where it is not to be trusted, and the difference from the `first`."""
    if mean is None:
        return "-"
    text = f"{mean.value:.{digits}f} +- {mean.error:.{digits}f}" + "?" * bool(mean.reason)
    if first is None or first is mean:
        return text
    off = difference(first, mean)
    return f"{text} ({100 * off.value / first.value:+.1f} +- {100 * off.error / first.value:.1f} %)"


def table(drums):
    torque, angle, mixing = ([getattr(each, name)() for each in drums] for name in ("torque", "angle", "mixing"))
    rows = [["run", "method", "W", "mu_r", "torque [mN m]", "power [mW]", "mesh [mN m]", "angle [deg]", "mixing", "CPU [s]"]]
    for each, t, a, m in zip(drums, torque, angle, mixing):
        mesh = each.torque_on_mesh()
        rows.append([each.name, each.run.meta["method"], f"{each.run.meta['weight']:g}", f"{each.p['rollingFriction']:g}",
                     cell(scaled(t, 1e3), 2, scaled(torque[0], 1e3) if t is not torque[0] else None),
                     cell(scaled(t, 1e3 * 2 * math.pi / each.p["period"]), 2), "-" if mesh is None else cell(scaled(mesh, 1e3), 2),
                     cell(a, 2, angle[0]), cell(m, 3, mixing[0]), f"{each.seconds():.0f}"])  # fmt: skip
    return rows


def draw(drums, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (surface, mixing) = pyplot.subplots(1, 2, figsize=(11, 4.8), layout="constrained")
    radius = drums[0].p["radius"]
    circle = numpy.linspace(0, 2 * math.pi, 200)
    surface.plot(1e3 * radius * numpy.cos(circle), 1e3 * radius * numpy.sin(circle), color="black")
    for each in drums:
        line = {"label": each.name, "lw": 3 if each is drums[0] else 1.3}
        surface.plot(1e3 * each.middle, 1e3 * numpy.mean(each.heights, axis=0), **line)
        since, index = each.mixing_curve()
        mixing.plot(since / each.p["period"], index, **line)
    surface.set(title="mean surface", xlabel="x [mm]", ylabel="z [mm]", aspect="equal")
    mixing.set(title="mixing of left and right", xlabel="turns since they were marked", ylabel="Lacey's index")
    mixing.legend(fontsize="small")
    figure.savefig(path, dpi=90)
    print(f"picture    {path}")


def main():
    parser = argparse.ArgumentParser(prog="cases/drum/compare", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", metavar="RUN", nargs="+", help="folders of runs of this case")
    parser.add_argument("--from", metavar="T", dest="start", type=float, default=1.0, help="s (default 1)")
    parser.add_argument("-o", "--out", metavar="FILE.png", help="draw surfaces and mixing")
    given = parser.parse_args()
    drums = [Drum(folder, given.start) for folder in given.runs]
    print("\n".join(tables.columns(table(drums), right=range(2, 10))))
    if given.out:
        draw(drums, given.out)


if __name__ == "__main__":
    try:
        main()
    except InputError as error:
        sys.exit(f"cases/drum/compare: {error}")
