# SPDX-License-Identifier: GPL-3.0-or-later
"""What the runs of a sweep measured: means of their series with standard errors, as rows, a table and CSV."""

import csv
import hashlib
import math
import re
from dataclasses import dataclass, field

import numpy

from interphase import tables
from interphase.input_error import InputError
from interphase.run import no_such


@dataclass
class Cell:
    """A quantity of the runs that differ by their seed alone: `mean` and standard `error` in `unit`, of `runs` runs.

    `scatter`: standard error by the scatter of the runs' means, deviation / sqrt(runs), NaN of one run; `within`: by the runs' own errors,
    sqrt(sum of squares) / runs, autocorrelation taken in, NaN where one is not known. `error` is the larger one. `reason` is empty,
    or says why it is not to be trusted.
    """

    unit: str
    mean: float = math.nan
    error: float = math.nan
    scatter: float = math.nan
    within: float = math.nan
    runs: int = 0
    reason: str = ""

    def __str__(self):
        if not self.runs or math.isnan(self.mean):
            return "-"
        if math.isnan(self.error):
            return f"{self.mean:.5g} +- ?"
        return f"{self.mean:.5g} +- {self.error:.2g}" + " ?" * bool(self.reason)


@dataclass
class Row:
    """One combination of what is swept: `values` {name: text}, `method`, `weight`; `cells` {quantity: Cell}; `asked` runs, of which `runs` are
    there and different."""

    values: dict
    method: str
    weight: float
    asked: int
    runs: int = 0
    cells: dict = field(default_factory=dict)

    def label(self):
        """What is swept, in words."""
        return ", ".join([*(f"{name} = {text}" for name, text in self.values.items()), f"{self.method}, W = {self.weight:g}"])


@dataclass
class Result:
    """`rows`; the `quantities` that are shown {name: unit}; `remarks` for the user."""

    rows: list
    quantities: dict
    remarks: list


def _series(run, after):
    """({quantity: Average or InputError}, what tells the record from another one) of a run; `after` [s], None: the later half."""
    means, record = {}, hashlib.sha256()
    for name, series in run.series.items():
        record.update(name.encode() + series.values.tobytes())
        if series.values.ndim != 1 or not len(series.time):
            continue
        try:
            means[name] = series.mean(after=series.time[-1] / 2 if after is None else after)
        except InputError as error:
            means[name] = error
    return means, record.hexdigest()


def _cell(name, averages):
    """The Cell of the Averages, or InputErrors, of runs."""
    errors = [str(each) for each in averages if isinstance(each, InputError)]
    good = [each for each in averages if not isinstance(each, InputError)]
    if not good or errors:
        return Cell(good[0].unit if good else "", runs=0, reason=errors[0])
    values = numpy.array([each.value for each in good])
    own = numpy.array([each.error for each in good])
    count = len(good)
    scatter = float(values.std(ddof=1) / math.sqrt(count)) if count > 1 else math.nan
    within = float(math.sqrt((own**2).sum()) / count)
    known = [each for each in (scatter, within) if not math.isnan(each)]
    error = max(known, default=math.nan)
    # The scatter of three runs or more stands by itself, whatever is known within each.
    reason = "" if count > 2 and error == scatter else next((each.reason for each in good if each.reason), "")
    return Cell(good[0].unit, float(values.mean()), error, scatter, within, count, reason)


def measure(sweep, after=None, quantities=None):
    """The `Result` of the runs of a sweep_runs.Sweep that have ended. `after` [s]: what of the series is averaged, None: the later half of each.
    `quantities`: names of the series to show, None: all that vary in time or from run to run. InputError with the nearest name for one that there is
    not."""
    from interphase.run import Run
    from interphase.sweep_runs import DONE
    rows, remarks, builds, same, twice = {}, [], {}, [], []
    for point in sweep.points:
        row = rows.setdefault(point.group, (Row(point.values, point.case.method, point.case.weight, 0), []))
        row[0].asked += 1
        if sweep.stand[point.name] == DONE:
            run = Run(sweep.path(point))
            row[1].append((point, *_series(run, after)))
            meta = run.meta
            builds.setdefault(f"{meta.get('version', '?')} {meta.get('commit', '')}".strip(), []).append(point.name)
    first = {}
    for row, found in rows.values():
        different = {}
        for point, means, record in found:
            before = first.setdefault(record, (point, row))
            if record not in different:
                different[record] = point, means
            if before[0] is not point:
                (twice if before[1] is row else same).append(
                    f"{point.name} recorded the same as {before[0].name} to the last bit: what tells them apart changed nothing")
        row.runs = len(different)
        names = dict.fromkeys(name for _, means in different.values() for name in means)
        row.cells = {name: _cell(name, [means[name] for _, means in different.values() if name in means]) for name in names}
    for several, closing in ((same, ""), (twice, "; counted once")):
        remarks += [several[0] + closing + (f" (and {len(several) - 1} more pairs)" if len(several) > 1 else "")] if several else []
    if len(builds) > 1:
        remarks.append("the runs are of different builds of the program: " + "; ".join(
            f"{build}: {len(names)} runs, {names[0]} first" for build, names in builds.items()))
    rows = [row for row, _ in rows.values()]
    shown = _shown(rows, quantities, sweep.folder)
    return Result(rows, shown, remarks + _doubts(rows, shown))


def _doubts(rows, shown):
    """Why means are not to be trusted; reasons that differ in their numbers are told once."""
    alike = {}
    for row in rows:
        for name, cell in row.cells.items():
            if cell.reason and name in shown:
                alike.setdefault(re.sub(r"\d[\d.e+-]*", "", cell.reason), []).append(f"{name} of {row.label()}: {cell.reason}")
    return [each[0] + (f" (and {len(each) - 1} more alike: sweep.csv)" if len(each) > 1 else "") for each in alike.values()]


def _shown(rows, quantities, folder):
    units = {name: cell.unit for row in rows for name, cell in reversed(row.cells.items()) if cell.unit}
    there = dict.fromkeys(name for row in rows for name in row.cells)
    if quantities is not None and there:
        for name in quantities:
            if name not in there:
                raise no_such(f"/series of the runs in {folder}", name, there)
        return {name: units.get(name, "") for name in quantities}

    def varies(name):
        cells = [row.cells[name] for row in rows if name in row.cells]
        if len({cell.mean for cell in cells if cell.runs}) > 1 or any(cell.error > 0 for cell in cells):
            return True
        return len(rows) == 1 and any(cell.error != 0 for cell in cells)  # a run too short for an error: it may vary
    return {name: units.get(name, "") for name in there if varies(name)}


def lines(result, width=150):
    """The table as lines: what is swept, how many runs of those asked for are there, mean and standard error of each quantity; as many
    blocks side by side as go into `width` characters."""
    rows = result.rows
    head = list(rows[0].values)
    head += [name for name, of in (("method", lambda row: row.method), ("W", lambda row: row.weight)) if len({of(row) for row in rows}) > 1]
    left = [[name.rpartition(":")[2] for name in head] + ["runs"]]
    for row in rows:
        has = {**row.values, "method": row.method, "W": f"{row.weight:g}"}
        left.append([has[name] for name in head] + [f"{row.runs}/{row.asked}"])
    blocks, taken = [[]], 0
    at_least = sum(max(len(line[at]) for line in left) + 2 for at in range(len(left[0])))
    for name, unit in result.quantities.items():
        column = [f"{name} [{unit}]"] + [str(row.cells[name]) if name in row.cells else "-" for row in rows]
        wide = max(map(len, column)) + 2
        if blocks[-1] and at_least + taken + wide > width:
            blocks.append([])
            taken = 0
        blocks[-1].append(column)
        taken += wide
    text = []
    for block in blocks:
        text += tables.columns([line + [column[at] for column in block] for at, line in enumerate(left)]) + [""]
    return text[:-1]


def write_csv(path, result, after):
    """A line for each combination and quantity, all of them; a combination without a run has one, with empty numbers."""
    names = list(result.rows[0].values)
    after = "later half" if after is None else f"{after:.9g}"
    with open(path, "w", encoding="utf-8", newline="") as stream:
        table = csv.writer(stream, lineterminator="\n")
        table.writerow([*names, "method", "weight", "quantity", "unit", "mean", "standard_error", "error_by_scatter", "error_within", "runs",
                        "runs_asked", "after_s", "remark"])  # fmt: skip
        for row in result.rows:
            begin = [*row.values.values(), row.method, f"{row.weight:g}"]
            for name, cell in row.cells.items():
                numbers = ["" if math.isnan(each) else repr(float(each)) for each in (cell.mean, cell.error, cell.scatter, cell.within)]
                table.writerow([*begin, name, cell.unit, *numbers, cell.runs, row.asked, after, cell.reason])
            if not row.cells:
                table.writerow([*begin, "", "", "", "", "", "", 0, row.asked, after, "no run has ended"])
