# SPDX-License-Identifier: GPL-3.0-or-later
"""Read what a run of ours has recorded: particles.h5 and results.h5."""

import os

import h5py
import numpy

from interphase import run_state
from interphase.input_error import InputError
from interphase.particle_states import Frame, by_id
from interphase.stored import attributes, open_h5
from interphase.whole_records import whole_rows, whole_snapshots

PARTICLES, RESULTS = "particles.h5", "results.h5"
DATASETS = {"position": "position", "velocity": "velocity", "angular_velocity": "spin", "force": "force"}


class Records:
    """What a run has recorded, as comparisons and reports walk through it. `particles` and `results` are the paths of the files that are
    there, else None."""

    kind = "run"
    digits = None
    text_columns = frozenset()

    def __init__(self, path, particles=None, results=None, meta=None):
        """`meta`: the results.h5 to take the solid step from, where its series are not asked for."""
        self.path, self.particles, self.results = path, particles, results
        self._meta = results or meta

    def describe(self):
        """Path and files, for a report."""
        parts = [os.path.basename(file) for file in (self.particles, self.results) if file]
        return f"{self.path} ({self.kind}: {', '.join(parts)})"

    @property
    def meta(self):
        """{name: number or text} of /meta of results.h5."""
        return attributes(self._meta, "meta") if self._meta else {}

    @property
    def record(self):
        """What run.json says, {} where it is not there or cannot be read."""
        try:
            return run_state.record(self.path)
        except InputError:
            return {}

    def recorded(self, name):
        """Of the run as a whole, `weight` or `method`, as /meta says, else run.json; None where neither does."""
        return self.meta.get(name, self.record.get(name))

    def solid_step(self):
        """The attribute `solid_step` of /meta [s], None where it is not recorded."""
        value = self.meta.get("solid_step")
        if value is None:
            return None
        try:
            step = float(numpy.asarray(value).reshape(()))
        except (TypeError, ValueError):
            step = numpy.nan
        if not 0 < step < numpy.inf:
            raise InputError(f"{self._meta}: /meta attribute solid_step = {value!r}; a time in s above 0 is expected")
        return step

    def snapshot_times(self):
        """[n] of all snapshots, s; empty where none was recorded."""
        return [frame.time for frame in self.frames()]

    def last_time(self):
        """Of the last snapshot or row of /series, s; NaN where there is neither."""
        series = self.series()
        return max([*self.snapshot_times()[-1:], *([] if series is None else series[0][-1:].tolist())], default=numpy.nan)

    def frames(self, only=None):
        """`Frame`s in the order of time; `only`: the data sets to load, all where None."""
        if self.particles is None:
            return
        with open_h5(self.particles) as file:
            if "snapshots" not in file:
                raise InputError(f"{self.particles}: no group /snapshots; is it the particles.h5 of a run?")
            whole = whole_snapshots(file)
            for (earlier, name, _), (later, other, _) in zip(whole, whole[1:]):
                if not earlier < later:
                    raise InputError(f"{self.particles}: snapshots {name} and {other} both are of time {later!r} s")
            for time, name, group in whole:
                where = f"{self.particles}:/snapshots/{name} (t = {time:.9g} s)"
                yield Frame(where, None, time, lambda group=group, where=where: self._particles(group, where, only))

    @staticmethod
    def _particles(group, where, only=None):
        def refuse(message):
            raise InputError(message)

        if "id" not in group:
            refuse(f"{where}: no dataset `id`; particles are matched by it")
        ids = group["id"][()]
        quantities = {}
        for name, dataset in group.items():
            if name == "id" or not isinstance(dataset, h5py.Dataset) or dataset.dtype.kind not in "fiu":
                continue
            if only is not None and name not in only:
                continue
            shape = (len(ids), 3) if name in DATASETS else (len(ids),)
            if dataset.shape[:1] != shape[:1] or (name in DATASETS and dataset.shape != shape):
                refuse(f"{where}: dataset {name} has shape {dataset.shape}, {shape} is expected for {len(ids)} ids")
            quantities[DATASETS.get(name, name)] = dataset[()].astype(float)
        return by_id(ids, quantities, None, where, refuse)

    def series(self):
        """(time [n], {name: values [n]}) of results.h5; each column of a two-dimensional dataset is its own series."""
        if self.results is None:
            return None
        with open_h5(self.results) as file:
            if "series" not in file or "time" not in file["series"]:
                return None
            group = file["series"]
            rows = whole_rows(group)
            time = numpy.asarray(group["time"][:rows], dtype=float)
            if time.ndim != 1 or not numpy.isfinite(time).all() or not (numpy.diff(time) > 0).all():
                raise InputError(f"{self.results}: /series/time must be finite and ascend, found shape {time.shape}"
                                 f"{self._bad_time(time)}")
            found = {}
            for name, dataset in group.items():
                if name == "time" or not isinstance(dataset, h5py.Dataset) or dataset.dtype.kind not in "fiu":
                    continue
                values = numpy.asarray(dataset[:rows], dtype=float)
                if values.ndim == 1:
                    found[name] = values
                else:
                    for i, column in enumerate(values.reshape(len(time), -1).T):
                        found[f"{name}[{i}]"] = column
            return time, found

    @staticmethod
    def _bad_time(time):
        if time.ndim != 1:
            return ""
        bad = numpy.flatnonzero(~(numpy.diff(time) > 0))
        return f"; time[{bad[0] + 1}] = {time[bad[0] + 1]!r} after {time[bad[0]]!r}" if len(bad) else ""


def find_run(path):
    """The `Records` that `path` means, None if it is none: a folder with particles.h5 or results.h5, or such a file."""
    if os.path.isdir(path):
        files = [os.path.join(path, name) for name in (PARTICLES, RESULTS)]
        files = [file if os.path.isfile(file) else None for file in files]
        return Records(path, *files) if any(files) else None
    if not os.path.isfile(path) or not h5py.is_hdf5(path):
        return None
    with open_h5(path) as file:
        particles, series = "snapshots" in file, "series" in file or "meta" in file
    if not particles and not series:
        raise InputError(f"{path}: holds neither /snapshots (particles.h5) nor /series (results.h5)")
    beside = os.path.join(os.path.dirname(path), RESULTS)
    return Records(path, path if particles else None, path if series else None, beside if os.path.isfile(beside) else None)
