# SPDX-License-Identifier: GPL-3.0-or-later
"""The run, and the time of it, that another one starts from: `RUN[@time]`."""

import hashlib
import os
from dataclasses import dataclass
from typing import Optional

import numpy

from interphase import run_state
from interphase.input_error import InputError
from interphase.particle_states import ParticleState
from interphase.run_records import find_run
from interphase.same_time import same_time


@dataclass
class StartingRun:
    """`folder`: the run's; `where`: names its snapshot in messages; `time` [s] of it, `particles` then. `weight`: real particles
    per tracked one; `method`; both None where the run has not recorded them. `results`: path of its results.h5, if it is there."""

    folder: str
    where: str
    time: float
    particles: ParticleState
    weight: Optional[float]
    method: Optional[str]
    results: Optional[str]

    def provenance(self):
        """What tells later which run it was."""
        return {"run": self.folder, "time": self.time, "snapshot": self.where, "method": self.method, "weight": self.weight,
                "particles": len(self.particles.ids), "results_sha256": _sha256(self.results) if self.results else None}


def find(text):
    """The `StartingRun` that RUN[@time] names; without a time its last whole snapshot. InputError where there is none."""
    folder, asked = _split(text)
    folder = os.path.abspath(run_state.checked_folder(folder, "a run's folder, with @TIME or without"))
    run = find_run(folder)
    if run is None or run.particles is None:
        raise InputError(f"{folder}: there is no particles.h5 in it: it is no run, or one that has not recorded its particles")
    times = [frame.time for frame in run.frames()]
    if not times:
        raise InputError(f"{folder}: particles.h5 holds no whole snapshot; snapshotInterval of records in couplingDict asks for them")
    time = times[-1] if asked is None else min(times, key=lambda each: abs(each - asked))
    if asked is not None and not same_time(time, asked):
        raise InputError(f"{folder}: no whole snapshot at t = {asked:.9g} s; the nearest is at {time:.9g} s: --from {folder}@{time:.9g}")
    for frame in run.frames():
        if frame.time == time:
            state = frame.load()
            _check(state, frame.where)
            weight = run.recorded("weight")
            return StartingRun(folder, frame.where, time, state, weight and float(weight), run.recorded("method"), run.results)
    raise InputError(f"{folder}: its snapshot of t = {time:.9g} s is gone; does the run still write?")


def _split(text):
    if os.path.isdir(text) or "@" not in text:
        return text, None
    folder, _, time = text.rpartition("@")
    try:
        asked = float(time)
    except ValueError:
        asked = numpy.nan
    if not 0 <= asked < numpy.inf:
        raise InputError(f"--from {text}: '{time}' is no time in s")
    return folder, asked


def _check(state, where):
    """What a start needs of a snapshot is there, and is numbers."""
    for name in ("position", "velocity", "spin", "diameter"):
        if name not in state.quantities:
            raise InputError(f"{where}: no data set of the {name}")
        if not numpy.isfinite(state.quantities[name]).all():
            raise InputError(f"{where}: {name} holds NaN or infinite values; take an earlier time")
    if len(state.ids) == 0:
        raise InputError(f"{where}: there are no particles; take another time")


def _sha256(path):
    digest = hashlib.sha256()
    with open(path, "rb") as stream:
        for block in iter(lambda: stream.read(1 << 20), b""):
            digest.update(block)
    return digest.hexdigest()
