# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers over time of a run's results.h5, and their means."""

import os
from collections.abc import Mapping
from dataclasses import dataclass

import h5py
import numpy

from interphase import stored, time_statistics
from interphase.input_error import InputError
from interphase.run import no_such
from interphase.statistical_comparison import uneven
from interphase.stored import open_h5
from interphase.whole_records import whole_rows


@dataclass(frozen=True)
class Average:
    """A mean over `samples` rows: `value` and its standard `error`, in `unit`, autocorrelation taken in (time_statistics.py).

    `reason` is empty, or says why the error is not to be trusted; then it is NaN where there is none.
    """

    value: float
    error: float
    unit: str
    samples: int
    reason: str = ""

    def __str__(self):
        return f"{self.value:.6g} +- {self.error:.2g} {self.unit}" + (f" (error not to be trusted: {self.reason})" if self.reason else "")


@dataclass(frozen=True)
class Series:
    """`values` [n] or [n, components] in `unit` at the times `time` [n], s."""

    name: str
    time: numpy.ndarray
    values: numpy.ndarray
    unit: str

    def between(self, after=None, until=None):
        """The part at `after` <= time <= `until` [s]; InputError where no row is there."""
        inside = (self.time >= (-numpy.inf if after is None else after)) & (self.time <= (numpy.inf if until is None else until))
        if not inside.any():
            have = f"{self.time[0]:.6g} to {self.time[-1]:.6g} s" if len(self.time) else "none yet"
            raise InputError(f"{self.name}: no rows after {after} s until {until} s; there are rows of {have}")
        return Series(self.name, self.time[inside], self.values[inside], self.unit)

    def mean(self, after=None, until=None):
        """The `Average` at `after` <= time <= `until` [s]. InputError where a value is not finite, or the series has components."""
        part = self.between(after, until)
        if part.values.ndim != 1:
            raise InputError(f"{self.name} has {part.values.shape[1]} components: average one of them")
        if not numpy.isfinite(part.values).all():
            bad = part.time[~numpy.isfinite(part.values)]
            raise InputError(f"{self.name} is not finite in {len(bad)} rows, first at t = {bad[0]:.6g} s; average a part without them")
        found = time_statistics.mean_with_error(part.values)
        reason, spread = found.reason, uneven(part.time)
        if spread:
            apart = f"rows are {spread[0]:.4g} to {spread[1]:.4g} s apart, and the mean is over rows"
            reason = f"{reason}; {apart}" if reason else apart
        return Average(found.value, found.error, part.unit, len(part.time), reason)


class Table(Mapping):
    """{name: Series} of a group of results.h5, read when asked for: a run that still goes has more rows the next time."""

    def __init__(self, path, group):
        self._path, self._group = path, group

    def _open(self):
        if not os.path.isfile(self._path):
            raise InputError(f"{self._path}: not there: the run has not recorded anything yet")
        return open_h5(self._path)

    def __getitem__(self, name):
        with self._open() as file:
            names = self._names(file)
            if name not in names and not (names and name == "time"):
                raise no_such(f"/{self._group} of {self._path}", name, names)
            group = file[self._group]
            rows = whole_rows(group)
            unit = stored.word(group[name].attrs.get("unit", ""))
            return Series(name, group["time"][:rows].astype(float), group[name][:rows].astype(float), unit)

    def _names(self, file):
        if self._group not in file or "time" not in file[self._group]:
            return []
        return [name for name, data in file[self._group].items() if name != "time" and isinstance(data, h5py.Dataset) and data.ndim]

    def __iter__(self):
        with self._open() as file:
            return iter(self._names(file))

    def __len__(self):
        return sum(1 for _ in self)

    def __contains__(self, name):
        return name in list(self)

    def get(self, name, default=None):
        return self[name] if name in self else default
