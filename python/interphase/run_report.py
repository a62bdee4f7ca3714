# SPDX-License-Identifier: GPL-3.0-or-later
"""The statistics of one run, or of replicates as one record, as Lu et al. give them: profiles, granular temperature, overlaps, voidage, pressure drop.

They are made of the rows of /statistics, which the run has taken, or of snapshots: read one by one, a few hundred numbers of each kept.
"""

import dataclasses
import math
from dataclasses import dataclass, field
from typing import Optional

import numpy

from interphase import bed_statistics, report_means, time_statistics as statistics
from interphase.input_error import InputError
from interphase.record_samples import Rows
from interphase.run import NO_PRESSURE_DROP
from interphase.spectrum import COPIES, Spectrum, power_spectrum, strongest_frequency
from interphase.statistical_comparison import uneven
from interphase.statistics_rows import DEPTHS
from interphase.time_statistics import Mean

FREQUENCY = "pressure drop, strongest frequency"
COMPONENTS = ("horizontal", "vertical")


@dataclass(frozen=True)
class Quantity:
    """A number to be shown and compared; `mean` None: there is nothing to take it of. `shown_times`: for the table."""

    name: str
    unit: str
    mean: Optional[Mean]
    shown_times: float = 1.0


@dataclass
class Profile:
    """Over the windows, for one depth: `Mean`s [windows] or None where no sphere's centre was in the window."""

    number: list
    velocity: dict
    temperature: list
    temperature_of: dict


@dataclass
class Histogram:
    """Shares of all values in the bins between `edges`, with standard errors (NaN: unknown); `below` and `above` them."""

    edges: numpy.ndarray
    share: numpy.ndarray
    error: numpy.ndarray
    below: float
    above: float


@dataclass
class RunReport:
    """All of it, of `snapshots` snapshots or, where `of_rows`, rows of /statistics. `first`, `last`: times of the first and last snapshot [s], of rows of /series where there are no snapshots.
    `recorded`: time to which the run had gone [s]. `rows`: number and times of the first and last row of /series. `needed`: time to which the run must go at least to tell the end of
    its start-up [s]. `pieces`: of how many runs, replicates, of which each has that time range. What is None was not measured."""

    snapshots: int
    first: float
    last: float
    windows: Optional[numpy.ndarray] = None
    profiles: dict = field(default_factory=dict)
    overlap: Optional[Histogram] = None
    largest_overlap: Optional[float] = None
    overlaps: list = field(default_factory=list)
    voidage: Optional[Histogram] = None
    voidages: list = field(default_factory=list)
    series: list = field(default_factory=list)
    recorded: float = math.nan
    rows: tuple = (0, math.nan, math.nan)
    needed: Optional[float] = None
    pressure: Optional[tuple] = None
    spectrum: Optional[Spectrum] = None
    notes: list = field(default_factory=list)
    of_rows: bool = False
    pieces: int = 1

    @property
    def kind_of_voidage(self):
        """Rows tell it as the gas has it, mapped, snapshots of the spheres where they lie: two quantities, of which the first one is smoother."""
        return "mapped voidage" if self.of_rows else "voidage"


def measure(pieces, scene, unsettled=None):
    """The `RunReport` of a `record_samples.Piece`, or of several as one record; without snapshots that count, what /series gives.

    `unsettled`: the `StartUp` for whose reason no mean is to be trusted, None where start-up is over. InputError where a snapshot lacks what is needed.

    Of several, errors are as time_statistics.of_replicates has them, and spectra are not made.
    """
    found = [each.rows(scene) for each in pieces]
    report = _of(pieces, found, scene, with_spectrum=len(pieces) == 1)
    if len(pieces) > 1:
        report_means.take_scatter_in(report, [_of([piece], [rows], scene, with_spectrum=False) for piece, rows in zip(pieces, found)])
    if unsettled is not None:
        report.needed = unsettled.needed
        report_means.distrust(report, f"start-up not known to be over: {unsettled.reason}")
    return report


def _of(pieces, found, scene, with_spectrum):
    """The `RunReport` of pieces as one record, of which the `Rows` are `found`."""
    rows = Rows.joined(found)
    times = rows.time
    report = RunReport(len(times), *((float(times.min()), float(times.max())) if len(times) else (math.nan, math.nan)), of_rows=all(each.taken is not None for each in pieces),
                       pieces=len(pieces))  # fmt: skip
    _tell_uneven(report, "rows of /statistics" if report.of_rows else "snapshots", [each.time for each in found])
    if scene.windows and len(times):
        _windows(report, scene.windows, rows)
    if scene.overlaps and len(times):
        _overlaps(report, scene.overlaps, rows)
    if scene.voidage and len(times):
        _voidage(report, scene.voidage, rows)
    _series(report, pieces, with_spectrum)
    report.recorded = max(each.run.last_time() for each in pieces)
    return report


def _windows(report, windows, rows):
    edges = bed_statistics.window_edges(windows)
    report.windows = (edges[1:] + edges[:-1]) / 2
    for at, depth in enumerate(DEPTHS):
        numbers, real = rows.number[:, at], rows.real[:, at]
        sums, temperatures = rows.sums[:, at], rows.temperatures[:, at]
        every = range(windows.count)
        report.profiles[depth] = Profile(
            [statistics.mean_with_error(numbers[:, w]) for w in every],
            {name: [_ratio(sums[:, w, axis], real[:, w]) for w in every] for axis, name in enumerate(COMPONENTS)},
            [_mean(temperatures[:, w].sum(axis=1) / 3) for w in every],
            {name: [_mean(temperatures[:, w, axis]) for w in every] for axis, name in enumerate(COMPONENTS)},
        )


def _ratio(above, below):
    return statistics.ratio_with_error(above, below) if below.any() else None


def _mean(values):
    """`Mean` of what is not NaN, None where nothing is left."""
    values = values[numpy.isfinite(values)]
    return statistics.mean_with_error(values) if len(values) else None


def _overlaps(report, wanted, rows):
    counts, pairs = rows.overlap_counts, rows.pairs
    report.largest_overlap = float(rows.largest.max())
    # The bins reach wide; the histogram ends where the values do.
    edges = bed_statistics.OVERLAP_EDGES
    filled = numpy.flatnonzero(counts.any(axis=0))
    if len(filled):
        kept = slice(filled[0], filled[-1] + 1)
        share = counts.sum(axis=0) / pairs.sum()
        # Errors of hundreds of narrow bins tell little; shares and percentiles below have theirs.
        report.overlap = Histogram(edges[filled[0]:filled[-1] + 2], share[kept], numpy.full(len(share[kept]), math.nan), 0.0, 0.0)
    for at, share in enumerate(wanted.shares):
        mean = _ratio(rows.below[:, at], pairs)
        report.overlaps.append(Quantity(f"overlaps below {100 * share:g} % d", "%", mean, 100))
    for level in wanted.percentiles:
        mean = statistics.quantile_with_error(counts, edges, level / 100) if pairs.any() else None
        report.overlaps.append(Quantity(f"overlap, percentile {level:g}", "% d", mean, 100))
    report.overlaps.append(Quantity("overlapping pairs per sphere", "1", _ratio(pairs, rows.spheres)))


def _voidage(report, wanted, rows):
    counts, cells = rows.voidage_counts, wanted.cells
    share = counts / cells
    report.voidage = Histogram(
        numpy.linspace(wanted.lowest, wanted.highest, wanted.bins + 1), share[:, 1:-1].mean(axis=0),
        numpy.array([statistics.mean_with_error(column).error for column in share[:, 1:-1].T]),
        float(share[:, 0].mean()), float(share[:, -1].mean()),
    )
    limits = wanted.limits
    what = report.kind_of_voidage
    names = [f"{what} below {limits[0]:g}", *(f"{what} {a:g} to {b:g}" for a, b in zip(limits, limits[1:])),
             f"{what} above {limits[-1]:g}"]
    for name, column in zip(names, rows.limit_counts.T):
        report.voidages.append(Quantity(name, "% of cells", statistics.mean_with_error(column / cells), 100))
    if rows.outside.any():
        most = rows.outside.max()
        report.notes.append(f"spheres with their centre outside the mesh, left out of the voidage: up to {most} at a time")


def _tell_uneven(report, what, times_of_pieces):
    """A note where samples of a piece come at uneven times. Returns whether they do."""
    spread = next((found for times in times_of_pieces if (found := uneven(times)) is not None), None)
    if spread is not None:
        report.notes.append(f"{what} are {spread[0]:.4g} to {spread[1]:.4g} s apart; means are over samples, not over time")
    return spread is not None


def _rows_of_series(report, piece):
    """(time [n], {name: [n]}) of the rows of /series that are chosen, None where there are none, which a note tells."""
    try:
        found = piece.run.series()
    except InputError as error:
        report.notes.append(f"no series: {error}")
        return None
    if found is None:
        report.notes.append("no /series: neither pressure drop nor bed height nor kinetic energy")
        return None
    times, columns = found
    inside = numpy.array([piece.series_chosen(time) for time in times], dtype=bool)
    if not inside.any():
        report.notes.append("no row of /series lies in the time range")
        return None
    return times[inside], {name: column[inside] for name, column in columns.items()}


def _series(report, pieces, with_spectrum):
    found = [rows for piece in pieces if (rows := _rows_of_series(report, piece)) is not None]
    if not found:
        return
    times = numpy.concatenate([each for each, _ in found])
    values = {name: numpy.concatenate([columns[name] for _, columns in found]) for name in found[0][1] if all(name in columns for _, columns in found)}
    report.rows = len(times), float(times.min()), float(times.max())
    if not report.snapshots:
        report.first, report.last = report.rows[1:]
    spread = _tell_uneven(report, "rows of /series", [each for each, _ in found])
    apart = max(numpy.diff(each).max(initial=0.0) for each, _ in found)
    if report.last - report.rows[2] > 1.5 * apart:
        report.notes.append(f"rows of /series end at {report.rows[2]:.4g} s, before the snapshots: what comes from them is of less time")
    for name, unit in (("pressure_drop", "Pa"), ("bed_height", "m"), ("kinetic_energy", "J")):
        if name not in values:
            report.notes.append(NO_PRESSURE_DROP if name == "pressure_drop" else f"/series/{name}: not there")
            continue
        if not numpy.isfinite(values[name]).all():
            report.notes.append(f"/series/{name}: NaN or infinite values")
            continue
        mean = statistics.mean_with_error(values[name])
        report.series.append(Quantity(name.replace("_", " "), unit, mean))
        if name == "pressure_drop":
            report.series.append(Quantity("pressure drop, deviation", "Pa", statistics.deviation_with_error(values[name])))
            if not with_spectrum:
                report.notes.append("no spectrum of the pressure drop: the record is in pieces")
                continue
            report.pressure = times, values[name]
            if not spread:
                report.spectrum = power_spectrum(times, values[name])
                _strongest(report, times, values[name], mean)


def _strongest(report, times, values, whole):
    """What is not the frequency's own is that of the series' mean, `whole`."""
    found = strongest_frequency(times, values)
    if found.reason:
        report.notes.append(f"strongest frequency of the pressure drop: {found.reason}")
        return
    if math.isfinite(found.rival):
        report.notes.append(f"strongest frequency of the pressure drop: as far as this record tells, a peak at {found.rival:.3g} Hz may be the higher one as well; half of "
                            "what is between them is in the error")  # fmt: skip
    mean = dataclasses.replace(whole, value=found.value, error=found.error, freedom=float(COPIES - 1))
    report.series.append(Quantity(FREQUENCY, "Hz", mean))
