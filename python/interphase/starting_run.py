# SPDX-License-Identifier: GPL-3.0-or-later
"""The run, and the time of it, that another one starts from: `RUN[@time]`."""

import hashlib
import json
import os
from dataclasses import dataclass
from typing import Optional

import numpy

from interphase.input_error import InputError
from interphase.particle_states import ParticleState
from interphase.run_records import find_run, open_h5
from interphase.stored import word

SAME_TIME = 1e-6  # relative: times are typed, and named in folders, with few digits


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
    if not os.path.isdir(folder):
        what = "is a file" if os.path.exists(folder) else "no such folder"
        raise InputError(f"{folder}: {what}; give a run's folder, with @TIME or without, such as runs/sscp1-CGPM-w8@0.5")
    folder = os.path.abspath(folder)
    run = find_run(folder)
    if run is None or run.particles is None:
        raise InputError(f"{folder}: there is no particles.h5 in it: it is no run, or one that has not recorded its particles")
    times = [frame.time for frame in run.frames()]
    if not times:
        raise InputError(f"{folder}: particles.h5 holds no whole snapshot; snapshotInterval of records in couplingDict asks for them")
    time = times[-1] if asked is None else min(times, key=lambda each: abs(each - asked))
    if asked is not None and abs(time - asked) > SAME_TIME * max(asked, time):
        raise InputError(f"{folder}: no whole snapshot at t = {asked:.9g} s; the nearest is at {time:.9g} s: --from {folder}@{time:.9g}")
    weight, method = _recorded(run)
    for frame in run.frames():
        if frame.time == time:
            state = frame.load()
            _check(state, frame.where)
            return StartingRun(folder, frame.where, time, state, weight, method, run.results)
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


def _recorded(run):
    """(weight, method) as results.h5 has them, else run.json."""
    found = {}
    if run.results:
        with open_h5(run.results) as file:
            found = {name: word(value) for name, value in file["meta"].attrs.items()} if "meta" in file else {}
    if "weight" not in found and os.path.isfile(os.path.join(run.path, "run.json")):
        try:
            with open(os.path.join(run.path, "run.json"), encoding="utf-8") as stream:
                found = json.load(stream)
        except ValueError:
            found = {}
    weight = found.get("weight")
    return (None if weight is None else float(weight)), found.get("method")


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
