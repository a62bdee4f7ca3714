# SPDX-License-Identifier: GPL-3.0-or-later
"""Where two records of the same particles differ, and by how much: streamed, one time in memory."""

import math
from dataclasses import dataclass, field
from typing import Optional

import numpy

from interphase.input_error import InputError
from interphase.matching_times import merged
from interphase.particle_states import UNITS


@dataclass
class Largest:
    """What is known of one quantity's differences, b - a; particle is None for a series.

    `first` is the first moment that differs, `first_particle` the lowest id that does so then.
    `size` is the length of the difference vector, or the absolute difference; `rms` of the quantity is over both
    sides and all that was compared, NaN and infinities apart. A NaN on one side alone makes `size` infinite.
    """

    name: str
    compared: int = 0
    differing: int = 0
    images: int = 0
    unknown: int = 0
    size: float = 0.0
    particle: Optional[int] = None
    at: str = ""
    values: tuple = ()
    first: str = ""
    first_particle: Optional[int] = None
    squares: float = 0.0
    finite: int = 0

    @property
    def unit(self):
        """Of the quantity, "" where it is not known."""
        return UNITS.get(self.name, "")

    @property
    def rms(self):
        """Root mean square over both sides and all that was compared, in the unit."""
        return math.sqrt(self.squares / self.finite) if self.finite else 0.0

    @property
    def relative(self):
        """`size` over `rms`."""
        if self.size == 0:
            return 0.0
        return self.size / self.rms if self.rms > 0 else math.inf

    def allowed(self, tolerances):
        """The larger of both tolerances, in the unit."""
        absolute, relative = tolerances.of(self.name)
        return max(absolute, relative * self.rms)

    def add(self, a, b, ids, at, box=None):
        """Take in values a, b [n] or [n,3] of the particles `ids` (or None) at the moment `at`, a label or a list.

        Returns the largest difference among them.
        """
        self.compared += len(a)
        if not len(a):
            return 0.0
        for values in (a, b):
            flat = values.ravel()
            total = float(flat @ flat)
            if math.isfinite(total):
                self.squares += total
                self.finite += len(values)
            else:
                known = values[numpy.isfinite(values.reshape(len(values), -1)).all(axis=1)]
                self.squares += float(numpy.sum(known**2))
                self.finite += len(known)
        differs = numpy.ascontiguousarray(a).view(numpy.int64) != numpy.ascontiguousarray(b).view(numpy.int64)
        nans = numpy.isnan(a) & numpy.isnan(b)
        if nans.any():
            self.unknown += int(nans.reshape(len(a), -1).any(axis=1).sum())
            differs &= ~nans
        rows = numpy.flatnonzero(differs.reshape(len(a), -1).any(axis=1))
        if not len(rows):
            return 0.0
        with numpy.errstate(invalid="ignore", over="ignore"):
            apart = numpy.where(differs[rows], b[rows] - a[rows], 0.0)
        apart[numpy.isnan(apart)] = math.inf
        if box is not None:
            rows, apart = self._nearest_images(rows, apart, box)
            if not len(rows):
                return 0.0
        # hypot, not a sum of squares: the last bit of a tiny number must not vanish.
        sizes = numpy.abs(apart) if apart.ndim == 1 else numpy.hypot(numpy.hypot(apart[:, 0], apart[:, 1]), apart[:, 2])
        label = (lambda row: at) if isinstance(at, str) else (lambda row: at[row])
        if not self.differing:
            self.first = label(rows[0])
            self.first_particle = None if ids is None else int(ids[rows[0]])
        self.differing += len(rows)
        place = int(numpy.argmax(sizes))
        if sizes[place] > self.size or not self.at:
            row = rows[place]
            self.size, self.at = float(sizes[place]), label(row)
            self.particle = None if ids is None else int(ids[row])
            self.values = a[row].tolist(), b[row].tolist()
        return float(sizes[place])

    def _nearest_images(self, rows, apart, box):
        """Take whole periodic box lengths out; rows that then agree exactly are images, not differences."""
        edges = numpy.where(box.periodic, box.edges, math.inf)
        with numpy.errstate(invalid="ignore"):
            lengths = numpy.where(numpy.isfinite(apart), numpy.round(apart / edges), 0.0)
        moved = (lengths != 0).any(axis=1)
        self.images += int(moved.sum())
        apart = apart - lengths * numpy.where(numpy.isfinite(edges), edges, 0.0)
        keep = ~(moved & (apart == 0).all(axis=1))
        return rows[keep], apart[keep]


@dataclass
class Tolerances:
    """Allowed differences: per quantity, else for all: absolute in the quantity's unit, relative to its rms."""

    absolute: dict = field(default_factory=dict)
    relative: dict = field(default_factory=dict)

    def of(self, name):
        """(absolute, relative) of a quantity."""
        return tuple(given.get(name, given.get("", 0.0)) for given in (self.absolute, self.relative))

    def names(self):
        """Quantities that are named."""
        return {name for name in (*self.absolute, *self.relative) if name}

    def __bool__(self):
        return any(value > 0 for value in (*self.absolute.values(), *self.relative.values()))


@dataclass
class OneSided:
    """Moments or particles that only one side has: how many, and the first few as text."""

    count: int = 0
    examples: list = field(default_factory=list)

    def add(self, text, count=1):
        """Count, and keep the text while there are few."""
        self.count += count
        if len(self.examples) < 5:
            self.examples.append(text)


@dataclass
class Difference:
    """The outcome of a comparison.

    `common` names the quantities of both sides, compared or not; `history` has one row per common time: its label and
    the largest difference by quantity. Pairs are of sides A and B.
    """

    quantities: dict = field(default_factory=dict)
    times: int = 0
    first_time: str = ""
    last_time: str = ""
    only_times: tuple = field(default_factory=lambda: (OneSided(), OneSided()))
    only_ids: tuple = field(default_factory=lambda: (OneSided(), OneSided()))
    common: set = field(default_factory=set)
    only_columns: tuple = field(default_factory=lambda: (set(), set()))
    history: list = field(default_factory=list)
    notes: list = field(default_factory=list)

    def largest(self, name):
        """The `Largest` of a quantity, made where there is none yet."""
        return self.quantities.setdefault(name, Largest(name))

    def missing_particles(self):
        """Whether a particle is on one side alone at a common time."""
        return any(side.count for side in self.only_ids)

    def bit_equal(self):
        """Whether nothing differs, periodic images apart."""
        return not self.missing_particles() and not any(q.differing for q in self.quantities.values())

    def beyond(self, tolerances):
        """Names of the quantities that differ by more than allowed."""
        return [q.name for q in self.quantities.values() if q.differing and not q.size <= q.allowed(tolerances)]

    def images(self):
        """How many positions are a whole box length apart."""
        return sum(q.images for q in self.quantities.values())


def wanted(name, only):
    """Whether `name` is chosen by `only`: by itself, or by what stands before its first `/`; all are where that is empty."""
    return not only or name in only or name.split("/")[0] in only


def compare_particles(a, b, matching, difference, start=None, end=None, only=()):
    """Take all common frames of the sources a and b into `difference`."""
    ranges = [[], []]

    def chosen(source, seen):
        for frame in source.frames():
            if matching.within(frame, start, end):
                seen[:] = [seen[0] if seen else frame, frame]
                yield frame

    for left, right in merged(chosen(a, ranges[0]), chosen(b, ranges[1]), matching.key, matching.slack):
        if left is None or right is None:
            difference.only_times[0 if right is None else 1].add(matching.label(left or right))
            continue
        # The side with the step shows both.
        at = matching.label(left if left.step is not None else right)
        difference.times += 1
        difference.first_time = difference.first_time or at
        difference.last_time = at
        _compare_frame(left.load(), right.load(), at, difference, only)
    if not difference.times:
        _no_common_time(a, b, ranges, matching, start, end)


def _compare_frame(a, b, at, difference, only):
    if numpy.array_equal(a.ids, b.ids):
        ids, left, right = a.ids, slice(None), slice(None)
    else:
        ids, left, right = numpy.intersect1d(a.ids, b.ids, assume_unique=True, return_indices=True)
        for one_sided, own, rows in ((difference.only_ids[0], a.ids, left), (difference.only_ids[1], b.ids, right)):
            lone = numpy.delete(own, rows)
            if len(lone):
                shown = ", ".join(map(str, lone[:5])) + (", ..." if len(lone) > 5 else "")
                one_sided.add(f"{shown} at {at}", len(lone))
    for side, own, other in ((0, a, b), (1, b, a)):
        difference.only_columns[side].update(own.quantities.keys() - other.quantities.keys())
    difference.common.update(a.quantities.keys() & b.quantities.keys())
    row = {}
    for name in a.quantities:
        if name in b.quantities and wanted(name, only):
            box = (a.box or b.box) if name == "position" else None
            if box is not None and not any(box.periodic):
                box = None
            row[name] = difference.largest(name).add(
                a.quantities[name][left], b.quantities[name][right], ids, at, box)
    difference.history.append({"at": at, **row})
    if a.box and b.box and a.box != b.box and not any("box" in note for note in difference.notes):
        difference.notes.append(f"the boxes differ at {at}: {a.box} and {b.box}; A's is used for periodic images")


def _no_common_time(a, b, ranges, matching, start, end):
    lines = []
    for source, seen in zip((a, b), ranges):
        have = f"{matching.label(seen[0])} to {matching.label(seen[-1])}" if seen else "none" + (
            " within --from/--until" if (start, end) != (None, None) else "")
        lines.append(f"  {source.path}: {have}")
    how = ""
    if matching.by == "time" and matching.solid_step_from:
        how = f" A dump's time is its time step times {matching.solid_step:.9g} s ({matching.solid_step_from})."
    raise InputError("A and B have no time in common:\n" + "\n".join(lines) + f"\nCompare the same times.{how}")


def compare_series(a, b, matching, difference, start=None, end=None, only=()):
    """Take the series of two runs' results.h5, each (time, {name: values}), into `difference`.

    Returns how many times both have, and how many only a and only b.
    """
    (times_a, series_a), (times_b, series_b) = a, b

    def numbered(times):
        return ((i, float(t)) for i, t in enumerate(times) if matching.inside(t, start, end))

    rows = [[], []]
    lone = [0, 0]
    for left, right in merged(numbered(times_a), numbered(times_b), lambda item: item[1], matching.slack):
        if left is None or right is None:
            lone[0 if right is None else 1] += 1
            continue
        rows[0].append(left[0])
        rows[1].append(right[0])
    if any(lone):
        difference.notes.append(f"series: {lone[0]} times only in A, {lone[1]} only in B, {len(rows[0])} in both")
    for side, own, other in ((0, series_a, series_b), (1, series_b, series_a)):
        difference.only_columns[side].update(f"series/{name}" for name in own.keys() - other.keys())
    difference.common.update(f"series/{name}" for name in series_a.keys() & series_b.keys())
    labels = [f"t = {times_a[i]:.9g} s" for i in rows[0]]
    for name in series_a:
        if name in series_b and labels and wanted(f"series/{name}", only):
            difference.largest(f"series/{name}").add(series_a[name][rows[0]], series_b[name][rows[1]], None, labels)
    return len(labels), lone
