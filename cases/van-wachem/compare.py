# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure and surface of runs of this bed beside what van Wachem et al. measured: a table, and a picture.

    cases/van-wachem/compare                            of the stored runs, study/: the tables of the README, and compare.png
    cases/van-wachem/compare runs/a runs/b              of these runs' folders, nothing stored
    cases/van-wachem/compare runs/a runs/b --store      into study/, under the names of the folders; then as without runs

  pressure    /series/pressure_drop: 45 mm above the floor, less the outlet's; its fluctuation is what was measured [Pa]
  surface     at each snapshot, in columns of COLUMN across, the height below which 99 % of the column's solids lie; the mean of the columns [m]
  deviation   the standard deviation; its error that of the mean square, autocorrelation taken in
  strongest   the frequency of the highest power density, Welch's segments of SEGMENT; in brackets where the density is not surely below that
"""

import argparse
import csv
import io
import math
import os
import sys

import numpy
from scipy import signal, stats

from interphase import InputError, Run, parameters, tables
from interphase.time_statistics import mean_with_error

CASE = os.path.dirname(os.path.realpath(__file__))
STUDY = os.path.join(CASE, "study")
COLUMN = 0.005  # [m]
SHARE = 0.99
SEGMENT = 2.5  # [s]
CERTAINTY = 0.95
HIGHEST = 12.0  # Hz that are kept of spectra
KEPT = 3.0  # s that are kept of the pressure, as many as were measured
SHOWN = ("DEM", "TDHS", "CGHS-2", "CGHS-8")  # of the stored runs, in the picture's first two panels
# Of the third: runs of the case as it is by their method, others as named here
GROUPS = {"DEM": ("s", "DEM"), "TDHS": ("o", "TDHS"), "CGHS": ("o-", "CGHS, W = 2, 4, 8"), "CGPM": ("s-", "CGPM, W = 2, 4, 8"),
          "MPPIC": ("^", "MP-PIC, W = 8"), "depth": ("D", "CGHS, W = 8, deeper vessels"), "thin": ("v", "TDHS, vessel of half the depth"),
          "reach": ("*", "CGHS, W = 8, front and back where particles' would be")}  # fmt: skip
GROUP = {"TDHS-thin": "thin", "CGHS-8-depth16": "depth", "CGHS-8-depth32": "depth", "CGHS-8-reach": "reach"}
FIELDS = ("run", "method", "W", "differs", "from", "until", "diameter_over_depth", "deviation", "error", "doubt", "frequency", "frequency_low",
          "frequency_high", "surface", "surface_error", "surface_deviation", "surface_deviation_error", "surface_frequency", "command", "commit")  # fmt: skip


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


def deviation(values):
    """(standard deviation, its standard error, why not to trust it or "") of a series at even spacing."""
    square = mean_with_error((values - values.mean()) ** 2)
    root = math.sqrt(square.value)
    return root, square.error / (2 * root), square.reason


def spectrum(times, values):
    """(frequency, power density, its lower and upper limit at CERTAINTY) [n] each, one-sided, without frequency 0.

    Hann's windows, half overlapping; of K of them the density has 36 K^2/(19 K - 1) degrees of freedom (P. D. Welch, IEEE Trans. Audio
    Electroacoust. 15 (1967) 70). A record shorter than a segment is one.
    """
    rate = (len(times) - 1) / (times[-1] - times[0])
    length = min(len(values), round(SEGMENT * rate))
    step = length - length // 2
    count = 1 + (len(values) - length) // step
    frequency, power = signal.welch(values, rate, nperseg=length, nfft=4 * length)
    freedom = 36 * count**2 / (19 * count - 1)
    tail = (1 - CERTAINTY) / 2
    kept = (frequency >= 0.999 / (length / rate)) & (frequency <= HIGHEST)
    frequency, power = frequency[kept], power[kept]
    return frequency, power, power * freedom / stats.chi2.ppf(1 - tail, freedom), power * freedom / stats.chi2.ppf(tail, freedom)


def strongest(frequency, power, low, high):
    """(frequency of the highest density, and the ends of the range around it where the density may be as high)."""
    peak = int(numpy.argmax(power))
    may = high >= power[peak]
    first = peak - int(numpy.argmin(may[peak::-1])) + 1 if not may[:peak].all() else 0
    last = peak + int(numpy.argmin(may[peak:])) - 1 if not may[peak:].all() else len(may) - 1
    return frequency[peak], frequency[first], frequency[last]


def command(record, until):
    """The call of tools/run that makes a run like this one."""
    words = [f"tools/run cases/{record['case']} --method {record['method']} --weight {record['weight']:g}"]
    words += [f"--set '{word}'" if " " in word else f"--set {word}" for word in record["settings"]]
    return " ".join([*words, f"--until {until:g}"])


def measure(folder, since):
    """(row of FIELDS, spectrum [4, n], pressure (time, value)) of the run in `folder`, from `since` [s] on."""
    run = Run(folder)
    drop = run.series["pressure_drop"].between(since)
    values = parameters.values_of(open(os.path.join(folder, parameters.PARAMETERS), encoding="utf-8").read())
    width, depth, diameter = (float(values[key]) for key in ("width", "depth", "diameter"))
    seen = [each for each in run.snapshots if each.time >= since - 1e-9]
    heights = numpy.array([surface(each.positions, each.diameters, width) for each in seen])
    times = numpy.array([each.time for each in seen])
    fluctuation = drop.values - drop.values.mean()
    density = spectrum(drop.time, fluctuation)
    at, low, high = strongest(*density)
    root, error, doubt = deviation(drop.values)
    mean, (swing, swing_error, _) = mean_with_error(heights), deviation(heights)
    record, weight = run.record, run.meta["weight"]
    until = round(float(drop.time[-1]), 3)
    numbers = (since, until, diameter * weight ** (1 / 3) / depth, root, error)
    row = [os.path.basename(os.path.abspath(folder)), record["method"], f"{weight:g}", " ".join(record["settings"]), *(f"{n:.4g}" for n in numbers), doubt,
           *(f"{n:.3g}" for n in (at, low, high)), *(f"{n:.4g}" for n in (mean.value, mean.error, swing, swing_error)),
           f"{strongest(*spectrum(times, heights - heights.mean()))[0]:.3g}", command(record, until), run.meta["commit"][:12]]  # fmt: skip
    return dict(zip(FIELDS, row)), density, (drop.time, fluctuation)


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
    writer.writerows([row for row in stored(name) if row["run"] not in new] + rows)
    with open(os.path.join(STUDY, name), "w", encoding="utf-8") as file:
        file.write(text.getvalue())


def keep(found):
    """What `measure` has found of several runs, into study/."""
    store("runs.csv", FIELDS, [row for row, _, _ in found])
    names = ("run", "frequency", "power", "low", "high")
    store("spectra.csv", names, [dict(zip(names, (row["run"], *(f"{n:.4g}" for n in line)))) for row, density, _ in found for line in zip(*density)])
    rows = []
    for row, _, (time, value) in found:
        last = numpy.flatnonzero(time >= time[-1] - KEPT)[::4]
        rows += [{"run": row["run"], "time": f"{time[i] - time[last[0]]:.3f}", "pressure": f"{value[i]:.1f}"} for i in last]
    store("pressures.csv", ("run", "time", "pressure"), rows)


def of_measurement():
    """The row of the measurement: its errors are those of a record of 2 to 3 s, some 15 %."""
    t, p = measured("pressure")
    times, height = measured("height")
    at, low, high = strongest(*spectrum(t, p - p.mean()))
    row = dict.fromkeys(FIELDS, "")
    row.update({"run": "measured", "deviation": f"{p.std():.3g}", "error": f"{0.15 * p.std():.2g}", "frequency": f"{at:.3g}", "frequency_low": f"{low:.3g}",
                "frequency_high": f"{high:.3g}", "surface": f"{height.mean():.4g}", "surface_deviation": f"{height.std():.3g}",
                "surface_deviation_error": f"{0.15 * height.std():.2g}",
                "surface_frequency": f"{strongest(*spectrum(times, height - height.mean()))[0]:.3g}"})  # fmt: skip
    return row


def table(rows):
    """The README's table of `rows`."""
    print(tables.markdown_head(("run", "differs", "from, to [s]", "diameter over depth", "pressure, deviation [Pa]", "strongest [Hz]", "surface [mm]",
                                "its deviation [mm]", "its strongest [Hz]")))  # fmt: skip
    for row in rows:
        pair = " +- ".join(f"{1e3 * float(row[key]):.1f}" for key in ("surface", "surface_error") if row[key])
        swing = f"{1e3 * float(row['surface_deviation']):.1f} +- {1e3 * float(row['surface_deviation_error']):.1f}"
        span = f"{row['from']}, {row['until']}" if row["from"] else ""
        print(tables.markdown_row((
            row["run"], row["differs"], span, f"{float(row['diameter_over_depth']):.2f}" if row["diameter_over_depth"] else "",
            f"{float(row['deviation']):.0f} +- {float(row['error']):.0f}{'?' if row['doubt'] else ''}",
            f"{float(row['frequency']):.1f} ({float(row['frequency_low']):.1f} to {float(row['frequency_high']):.1f})", pair, swing,
            f"{float(row['surface_frequency']):.1f}")))  # fmt: skip


def draw(rows, path):
    """Pressure over time, its spectra with their limits, and its deviation over how many sphere diameters there are in the depth."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (curves, spectra, trade) = pyplot.subplots(1, 3, figsize=(14, 4.4), layout="constrained")
    shown = [name for name in SHOWN if any(row["run"] == name for row in rows)]
    t, p = measured("pressure")
    lines = {"measured": (t - t[0], p)}
    densities = {"measured": spectrum(t, p - p.mean())}
    for name in shown:
        lines[name] = columns_of("pressures.csv", name, ("time", "pressure"))
        densities[name] = columns_of("spectra.csv", name, ("frequency", "power", "low", "high"))
    for at, (name, (time, value)) in enumerate(lines.items()):
        colour = "black" if name == "measured" else f"C{at - 1}"
        curves.plot(time, value - 450 * at, color=colour, lw=1.2)
        curves.text(0.02, 190 - 450 * at, name, color=colour, fontsize=9)
        frequency, power, low, high = densities[name]
        spectra.plot(frequency, power, color=colour, lw=1.4, label=name)
        if name != "measured":  # one segment: its limits would span two decades
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
    for group, (marker, label) in GROUPS.items():
        chosen = [row for row in rows if GROUP.get(row["run"], row["method"] if not row["differs"] else None) == group]
        if chosen:
            x, y, e = (numpy.array([float(row[key]) for row in chosen]) for key in ("diameter_over_depth", "deviation", "error"))
            trade.errorbar(x, y, e, fmt=marker, capsize=2, label=label, ms=5)
    trade.set(xlabel="diameter of the tracked sphere over the depth", ylabel="deviation of the pressure [Pa]", ylim=(0, None))
    trade.legend(frameon=False, fontsize=8)
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
    found = []
    for folder in options.runs:
        try:
            found.append(measure(folder, options.since))
        except InputError as error:
            sys.exit(f"compare: {error}")
    if options.store:
        keep(found)
    if found and not options.store:
        return table([of_measurement(), *(row for row, _, _ in found)])
    rows = stored("runs.csv")
    if not rows:
        sys.exit(f"compare: nothing is stored in {STUDY}; give folders of runs, and --store")
    table([of_measurement(), *rows])
    draw(rows, options.out)


if __name__ == "__main__":
    main()
