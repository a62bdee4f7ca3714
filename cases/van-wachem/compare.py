# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure and surface of runs of this bed beside what van Wachem et al. measured: a table, and a picture.

    cases/van-wachem/compare                            of the stored runs, study/: the tables of the README, and compare.png
    cases/van-wachem/compare runs/a runs/b              of these runs' folders, nothing stored
    cases/van-wachem/compare runs/a runs/b --store      into study/, under the names of the folders; then as without runs

  pressure    /series/pressure_drop: 45 mm above the floor, less the outlet's; its fluctuation is what was measured [Pa]
  surface     at each snapshot, in columns of COLUMN across, the height below which 99 % of the column's solids lie; the mean of the columns [m]
  deviation   the standard deviation with its error (deviation_with_error of interphase/time_statistics.py)
  packing     of a run with next to no gas (inletVelocity below AT_REST), at its end: the solids' volume over that of the bed, twice its mean height
  U_mf        at which the drag law of the run carries a bed of that packing; of runs whose packing is stored
  strongest   the strongest frequency of the pressure with its standard error (interphase/spectrum.py)
"""

import argparse
import csv
import io
import math
import os
import sys

import numpy

from interphase import InputError, Run, parameters, tables
from interphase.drag_laws import LAWS
from interphase.fluidization import Grain
from interphase.run_account import command_of
from interphase.spectrum import power_spectrum, strongest_frequency
from interphase.time_statistics import deviation_with_error, mean_with_error

CASE = os.path.dirname(os.path.realpath(__file__))
STUDY = os.path.join(CASE, "study")
COLUMN = 0.005  # [m]
SHARE = 0.99
AT_REST = 0.01  # [m/s]
HIGHEST = 12.0  # Hz that are kept of spectra
WIDTH, WALL_FRICTION = 0.09, "0.3"  # of the case as it is [m]
MARKS = ("TDHS", "CGHS", "CGPM", "DEM")
COMPUTED = ("cells=(9", "cells=(27", "mapping/", "dragLaw", "system/", "plenum")  # what changes how the bed is computed, and not what it is of
KEPT = 3.0  # s that are kept of the pressure, as many as were measured
SHOWN = ("DEM", "TDHS", "TDHS-fine", "CGHS-2", "CGHS-8")  # of the stored runs, in the picture's first two panels
AS_PACKING = ("W", "depth", "reach", "wall_friction", "method")  # runs alike in these have the packing of the one at rest; of methods, CGPM and DEM that of hard spheres
PACKINGS = ("run", *AS_PACKING, "diameter_over_depth", "packing", "command", "commit")
HARD = {"CGPM": "CGHS", "DEM": "TDHS"}
FIELDS = ("run", "method", "W", "differs", "depth", "reach", "wall_friction", "velocity", "law", "from", "until", "diameter_over_depth", "deviation", "error", "doubt", "frequency", "frequency_error",
          "surface", "surface_error", "surface_deviation", "surface_deviation_error", "command", "commit")  # fmt: skip


def measured(name):
    """(time [s, n], value [n]) of measured-`name`.csv, at even spacing of 10 ms along the lines between the corner points."""
    with open(os.path.join(CASE, f"measured-{name}.csv"), encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))[1:]
    t, value = numpy.array(rows, dtype=float).T
    even = numpy.arange(t[0], t[-1], 0.01)
    return even, numpy.interp(even, t, value)


def surface(position, diameter, width):
    """Height below which 99 % of the solids of a column of COLUMN lie, mean of the columns that hold any [m]; position [n, 3]."""
    columns = max(round(width / COLUMN), 1)
    column = numpy.clip((position[:, 0] / width * columns).astype(int), 0, columns - 1)
    order = numpy.lexsort((position[:, 2], column))
    z, volume, column = position[order, 2], diameter[order] ** 3, column[order]
    heights = []
    for at in numpy.unique(column):
        inside = column == at
        filled = numpy.cumsum(volume[inside])
        # half of a sphere's solids lie below its centre
        heights.append(numpy.interp(SHARE * filled[-1], filled - volume[inside] / 2, z[inside]))
    return float(numpy.mean(heights))


def density(times, values):
    """(frequency, power density, its limits) [4, n] of a series up to HIGHEST."""
    found = power_spectrum(times, values)
    return numpy.array([found.frequency, found.power, found.low, found.high])[:, found.frequency <= HIGHEST]


def scene(run, folder):
    """(numbers of the run's file `parameters`, columns that runs of flow and at rest share)."""
    with open(os.path.join(folder, parameters.PARAMETERS), encoding="utf-8") as file:
        values = parameters.values_of(file.read())
    weight, record = float(run.meta["weight"]), run.record
    across = float(values["diameter"]) * weight ** (1 / 3) / float(values["depth"])
    return values, {"run": os.path.basename(os.path.abspath(folder)), "method": record["method"], "W": f"{weight:g}", "depth": f"{float(values['depth']):g}",
                    "reach": f"{float(values['reach']):g}", "wall_friction": f"{float(values['wallFriction']):g}", "diameter_over_depth": f"{across:.4g}", "commit": run.meta["commit"][:12]}  # fmt: skip


def at_rest(folder):
    """The row of PACKINGS of the run in `folder`, None where gas flows."""
    run = Run(folder)
    values, row = scene(run, folder)
    if float(values["inletVelocity"]) > AT_REST:
        return None
    height = run.series["bed_height"]
    solids = float(values["particleCount"]) * math.pi / 6 * float(values["diameter"]) ** 3
    packing = solids / (float(values["width"]) * float(values["depth"]) * height.values[-1])
    return {**row, "packing": f"{packing:.4f}", "command": command_of(run, height.time[-1])}


def measure(folder, since):
    """(row of FIELDS, spectrum [4, n], pressure (time, value)) of the run in `folder`, from `since` [s] on."""
    run = Run(folder)
    drop = run.series["pressure_drop"].between(since)
    values, row = scene(run, folder)
    seen = [each for each in run.snapshots if each.time >= since - 1e-9]
    heights = numpy.array([surface(each.positions, each.diameters, float(values["width"])) for each in seen])
    fluctuation = drop.values - drop.values.mean()
    strongest = strongest_frequency(drop.time, fluctuation)
    deviation, mean, swing = deviation_with_error(drop.values), mean_with_error(heights), deviation_with_error(heights)
    until = round(float(drop.time[-1]), 3)
    numbers = {"from": since, "until": until, "velocity": float(values["inletVelocity"]), "deviation": deviation.value, "error": deviation.error, "frequency": strongest.value,
               "frequency_error": strongest.error, "surface": mean.value, "surface_error": mean.error, "surface_deviation": swing.value,
               "surface_deviation_error": swing.error}  # fmt: skip
    row.update({name: f"{number:.4g}" for name, number in numbers.items()}, law=values["dragLaw"], doubt=deviation.reason, differs=" ".join(run.record["settings"]),
               command=command_of(run, until))
    return row, density(drop.time, fluctuation), (drop.time, fluctuation)


def minimum_fluidization(packing, law):
    """U_mf [m/s] of this case's particles at a solid fraction, by a drag law."""
    with open(os.path.join(CASE, parameters.PARAMETERS), encoding="utf-8") as file:
        value = parameters.values_of(file.read())
    grain = Grain(*(float(value[key]) for key in ("diameter", "particleDensity", "gasDensity", "gasViscosity", "gravity")))
    return grain.minimum_fluidization(LAWS[law], 1 - packing)


def fluidized(row, packings):
    """(packing, U_mf [m/s]) of a stored run of flow, None where no run at rest is stored that is like it. MP-PIC has no packing of spheres."""
    wanted = {**row, "method": HARD.get(row["method"], row["method"])}
    for each in packings:
        if all(each[key] == wanted[key] for key in AS_PACKING):
            return float(each["packing"]), minimum_fluidization(float(each["packing"]), row["law"])
    return None


def stored(name):
    """Rows of study/`name`, a list of dictionaries; empty where it is not there."""
    path = os.path.join(STUDY, name)
    if not os.path.isfile(path):
        return []
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def store(name, fields, rows):
    """Rows into study/`name`, in place of those of the same runs."""
    new = {row["run"] for row in rows}
    text = io.StringIO()
    writer = csv.DictWriter(text, fields, lineterminator="\n")
    writer.writeheader()
    kept = [row for row in stored(name) if row["run"] not in new]
    writer.writerows(sorted(kept + rows, key=lambda row: row["run"]))
    with open(os.path.join(STUDY, name), "w", encoding="utf-8") as file:
        file.write(text.getvalue())


def keep(found):
    """What `measure` has found of several runs, into study/."""
    store("runs.csv", FIELDS, [row for row, _, _ in found])
    names = ("run", "frequency", "power", "low", "high")
    store("spectra.csv", names, [dict(zip(names, (row["run"], *(f"{n:.4g}" for n in line)))) for row, bands, _ in found for line in zip(*bands)])
    rows = []
    for row, _, (time, value) in found:
        last = numpy.flatnonzero(time >= time[-1] - KEPT)[::4]
        rows += [{"run": row["run"], "time": f"{time[i] - time[last[0]]:.3f}", "pressure": f"{value[i]:.1f}"} for i in last]
    store("pressures.csv", ("run", "time", "pressure"), rows)


def of_measurement():
    """The row of the measurement: its errors are those of a record of 2 to 3 s, some 15 %."""
    t, p = measured("pressure")
    _, height = measured("height")
    strongest = strongest_frequency(t, p)
    row = dict.fromkeys(FIELDS, "")
    row.update({"run": "measured", "deviation": f"{p.std():.3g}", "error": f"{0.15 * p.std():.2g}", "frequency": f"{strongest.value:.3g}",
                "frequency_error": f"{strongest.error:.2g}", "surface": f"{height.mean():.4g}", "surface_deviation": f"{height.std():.3g}",
                "surface_deviation_error": f"{0.15 * height.std():.2g}"})  # fmt: skip
    return row


def table(rows, packings):
    """The README's table of `rows`."""
    print(tables.markdown_head(("run", "differs", "to [s]", "diameter over depth", "packing", "U - U_mf [m/s]", "pressure, deviation [Pa]", "strongest [Hz]",
                                "surface [mm]", "its deviation [mm]")))  # fmt: skip
    for row in rows:
        pair, swing = (" +- ".join(f"{1e3 * float(row[key]):.1f}" for key in (name, f"{name}_error") if row[key] not in ("", "nan"))
                       for name in ("surface", "surface_deviation"))  # fmt: skip
        packing = fluidized(row, packings)
        print(tables.markdown_row((
            row["run"], row["differs"], row["until"], f"{float(row['diameter_over_depth']):.2f}" if row["diameter_over_depth"] else "",
            *((f"{packing[0]:.3f}", f"{float(row['velocity']) - packing[1]:.2f}") if packing else ("", "")),
            f"{float(row['deviation']):.0f} +- {float(row['error']):.0f}{'?' if row['doubt'] else ''}",
            f"{float(row['frequency']):.1f} +- {float(row['frequency_error']):.1f}", pair, swing)))  # fmt: skip


def table_of_packings(packings):
    """The packings at rest, and the line through those of spheres between walls, packing = a (1 - b (D/depth + D/width))."""
    print("\n" + tables.markdown_head(("run", "W", "diameter over depth", "packing", "U_mf by BVK [m/s]")))
    for row in packings:
        packing = float(row["packing"])
        print(tables.markdown_row((row["run"], row["W"], f"{float(row['diameter_over_depth']):.2f}", f"{packing:.3f}", f"{minimum_fluidization(packing, 'BVK'):.2f}")))
    between = [row for row in packings if row["reach"] == "0" and row["wall_friction"] == WALL_FRICTION]
    if len(between) > 2:
        ratio = numpy.array([float(row["diameter_over_depth"]) * (1 + float(row["depth"]) / WIDTH) for row in between])
        slope, dense = numpy.polyfit(ratio, [float(row["packing"]) for row in between], 1)
        off = numpy.polyval((slope, dense), ratio) - [float(row["packing"]) for row in between]
        print(f"\npacking = {dense:.3f} (1 - {-slope / dense:.2f} (D/depth + D/width)) within {abs(off).max():.3f}")


def draw(rows, packings, path):
    """Pressure over time, its spectra with their limits, and its deviation over the gas that the bed has beyond minimum fluidization."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (curves, spectra, trade) = pyplot.subplots(1, 3, figsize=(14, 4.4), layout="constrained")
    shown = [name for name in SHOWN if any(row["run"] == name for row in rows)]
    t, p = measured("pressure")
    lines = {"measured": (t - t[0], p)}
    densities = {"measured": density(t, p)}
    for name in shown:
        lines[name] = columns_of("pressures.csv", name, ("time", "pressure"))
        densities[name] = columns_of("spectra.csv", name, ("frequency", "power", "low", "high"))
    for at, (name, (time, value)) in enumerate(lines.items()):
        colour = "black" if name == "measured" else f"C{at - 1}"
        curves.plot(time, value - 450 * at, color=colour, lw=1.2)
        curves.text(0.02, 190 - 450 * at, name, color=colour, fontsize=9)
        frequency, power, low, high = densities[name]
        spectra.plot(frequency, power, color=colour, lw=1.4, label=name)
        spectra.fill_between(frequency, low, high, color=colour, alpha=0.15, lw=0)
    curves.set(xlabel="time [s]", ylabel="pressure less its mean, 45 mm above the floor [Pa]", xlim=(0, KEPT), yticks=[])
    curves.plot([2.95, 2.95], [150, 250], color="0.3", lw=3)
    curves.text(2.9, 170, "100 Pa", ha="right", fontsize=8)
    spectra.set(xlabel="frequency [Hz]", ylabel="power density of the pressure [Pa$^2$/Hz]", yscale="log", xlim=(0.4, 10))
    spectra.legend(frameon=False, fontsize=8)
    whole = of_measurement()
    value, error = float(whole["deviation"]), float(whole["error"])
    trade.axhspan(value - error, value + error, color="0.9", zorder=0)
    trade.axhline(value, color="black", lw=1)
    labelled = 0
    for row in rows:
        packing = fluidized(row, packings)
        if packing and not any(word in row["differs"] for word in COMPUTED):
            at = float(row["velocity"]) - packing[1]
            colour = f"C{MARKS.index(row['method'])}"
            trade.errorbar(at, float(row["deviation"]), float(row["error"]), fmt="osD^"[MARKS.index(row["method"])], color=colour, capsize=2, ms=5)
            # springs to the left, as the hard spheres of the same W stand beside them
            offset, aligned = ((-5, 4), "right") if row["method"] in HARD else ((5, 4 if labelled % 2 == 0 else -9), "left")
            labelled += row["method"] not in HARD
            trade.annotate(row["run"], (at, float(row["deviation"])), offset, textcoords="offset points", fontsize=7, color=colour, ha=aligned)
    trade.set(xlabel="inlet velocity less U$_{mf}$ of the bed's own packing [m/s]", ylabel="deviation of the pressure [Pa]", ylim=(0, None), xlim=(0, 0.65))
    figure.savefig(path, dpi=90)
    print(f"compare: drawn in {path}")


def columns_of(name, run, fields):
    """Columns `fields` of the rows of `run` in study/`name`, arrays."""
    rows = [row for row in stored(name) if row["run"] == run]
    return tuple(numpy.array([float(row[field]) for row in rows]) for field in fields)


def arguments():
    parser = argparse.ArgumentParser(prog="compare", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="*", metavar="RUN", help="folders of runs (default: those of study/)")
    parser.add_argument("--from", dest="since", type=float, default=1.0, metavar="T", help="the start-up before it is left out [s] (default 1)")
    parser.add_argument("--store", action="store_true", help="put what is measured of RUN into study/")
    parser.add_argument("--out", default="compare.png", metavar="FILE", help="the picture (default compare.png)")
    options = parser.parse_args()
    if options.store and not options.runs:
        parser.error("--store wants the folders of the runs to be stored")
    return options


def main():
    options = arguments()
    found, rest = [], []
    for folder in options.runs:
        try:
            row = at_rest(folder)
            found += [] if row else [measure(folder, options.since)]
            rest += [row] if row else []
        except InputError as error:
            sys.exit(f"compare: {error}")
    if options.store:
        keep(found)
        store("packings.csv", PACKINGS, rest)
    if options.runs and not options.store:
        rows, packings = [row for row, _, _ in found], [*stored("packings.csv"), *rest]
    else:
        rows, packings = stored("runs.csv"), stored("packings.csv")
        if not rows:
            sys.exit(f"compare: nothing is stored in {STUDY}; give folders of runs, and --store")
    table([of_measurement(), *rows], packings)
    table_of_packings(packings)
    if not options.runs or options.store:
        draw(rows, packings, options.out)


if __name__ == "__main__":
    main()
