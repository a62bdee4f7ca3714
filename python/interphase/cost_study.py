# SPDX-License-Identifier: GPL-3.0-or-later
"""The cost of the particles in sscp1 against S, W and N, from beds that have bubbled for a while: the paper's eqs. 24 to 28 beside what is measured."""

import csv
import os
import statistics
from dataclasses import dataclass

from interphase import cost_model, tables
from interphase.case import Case
from interphase.input_error import InputError
from interphase.run import Run
from interphase.tree import CASES

CASE = os.path.join(CASES, "sscp1")
DEPTH, COUNT, S = 0.0762, 95000, 20  # of the case; steps in a collision of DEM
SKIPPED = 2  # gas steps, in which lists are made and memories of contacts begin
PHASES = ("solids", "gas", "mapping", "exchange")


@dataclass(frozen=True)
class Point:
    """A variant: `depth` of the vessel in that of the case, with as many times the particles. `span`: simulated [s]."""

    method: str
    weight: float
    steps: float
    depth: float
    span: float

    @property
    def bed(self):
        return self.weight, self.depth

    @property
    def tracked(self):
        return COUNT * self.depth / self.weight

    @property
    def by_the_paper(self):
        """Cost over that of DEM in the case, eqs. 24 to 27."""
        return self.depth * cost_model.by_the_paper(self.weight, S, self.steps)


POINTS = [
    *(Point("DEM" if w == 1 else "CGPM", w, 20, 1, span) for w, span in ((1, 0.008), (2, 0.015), (8, 0.04), (27, 0.06))),
    Point("CGPM", 8, 10, 1, 0.04), Point("CGPM", 8, 40, 1, 0.03),
    Point("CGPM", 8, 20, 0.6, 0.05), Point("CGPM", 8, 20, 1.6, 0.03),
    *(Point("TDHS" if w == 1 else "CGHS", w, 1, 1, span) for w, span in ((1, 0.015), (2, 0.03), (8, 0.06), (27, 0.06))),
    Point("CGHS", 8, 0.5, 1, 0.06), Point("CGHS", 8, 2, 1, 0.06),
    Point("CGHS", 8, 1, 0.6, 0.06), Point("CGHS", 8, 1, 1.6, 0.05),
    *(Point("MPPIC", w, 0, 1, 0.05) for w in (2, 8, 27)),
]  # fmt: skip


def entries(point):
    """The settings of a variant. The mesh keeps its number of cells: of the cost of the particles it is no part."""
    found = {"method": point.method, "weight": f"{point.weight:g}", "depth": DEPTH * point.depth, "particleCount": round(COUNT * point.depth),
             "records/interval": 1e-3, "checkpoint/wallInterval": 0}  # fmt: skip
    if point.steps and point.steps != (S if point.method in ("DEM", "CGPM") else 1):
        found["particles/stepsPerCollision"] = point.steps
    return found


def bed_of(weight, depth, start, scratch):
    """The folder of a run of hard spheres to `start` [s], made where it is not there yet."""
    folder = os.path.join(scratch, f"bed-{weight:g}-{depth:g}")
    if os.path.isdir(folder) and Run(folder).ok:
        return folder
    point = Point("TDHS" if weight == 1 else "CGHS", weight, 1, depth, start)
    run = Case(CASE).set(entries(point)).run(folder, until=start, overwrite=True)
    if not run.ok:
        raise InputError(f"the bed in {folder} {run.state}")
    return folder


def measure(point, start, scratch):
    """{phase: CPU seconds per simulated second}, solid steps in a second, of a variant that goes on from `start`, "RUN@TIME"; MP-PIC begins at its
    own, as other methods' beds fill cells beyond its close packing."""
    changed = Case(CASE).set(entries(point))
    run = changed.run(os.path.join(scratch, "variant"), until=point.span, start=None if point.method == "MPPIC" else start, overwrite=True)
    if not run.ok:
        raise InputError(f"{point}: the run {run.state}")
    found = {}
    for phase in PHASES:
        rows = run.processor_time[phase]
        found[phase] = float((rows.values[-1] - rows.values[SKIPPED]) / (rows.time[-1] - rows.time[SKIPPED]))
    return found, 1 / float(run.meta["solid_step"])


def study(rounds, start, scratch, path, say):
    """Measures every variant, `rounds` times in turn, and writes the table of medians and extremes at `path`."""
    beds = {}
    for point in POINTS:
        if point.method != "MPPIC" and point.bed not in beds:
            say(f"bed of W = {point.weight:g}, {point.depth:g} of the depth")
            beds[point.bed] = bed_of(*point.bed, start, scratch)
    found = {point: [] for point in POINTS}
    for turn in range(rounds):
        for point in POINTS:
            found[point].append(measure(point, f"{beds.get(point.bed)}@{start:g}", scratch))
            write(path, found)
        say(f"round {turn + 1} of {rounds}")


COLUMNS = ("method", "weight", "steps_per_collision", "depth", "tracked", "solid_steps_per_s", "solids", "solids_least", "solids_most", "gas", "mapping",
           "exchange", "by_the_paper")  # fmt: skip


def write(path, found):
    with open(path, "w", newline="", encoding="utf-8") as stream:
        rows = csv.writer(stream, lineterminator="\n")
        rows.writerow(COLUMNS)
        for point, rounds in found.items():
            if not rounds:
                continue
            solids = [spent["solids"] for spent, _ in rounds]
            others = [f"{statistics.median(spent[phase] for spent, _ in rounds):.4g}" for phase in PHASES[1:]]
            rows.writerow([point.method, f"{point.weight:g}", f"{point.steps:g}", f"{point.depth:g}", f"{point.tracked:.0f}", f"{rounds[0][1]:.5g}",
                           f"{statistics.median(solids):.4g}", f"{min(solids):.4g}", f"{max(solids):.4g}", *others,
                           f"{point.by_the_paper:.4g}" if point.steps else ""])  # fmt: skip


def read(path):
    """Rows of a table of `study` {column: number, or text of the method}."""
    try:
        with open(path, newline="", encoding="utf-8") as stream:
            return [{name: text if name == "method" else float(text or "nan") for name, text in row.items()} for row in csv.DictReader(stream)]
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: no table of tools/bench cost-model: {error}") from None


SERIES = (  # what varies, of which methods, by the paper's exponent of the cost
    ("W", ("DEM", "CGPM"), "weight", -1.5), ("W", ("TDHS", "CGHS"), "weight", -1.5), ("W", ("MPPIC",), "weight", -1.0),
    ("S", ("CGPM",), "solid_steps_per_s", 1.0), ("S", ("CGHS",), "solid_steps_per_s", 1.0),  # those taken: a gas step has one at least
    ("N", ("CGPM",), "tracked", 1.0), ("N", ("CGHS",), "tracked", 1.0),
)  # fmt: skip


def of_series(rows, what, methods, least_weight=0):
    """Those of one of SERIES, in its order: what does not vary is that of the case with W = 8."""
    usual = {"weight": 8.0, "depth": 1.0, "steps_per_collision": 20.0 if methods[-1] == "CGPM" else 0.0 if methods[-1] == "MPPIC" else 1.0}
    varies = {"W": "weight", "S": "steps_per_collision", "N": "depth"}[what]
    held = {name: value for name, value in usual.items() if name != varies}
    fit = [row for row in rows if row["method"] in methods and all(row[name] == value for name, value in held.items()) and row["weight"] >= least_weight]
    return sorted(fit, key=lambda row: row[varies])


def report(path):
    """Lines: the table, and the exponents of it beside the paper's."""
    rows = read(path)
    dem = next((row["solids"] for row in rows if row["method"] == "DEM"), float("nan"))
    out = [("method", "W", "S", "tracked", "solids [CPU s/s]", "least to most", "DEM / it", "by eqs. 24 to 27", "ns a step and sphere", "gas", "mapping, exchange")]
    for row in rows:
        foretold = f"{1 / row['by_the_paper']:.3g}" if row["by_the_paper"] == row["by_the_paper"] else ""
        out.append((row["method"], f"{row['weight']:g}", f"{row['steps_per_collision']:g}" if row["steps_per_collision"] else "", f"{row['tracked']:.0f}",
                    f"{row['solids']:.3g}", f"{row['solids_least']:.3g} to {row['solids_most']:.3g}", f"{dem / row['solids']:.3g}", foretold,
                    f"{1e9 * row['solids'] / row['solid_steps_per_s'] / row['tracked']:.0f}", f"{row['gas']:.3g}", f"{row['mapping'] + row['exchange']:.3g}"))  # fmt: skip
    lines = tables.columns(out, right=range(1, 11))
    fits = [("cost of the particles ~", "exponent", "of the paper", "from")]
    for what, methods, column, paper in SERIES:
        mine = of_series(rows, what, methods)
        if len(mine) > 1:
            spread = [(row["solids_most"] - row["solids_least"]) / 2 / row["solids"] for row in mine]  # of rounds: rather too large an error of their median
            power, error = cost_model.exponent([row[column] for row in mine], [row["solids"] for row in mine], spread)
            fits.append((f"{what}, {' and '.join(methods)}", f"{power:.2f} +- {error:.2f}", f"{paper:g}", ", ".join(f"{row[column]:g}" for row in mine)))
    return [*lines, "", *tables.columns(fits)]
