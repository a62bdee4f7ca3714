# SPDX-License-Identifier: GPL-3.0-or-later
"""Short runs of a case that tell what a long one will cost: made in a scratch folder, ended by the processor time that they have taken."""

import contextlib
import dataclasses
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
# {method: what of its kind scouts}: costs of particles go up alike as a bed loosens; those of springs a little more, whose lists are renewed by the way
# that particles go
SCOUT_OF = {"TDHS": "CGHS", "CGHS": "CGHS", "DEM": "CGPM", "CGPM": "CGPM"}
# Of a scout. The wider parcels are, the less their cost tells of particles' (sscp1: by W = 64 a fifth too little), so no larger than need be: 2 where it
# is affordable to the end of the run, or where parcels of 8 would be too few or too wide.
SCOUT_WEIGHTS = (2.0, 8.0, 27.0, 64.0)
USUAL_SCOUT = 8.0
MOST_PARCELS = 50000
FEWEST_PARCELS = 400  # of a scout: fewer are no bed
WIDEST = 0.25  # of the vessel's smallest extent, of a parcel
OTHER_KIND_ERROR = 0.35  # of what is taken from the other kind of contacts: DEM in water by hard spheres 0.59, TDHS on sscp1-slice by springs 1.37
RISE = 2.0  # of the particles' cost as a bed loosens: 2.1 to 2.7 on sscp1, 1.6 to 2.5 of a suspension that settles
BETWEEN_SNAPSHOTS = 6  # gas steps
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
        return self.output.bytes(until, self.gas_step)

    @property
    def gas_step(self):
        """[s]"""
        return float(self.run.meta["gas_step"])

    @property
    def work(self):
        """Spheres times solid steps, per simulated second, as it began."""
        return float(self.run.meta["particles_at_start"]) / float(self.run.meta["solid_step"])


def short_run(case, folder, seconds, until, ranks):
    """The `Run` of the Case in `folder` until it has taken `seconds` of its processors, but cost_model.FEWEST gas steps at least, or is at `until`
    [s]. InputError, StepFailed as of Case.run; InputError where it does not run."""
    step = gas_step(case)
    entries = {"records/interval": step / 2, "records/snapshotInterval": BETWEEN_SNAPSHOTS * step, "checkpoint/wallInterval": 0}  # a row for each gas step
    with contextlib.redirect_stderr(io.StringIO()) as said:  # that it was stopped is no news
        run = case.set(entries).run(folder, ranks=ranks, until=until, overwrite=True, wait=False)
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
    files = case.dictionaries
    step = files.number(CONTROL, "deltaT", 0.0)
    if not step > 0:
        raise InputError(f"{case.path}/{CONTROL}: deltaT {files.value(CONTROL, 'deltaT')} is no number; give it as one, or by a name of `parameters`")
    return step


def output_of(run, case):
    """The `Output` of the case by its short `run`."""
    rows = run.processor_time["output"]
    each = numpy.diff(rows.values)
    row = float(numpy.median(each))  # most rows have no snapshot
    times = run.snapshots.times
    inside = int(((times > 0) & (times < rows.time[-1])).sum())
    snapshot = float((each[1:] - row).sum()) / inside if inside else float(each[0]) - row  # the first one makes the file, too
    files = case.dictionaries
    recorded = files.number(COUPLING, "records/interval", 0.05)
    fields = files.number(CONTROL, "writeInterval", NEVER)
    snapshots = files.number(COUPLING, "records/snapshotInterval", 0.0) or fields
    count = len(run.snapshots)
    return Output(row, max(0.0, snapshot), size(run, "results.h5") / max(1, len(rows.time)),
                  size(run, "particles.h5") / max(1, count) + folder_size(os.path.join(run.path, "snapshots")) / max(1, count),
                  field_bytes(run), (recorded, snapshots, fields))  # fmt: skip


def size(run, name):
    path = os.path.join(run.path, name)
    return os.path.getsize(path) if os.path.isfile(path) else 0


def folder_size(path):
    return sum(os.path.getsize(os.path.join(base, file)) for base, _, files in os.walk(path) for file in files)


def field_bytes(run):
    """Of the gas at one time."""
    last = max(((when, name) for name, when in parts.times(run.path).items() if when > 0), default=None)
    return folder_size(os.path.join(run.path, last[1])) if last else 0.0


def of_run(run, case):
    """The `Calibration` by a short run. What the first step costs beside the others, as lists are made, counts as set-up."""
    table = {phase: run.processor_time[phase] for phase in (*PHASES, "setup")}
    paces = {phase: cost_model.pace(table[phase].time[1:], table[phase].values[1:]) for phase in PHASES if phase != "output"}
    first = sum(float(table[phase].values[1] - table[phase].values[0]) for phase in paces)
    reached = float(table["gas"].time[-1])
    return Calibration(run, paces, output_of(run, case), float(table["setup"].values[0]) + first, reached, f"its first {reached:.3g} s")


def like(own, other, name):
    """The `Calibration` `own` with the particles' cost beyond what was measured as that of `other`, of which `name` tells: cost_model.shaped. The gas's and the
    coupling's do not depend on the state of the bed: within 5 % over the start-up of sscp1."""
    alike = SCOUT_OF[own.run.meta["method"]] == SCOUT_OF[other.run.meta["method"]]
    work = own.work / other.work if alike and other.work > 0 else 0.0
    solids = cost_model.shaped(own.paces["solids"], other.paces["solids"], work, cost_model.SHAPE_ERROR if alike else OTHER_KIND_ERROR)
    return dataclasses.replace(own, paces={**own.paces, "solids": solids}, reached=other.reached, whence=f"{own.whence}, then as {name} to {other.reached:.3g} s")


def scout_weights(scene, own, seconds, until):
    """The weights that a scout's parcels may have in a PlannedScene, the best first. It may take `seconds` of processors on the way to `until` [s], and goes
    like `own`, the Calibration of a method of its kind: particles cost as many times less as parcels have W^1.5 more (eqs. 25 and 27 of the paper)."""
    def fits(weight):
        parcel = scene.sauter * weight ** (1 / 3)
        return scene.real / weight >= FEWEST_PARCELS and (scene.depth is None or parcel <= WIDEST * scene.depth)

    solids = RISE * own.paces["solids"].last
    others = sum(pace.last for phase, pace in own.paces.items() if phase != "solids") + own.output.row / own.gas_step

    def reach(weight):
        return seconds / ((float(own.run.meta["weight"]) / weight) ** 1.5 * solids + others)

    fit = [each for each in SCOUT_WEIGHTS if fits(each)]
    best = [each for each in fit if each < USUAL_SCOUT and reach(each) >= until]
    best += [each for each in fit if each >= USUAL_SCOUT and scene.real / each <= MOST_PARCELS]
    return list(dict.fromkeys(best + fit[::-1]))
