# SPDX-License-Identifier: GPL-3.0-or-later
"""Short runs of a case that tell what a long one will cost: made in a scratch folder, ended by the processor time that they have taken."""

import contextlib
import io
import os
import time
from dataclasses import dataclass

import numpy

from interphase import cost_model, parts
from interphase.case_folder import CONTROL, COUPLING
from interphase.cost_model import PHASES, Output
from interphase.input_error import InputError
from interphase.run import Run
from interphase.run_state import ENDED, RUNNING, STOPPED

LOOK = 0.3  # s between two looks at a run that goes
DONORS = {"DEM": "TDHS", "CGPM": "CGHS"}  # whose beds springs can start from, made at a fraction of their cost
NEVER = float("inf")


@dataclass(frozen=True)
class Calibration:
    """What a short run of a method has shown: the `run`, `paces` {phase: Pace}, its `Output`, `setup` [CPU s], and `reached` [s], up to where its bed
    had come; `whence`: in words, what was measured."""

    run: Run
    paces: dict
    output: Output
    setup: float
    reached: float
    whence: str

    def cost(self, until):
        """The `Cost` of a run to `until` [s]."""
        return cost_model.cost(self.paces, self.output, until, self.setup)

    def bytes(self, until):
        return self.output.bytes(until, float(self.run.meta["gas_step"]))


def short_run(case, folder, seconds, until, ranks, start=None, snapshot=None):
    """The `Run` of the Case in `folder` until it has taken `seconds` of its processors, but cost_model.FEWEST gas steps at least, or is at `until`
    [s]. `start`: "RUN@TIME" whose bed it takes; `snapshot` [s]: between two, others than the case's. InputError, StepFailed as of Case.run; InputError
    where it does not run."""
    entries = {"records/interval": gas_step(case) / 2, "checkpoint/wallInterval": 0}  # a row for each gas step
    if snapshot:
        entries["records/snapshotInterval"] = snapshot
    with contextlib.redirect_stderr(io.StringIO()) as said:  # that it was stopped is no news
        run = case.set(entries).run(folder, ranks=ranks, until=until, start=start, overwrite=True, wait=False)
        while run.state == RUNNING:
            time.sleep(LOOK)
            steps, spent = progress(run)
            if spent >= seconds and steps >= cost_model.FEWEST:
                with contextlib.suppress(InputError):  # it may have ended meanwhile
                    run.stop()
        run.wait()
    if run.state not in (ENDED, STOPPED):
        raise InputError(f"{case.method}, W = {case.weight:g}: it does not run: {last_words(said.getvalue())}")
    return run


def last_words(said):
    """The last message of a program, on one line."""
    return " ".join(said.strip().splitlines()[-6:]) or "its log says why"


def progress(run):
    """(gas steps so far, processor seconds of them) of a run that goes."""
    try:
        rows = run.processor_time
        spent = [rows[phase].values for phase in PHASES]
    except (InputError, OSError, KeyError):
        return 0, 0.0  # nothing is in the file yet
    count = min(map(len, spent))
    return (count - 1, float(sum(each[count - 1] - each[0] for each in spent))) if count else (0, 0.0)


def gas_step(case):
    """Of the Case, the first one where it is adjusted [s]; InputError where it is no number."""
    written = case.dictionaries.value(CONTROL, "deltaT")
    try:
        step = float(written)
    except (TypeError, ValueError):
        step = 0.0
    if not step > 0:
        raise InputError(f"{case.path}/{CONTROL}: deltaT {written} is no number; give it as one, or by a name of `parameters`")
    return step


def output_of(run, case):
    """The `Output` of the case by its short `run`."""
    rows = run.processor_time["output"]
    each = numpy.diff(rows.values)
    row = float(numpy.median(each))
    files = case.dictionaries
    recorded = interval(files, COUPLING, "records/interval", 0.05)
    fields = interval(files, CONTROL, "writeInterval", NEVER)
    snapshots = interval(files, COUPLING, "records/snapshotInterval", 0.0) or fields
    count = len(run.snapshots)
    return Output(row, max(0.0, float(each[0]) - row), size(run, "results.h5") / max(1, len(rows.time)),
                  size(run, "particles.h5") / max(1, count) + folder_size(os.path.join(run.path, "snapshots")) / max(1, count),
                  field_bytes(run), (recorded, snapshots, fields))  # fmt: skip


def interval(files, file, name, default):
    """A time [s] of the case's files; `default` where it is not there, or no number."""
    try:
        return float(files.value(file, name, default))
    except (TypeError, ValueError):
        return default


def size(run, name):
    path = os.path.join(run.path, name)
    return os.path.getsize(path) if os.path.isfile(path) else 0


def folder_size(path):
    return sum(os.path.getsize(os.path.join(base, file)) for base, _, files in os.walk(path) for file in files)


def field_bytes(run):
    """Of the gas at one time."""
    last = max(((when, name) for name, when in parts.times(run.path).items() if when > 0), default=None)
    return folder_size(os.path.join(run.path, last[1])) if last else 0.0


def paces_of(run, starts_at=0.0):
    """{phase: Pace} of a run, its start-up of the program apart. A run that took another's bed counts from `starts_at` [s] on, without its first
    steps: there lists are built and memories of contacts begin."""
    table = run.processor_time
    skip = 0 if starts_at == 0 else 2
    found = {}
    for phase in PHASES:
        if phase != "output":
            rows = table[phase]
            found[phase] = cost_model.pace(rows.time[skip:], rows.values[skip:], starts_at=starts_at)
    return found


def setup_of(run):
    """Processor seconds before the first step."""
    return float(run.processor_time["setup"].values[0])


def of_its_own(run, case):
    """The `Calibration` by a run from the case's own start."""
    reached = float(run.processor_time["gas"].time[-1])
    return Calibration(run, paces_of(run), output_of(run, case), setup_of(run), reached, f"its first {reached:.3g} s")


def from_bed(early, late_run, donor, time_of_bed):
    """The `Calibration` `early` with what `late_run` shows, which starts from the bed that `donor`, a method, had at `time_of_bed` [s]."""
    late = paces_of(late_run, time_of_bed)
    paces = {phase: cost_model.joined(early.paces[phase], late[phase]) for phase in early.paces}
    spent = float(late_run.processor_time["gas"].time[-1])
    return Calibration(early.run, paces, early.output, early.setup, time_of_bed + spent,
                       f"{early.whence}, and {spent:.3g} s from {donor}'s bed of {time_of_bed:.3g} s")  # fmt: skip
