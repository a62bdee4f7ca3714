# SPDX-License-Identifier: GPL-3.0-or-later
"""What tools/report takes of each snapshot of a run, or of each row of /statistics in its place, before means are made of it."""

from dataclasses import dataclass
from typing import Callable, Optional

import numpy

from interphase import bed_statistics, periodic_box
from interphase.input_error import InputError
from interphase.run_records import Records
from interphase.statistics_rows import DEPTHS, StatisticsRows, samples

DATA = ("position", "velocity", "diameter")
WEIGHT = "weight"  # real particles in each sphere; recorded where it differs between them


class Rows:
    """Numbers of each sample, by name."""

    def __init__(self, rows=None):
        self.rows = {} if rows is None else rows

    @classmethod
    def joined(cls, several):
        """Those of one after the other."""
        filled = [each.rows for each in several if len(each.time)]
        return cls({name: numpy.concatenate([numpy.asarray(rows[name]) for rows in filled]) for name in filled[0]} if filled else {})

    def add(self, **values):
        for name, value in values.items():
            self.rows.setdefault(name, []).append(value)

    def __getattr__(self, name):
        return numpy.array(self.rows.get(name, ()))


@dataclass(frozen=True)
class Piece:
    """A record, or a part of one: of `run` the snapshots that are `chosen(frame)`, at each of which `progress(number, time)` is called, or in their place the
    rows `taken` whose time is `series_chosen(time)`, as rows of /series are."""

    run: Records
    chosen: Callable
    series_chosen: Callable
    taken: Optional[StatisticsRows] = None
    progress: Optional[Callable] = None

    def rows(self, scene):
        """`Rows` of it, of what the `Scene` wants. InputError where a snapshot lacks what is needed."""
        if self.taken is not None:
            return Rows(samples(self.taken, self.series_chosen))
        return of_snapshots(self.run, scene, self.chosen, self.progress)


def of_snapshots(run, scene, chosen, progress=None):
    """`Rows` of the snapshots of `Records` that are chosen."""
    rows, box = Rows(), periodic_box.of_run(run)
    for frame in run.frames(only=(*DATA, WEIGHT)):
        if not chosen(frame):
            continue
        state = frame.load().quantities
        missing = [name for name in DATA if name not in state]
        if missing:
            raise InputError(f"{frame.where}: no data set {' and '.join(missing)}")
        weight = state.setdefault(WEIGHT, numpy.ones(len(state["diameter"])))
        for name in (*DATA, WEIGHT):
            if not numpy.isfinite(state[name]).all():
                raise InputError(f"{frame.where}: {name} holds NaN or infinite values; end before it by --until")
        _measure_snapshot(state["position"], state["velocity"], state["diameter"], weight, scene, rows, box)
        rows.add(time=frame.time)
        if progress:
            progress(len(rows.rows["time"]), frame.time)
    return rows


def _measure_snapshot(position, velocity, diameter, weight, scene, rows, box):
    rows.add(spheres=len(diameter))
    if scene.windows:
        moments = (
            bed_statistics.window_moments(position, velocity, weight, scene.windows, depth == "front_slice")
            for depth in DEPTHS
        )
        number, real, sums, temperatures = zip(*moments)
        rows.add(number=number, real=real, sums=sums, temperatures=temperatures)
    if scene.overlaps:
        values = bed_statistics.overlaps(position, diameter, box)
        rows.add(
            pairs=len(values), overlap_counts=bed_statistics.overlap_counts(values), largest=values.max(initial=0.0),
            below=[numpy.count_nonzero(values < share) for share in scene.overlaps.shares],
        )
    if scene.voidage:
        solid, outside = bed_statistics.solid_fraction(position, diameter, scene.voidage.mesh)
        voidage = 1 - solid.ravel()
        edges = numpy.linspace(scene.voidage.lowest, scene.voidage.highest, scene.voidage.bins + 1)
        counts = _counted(voidage, edges)
        rows.add(voidage_counts=counts, limit_counts=_counted(voidage, scene.voidage.limits), outside=outside)


def _counted(values, edges):
    """Numbers of values below the first edge, between them, and above the last: [len(edges) + 1].

    A value on an edge belongs to the bin above, on the last one to the bin below it (if there is one): a voidage of 1 is
    no more than the histogram's end.
    """
    edges = numpy.asarray(edges, dtype=float)
    counts = numpy.bincount(numpy.searchsorted(edges, values, side="right"), minlength=len(edges) + 1)
    at_end = numpy.count_nonzero(values == edges[-1])
    if len(edges) > 1:
        counts[-1] -= at_end
        counts[-2] += at_end
    return counts
