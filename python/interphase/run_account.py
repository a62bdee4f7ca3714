# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run was and what it cost: command, version, machine, and seconds of a core per simulated second, by phase."""

import dataclasses
import datetime
import math
import os
import re
import shlex
from dataclasses import dataclass, field
from typing import Optional

import numpy

from interphase import run_state, stored
from interphase.time_statistics import error_by_scatter, mean_with_error
from interphase.tree import REPOSITORY
from interphase.whole_records import whole_rows

PHASES = ("solids", "gas", "mapping", "exchange", "output", "waiting", "setup")
# Of the paper's three: what the program times of its coupling; the rest is neither's.
COUPLING = ("mapping", "exchange")
CPU, WALL = "CPU time", "wall time"
FEWEST_LINES = 20  # of the log's progress, of which the scatter of the pace is told


@dataclass(frozen=True)
class Cost:
    """Seconds per simulated second: `value`, and its standard `error` by how the pace changed during the run (NaN: not known). `kind`:
    CPU, of all ranks, or WALL times ranks. `phases` {name: part of `value`}, {} before the run's end."""

    value: float
    error: float
    kind: str
    phases: dict = field(default_factory=dict)

    @property
    def split(self):
        """{solids, gas, coupling, other: part of the value}; {} where phases are not known."""
        if not self.phases:
            return {}
        coupling = sum(self.phases.get(name, 0.0) for name in COUPLING)
        named = {"solids": self.phases.get("solids", 0.0), "gas": self.phases.get("gas", 0.0), "coupling": coupling}
        return {**named, "other": max(self.value - sum(named.values()), 0.0)}


@dataclass(frozen=True)
class Account:
    """Of one run. What it did not record is "" or NaN; `cost` None where nothing tells it."""

    folder: str
    case: str
    method: str
    weight: float
    command: str
    commit: str
    versions: str
    machine: str
    date: str
    ranks: int
    particles: float
    gas_step: float
    solid_step: float
    simulated: float
    wall: float
    cpu: float
    settings: tuple = ()
    start: str = ""
    state: str = ""
    cost: Optional[Cost] = None
    diameter: float = math.nan


def of_run(run):
    """The `Account` of `Records`."""
    meta, record = run.meta, run.record
    ranks = int(float(run.recorded("ranks") or 1))
    simulated = float(meta.get("simulated_time", run.last_time()))
    wall = float(meta.get("wall_time", record.get("wall_time", math.nan)))
    cpu = float(record.get("cpu_time") or math.nan)
    number = lambda name: float(meta.get(name, math.nan))  # noqa: E731
    process = record.get("process", {})
    start = record.get("from") or {}
    return Account(
        folder=_shown(run.path), case=str(record.get("case", meta.get("case", ""))), method=str(run.recorded("method") or ""),
        weight=float(run.recorded("weight") or math.nan), command=command_of(run), commit=str(meta.get("commit", "")) + (
            ", with uncommitted changes" if meta.get("uncommitted_changes") == "yes" else ""),
        versions=str(meta.get("versions", meta.get("version", ""))), machine=process.get("machine", ""), date=_date(run, process),
        ranks=ranks, particles=number("particles"), gas_step=number("gas_step"), solid_step=number("solid_step"), simulated=simulated,
        wall=wall, cpu=cpu, settings=tuple(record.get("settings") or ()),
        start=f"{start['method'] or 'a run'} at {start['time']:.6g} s" if start else "", state=run_state.state_of(record) if record else "",
        cost=cost_of(run, simulated, wall, cpu, ranks),
    )  # fmt: skip


def of_replicates(accounts):
    """The `Account` of runs that differ in where they begin, as of one: what they simulated and took is summed up, the cost is the mean over all of it."""
    if len(accounts) == 1:
        return accounts[0]

    def words(name):
        return "; ".join(dict.fromkeys(filter(None, (getattr(each, name) for each in accounts))))

    several = {name: words(name) for name in ("folder", "command", "commit", "versions", "machine", "date", "start", "state")}
    summed = {name: math.fsum(getattr(each, name) for each in accounts) for name in ("simulated", "wall", "cpu")}
    return dataclasses.replace(accounts[0], **several, **summed, cost=_mean_cost(accounts), settings=tuple(
        each for each in accounts[0].settings if all(each in other.settings for other in accounts)))  # fmt: skip


def _mean_cost(accounts):
    """The `Cost` over all that `Account`s simulated; its error is the larger one of what theirs make and of what they scatter. None where one has none."""
    costs, share = [each.cost for each in accounts], numpy.array([each.simulated for each in accounts])
    if not all(costs) or len({cost.kind for cost in costs}) > 1 or not share.sum() > 0:
        return None
    share = share / share.sum()
    values, errors = (numpy.array([getattr(cost, name) for cost in costs]) for name in ("value", "error"))
    value = float(share @ values)
    phases = {name: float(share @ [cost.phases[name] for cost in costs]) for name in costs[0].phases if all(name in cost.phases for cost in costs)}
    return Cost(value, float(numpy.fmax(math.sqrt(float(share**2 @ errors**2)), error_by_scatter(values, share))), costs[0].kind, phases)


def _shown(path):
    """A path as one types it in the project's folder; of one elsewhere its last name: what is stored tells nothing of a machine."""
    path = os.path.abspath(path)
    return os.path.relpath(path, REPOSITORY) if path.startswith(REPOSITORY + os.sep) else os.path.basename(path)


def _date(run, process):
    """When the run began, else when it wrote last."""
    if process.get("date"):
        return process["date"]
    file = run.results or run.particles
    return datetime.datetime.fromtimestamp(os.path.getmtime(file)).strftime("%Y-%m-%d") if file else ""


def command_of(run, until=None):
    """The call of tools/run that makes this run (`Run` or `Records`) again, as far as run.json tells it, to `until` [s] (None: as it was called)."""
    record = run.record
    if "case" not in record:
        return f"interphase -case {_shown(run.path)}"
    source = record.get("source") or record["case"]
    inside = re.search(r"(?:^|/)(cases/[^/]+)/?$", source)
    words = ["tools/run", inside[1] if inside else _shown(source), "--method", record["method"], "--weight", f"{record['weight']:g}"]
    words += ["--ranks", str(record["ranks"])] if record.get("ranks", 1) != 1 else []
    for setting in record.get("settings") or ():
        words += ["--set", setting]
    until = record.get("until") if until is None else f"{until:g}"
    words += ["--until", str(until)] if until else []
    start = record.get("from")
    words += ["--from", f"{_shown(start['run'])}@{start['time']:.9g}"] if start else []
    return shlex.join(words)


def cost_of(run, simulated, wall, cpu, ranks):
    """The `Cost` of `Records`; None where neither /processor_time nor /meta nor the log tells a time."""
    if (by_rows := _of_rows(run)) is not None:
        return by_rows
    so_far, paces = _paces(run)
    if math.isnan(wall) and math.isnan(cpu):
        if not len(paces):
            return None
        value, kind = ranks * so_far, WALL  # of the part that is done
    else:
        kind = CPU if not math.isnan(cpu) else WALL
        value = (cpu if kind == CPU else wall * ranks) / simulated if simulated > 0 else math.nan
    mean = mean_with_error(paces) if len(paces) >= FEWEST_LINES else None
    error = math.nan if mean is None or not mean.value else value * mean.error / mean.value
    timing = stored.attributes(run.results, "timing") if run.results else {}
    known = {name: float(timing[name]) for name in PHASES if name in timing}
    total = sum(known.values())
    # /timing is in wall time, the slowest rank's: its shares are those of the cost
    phases = {name: value * part / total for name, part in known.items()} if total > 0 else {}
    return Cost(value, error, kind, phases)


def _of_rows(run):
    """The `Cost` by the rows of /processor_time: how it changes from row to row tells its error. None where there are none."""
    if run.results is None:
        return None
    with stored.open_h5(run.results) as file:
        if "processor_time" not in file or (count := whole_rows(file["processor_time"])) < 2:
            return None
        spent = {name: data[:count] for name, data in file["processor_time"].items()}
    time = spent.pop("time")
    spent.pop("setup", None)  # once a run, and not for each simulated second
    simulated = float(time[-1] - time[0])
    phases = {name: float(seconds[-1] - seconds[0]) / simulated for name, seconds in spent.items()}
    paces = numpy.diff(sum(spent.values())) / numpy.diff(time)
    error = mean_with_error(paces).error if len(paces) >= FEWEST_LINES else math.nan
    return Cost(sum(phases.values()), error, CPU, phases)


LINES_OF_PROGRESS = re.compile(rb"^t = ([\d.e+-]+) +s +\d+ % +([\d.e+-]+) s/s", re.M)


def _paces(run):
    """(wall seconds per simulated second up to the last progress line of the log, [n] between the lines, which come at even wall times)."""
    log = os.path.join(run.path, "log.interphase")
    if not os.path.isfile(log):
        return math.nan, []
    with open(log, "rb") as stream:
        lines = [(float(time), float(rate)) for time, rate in LINES_OF_PROGRESS.findall(stream.read())]
    lines = [line for line in lines if line[1] > 0]
    if len(lines) < 2:
        return math.nan, []
    interval = lines[-1][0] / lines[-1][1] / len(lines)  # the first line comes one interval after the start
    return 1 / lines[-1][1], [interval / (later - earlier) for (earlier, _), (later, _) in zip(lines, lines[1:]) if later > earlier]
