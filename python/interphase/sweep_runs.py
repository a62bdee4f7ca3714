# SPDX-License-Identifier: GPL-3.0-or-later
"""The runs of a sweep made: what is missing of them, some at a time, with what they have reached and how long the rest takes."""

import contextlib
import io
import json
import os
import re
import signal
import time
from collections import deque

from interphase import case_folder, ending, run_state, whole_file
from interphase.input_error import InputError
from interphase.launch import StepFailed
from interphase.run import Run, no_such

NOTES = "sweep.json"
DONE, HOLE, NEW, GO_ON, RUNNING = "there", "failed", "to make", "to go on", "running"
SECONDS_BETWEEN_LINES = 5
SAME_TIME = 1e-9  # relative; ends are numbers that were typed


class Notes:
    """sweep.json: of which case the runs are, and why those failed that did."""

    def __init__(self, folder, case, digest):
        self._path = os.path.join(folder, NOTES)
        self.holes = {}
        try:
            with open(self._path, encoding="utf-8") as stream:
                found = json.load(stream)
            self.holes = dict(found["holes"])
            before, files = found["case"], found["files"]
        except FileNotFoundError:
            before, files = case, digest
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise InputError(f"{self._path}: cannot be read: {error}; give another folder by --out DIR") from None
        if before != case:
            raise InputError(f"{folder} holds a sweep of {before}, not of {case}; give another folder by --out DIR")
        if files != digest:
            raise InputError(f"{folder}: the files of {case} are no longer those that its runs were made of; give another folder by --out DIR, or "
                             "remove this one")  # fmt: skip
        self._what = {"case": case, "files": digest}

    def write(self):
        """sweep.json, whole at any moment."""
        whole_file.write(self._path, json.dumps({**self._what, "holes": self.holes}, indent=1))


class Sweep:
    """The `points` (sweep_plan.Point) run in `folder`, a folder each, `jobs` at a time of `ranks` MPI ranks each.

    `stand` is {name: one of there, failed, to make, to go on, running}. InputError where the folder holds what is in the way.
    """

    def __init__(self, points, folder, notes, ranks=1, jobs=1, retry=False, say=print, quantities=()):
        """`quantities`: names of series that the runs must have."""
        self._wanted = list(quantities or ())  # of which it is not known yet whether the runs have them
        self._refused = None
        self.points, self.folder, self.notes, self.ranks, self.jobs, self.say = points, folder, notes, ranks, jobs, say
        self._running = {}  # name: (Run, fraction done at the start, when that was)
        self._pace = {}  # (method, weight): [wall time of whole runs, s]
        self._asked_to_stop = self._stopped = 0
        self.stand = {point.name: self._found(point, retry) for point in points}
        for point in points:
            took = run_state.record(self.path(point)).get("wall_time")  # of the last part alone, where there were several
            if took and self.stand[point.name] == DONE and not os.path.exists(os.path.join(self.path(point), "log.interphase-2")):
                self._pace.setdefault(pace_of(point), []).append(took)

    def path(self, point):
        """Of a point's folder."""
        return os.path.join(self.folder, point.name)

    def _found(self, point, retry):
        """How a point stands before anything is run."""
        folder = self.path(point)
        if not os.path.isdir(folder) or not os.listdir(folder):
            return HOLE if point.key in self.notes.holes and not retry else NEW
        record = run_state.record(folder)
        if "method" not in record:
            raise InputError(f"{folder} holds files that are no run of tools/run: they stay; give another folder by --out DIR")
        state = Run(folder).state
        if state == run_state.UNKNOWN:
            host = record.get("process", {}).get("host")
            raise InputError(f"{folder}: its run goes, or went, on another machine ({host}); end it there, or remove it")
        if state == run_state.RUNNING:
            return RUNNING
        if state == run_state.ENDED:
            return self._ended(point, folder)
        if point.key in self.notes.holes and not retry:
            return HOLE
        if state == run_state.FAILED and not retry:
            self.notes.holes[point.key] = cause(folder)
            return HOLE
        # An error of the run itself would come again; a full disk or a kill would not.
        return GO_ON if ending.has_checkpoint(folder) and (state != run_state.FAILED or record["exit_code"] in (6, 137)) else NEW

    def _ended(self, point, folder):
        end = case_folder.end_time(case_folder.Dictionaries(folder))
        if end is None or abs(end - point.until) <= SAME_TIME * point.until:
            return DONE
        if end > point.until:
            raise InputError(f"{folder} has a run to t = {end:g} s, longer than the {point.until:g} s of this sweep: give --until {end:g}, "
                             "or another folder by --out DIR")  # fmt: skip
        return GO_ON if ending.has_checkpoint(folder) else NEW

    def count(self, *which):
        """How many points stand as one of `which`."""
        return sum(each in which for each in self.stand.values())

    @contextlib.contextmanager
    def listening(self):
        """For as long as it lasts, SIGINT, SIGTERM and SIGHUP end the runs after the gas step in progress, a second one at once."""
        before = {}
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            if signal.getsignal(number) != signal.SIG_IGN:  # nohup stays nohup
                before[number] = signal.signal(number, self._ask_to_stop)
        try:
            yield
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)

    def _ask_to_stop(self, *_):
        self._asked_to_stop += 1

    def go(self):
        """Make what is missing. Returns whether all has been tried: not so after a signal that it is `listening` to. InputError where the runs
        do not have the `quantities`, as soon as one shows it; those that go are ended."""
        for point in self.points:
            if self.stand[point.name] == DONE:
                self._look_for_quantities(Run(self.path(point)))
        if self._refused:
            raise self._refused
        for point in self.points:
            if self.stand[point.name] == RUNNING:  # of an earlier call, which was killed
                self._began(point, Run(self.path(point)))
        waiting = deque(point for point in self.points if self.stand[point.name] in (NEW, GO_ON))
        points = {point.name: point for point in self.points}
        line_at = time.monotonic()
        while self._running or (waiting and not self._asked_to_stop):
            while waiting and not self._asked_to_stop and len(self._running) < self.jobs:
                self._start(waiting.popleft())
            self._pass_on()
            for name, (run, *_) in list(self._running.items()):
                self._look_for_quantities(run)
                if run.state != run_state.RUNNING:
                    self._end(points[name], run)
            if self._running and time.monotonic() - line_at > SECONDS_BETWEEN_LINES:
                line_at = time.monotonic()
                self.say(self.progress())
            time.sleep(0.1)
        if self._refused:
            raise self._refused
        return not self._asked_to_stop

    def _look_for_quantities(self, run):
        """Whether the runs have what is wanted, once one has recorded anything."""
        if not self._wanted:
            return
        try:
            there = list(run.series)
        except InputError:  # nothing yet, or just being written
            return
        missing = [name for name in self._wanted if there and name not in there]
        if there:
            self._wanted = []
        if missing:
            self._refused = no_such(f"--quantity {missing[0]}: /series of {run.path}", missing[0], there)
            self.say(f"refused  {self._refused}")
            self._ask_to_stop()

    def _pass_on(self):
        while self._stopped < self._asked_to_stop:
            self._stopped += 1
            if self._stopped == 1:
                self.say(f"stopping {len(self._running)} runs after their gas steps in progress; once more ends them at once")
            for run, *_ in self._running.values():
                if "exit_code" not in run.record:  # the rest is to be tidied up only
                    with contextlib.suppress(InputError):
                        run.stop(wait=False)

    def _start(self, point):
        folder, go_on = self.path(point), self.stand[point.name] == GO_ON
        self.notes.holes.pop(point.key, None)
        self.notes.write()
        try:
            if go_on:
                end = case_folder.end_time(case_folder.Dictionaries(folder))
                other = None if end is not None and abs(end - point.until) <= SAME_TIME * point.until else repr(point.until)
                run = Run(folder).resume(until=other, ranks=self.ranks, wait=False)
            else:
                # The case's own end is left as it is written there.
                until = None if point.until == point.case.end_time else point.until
                run = point.case.run(folder, ranks=self.ranks, until=until, start=point.start, overwrite=True, wait=False)
        except (InputError, StepFailed) as error:
            self._hole(point, str(error))
            return
        self._began(point, run)

    def _began(self, point, run):
        self.stand[point.name] = RUNNING
        done = reached(self.path(point)) / point.until if "exit_code" not in run.record else 0.0
        self._running[point.name] = run, min(done, 1.0), time.monotonic()

    def _end(self, point, run):
        _, done, since = self._running.pop(point.name)
        told = io.StringIO()
        try:
            with contextlib.redirect_stderr(told):
                run.wait()
        except (InputError, StepFailed) as error:
            if not self._stopped:
                self._hole(point, str(error))
            else:
                self.stand[point.name] = NEW
                self.say(f"stopped  {point.name}  before its start")
            return
        state = run.state
        if state == run_state.ENDED:
            self.stand[point.name] = DONE
            took = time.monotonic() - since
            if done < 0.9:
                self._pace.setdefault(pace_of(point), []).append(took / (1 - done))
            self.say(f"ended    {point.name}  in {duration(took)}")
        elif state == run_state.FAILED or not self._stopped:
            self._hole(point, cause(run.path) or told.getvalue().strip() or f"its run was {state} from elsewhere")
        else:
            self.stand[point.name] = GO_ON if ending.has_checkpoint(run.path) else NEW
            self.say(f"stopped  {point.name}" + ("" if self.stand[point.name] == GO_ON else "  before its first checkpoint: it will begin anew"))

    def _hole(self, point, why):
        self.stand[point.name] = HOLE
        self.notes.holes[point.key] = why
        self.notes.write()
        self.say(f"failed   {point.name}: {short(why)}")

    def progress(self):
        """One line: how many runs have ended, run, failed, how much of all that is, and how long the rest takes."""
        now, done, left, longest = time.monotonic(), 0.0, 0.0, 0.0
        pace = {kind: list(several) for kind, several in self._pace.items()}
        reach = {}
        for point in self.points:
            if point.name in self._running:
                _, before, since = self._running[point.name]
                reach[point.name] = at = min(reached(self.path(point)) / point.until, 1.0)
                if at - before > 0.01:
                    pace.setdefault(pace_of(point), []).append((now - since) / (at - before))
        known = [each for several in pace.values() for each in several]
        for point in self.points:
            stand = self.stand[point.name]
            part = 1.0 if stand in (DONE, HOLE) else reach.get(point.name, 0.0)
            if stand == GO_ON:
                part = min(reached(self.path(point)) / point.until, 1.0)
            done += part
            if known:
                several = pace.get(pace_of(point), known)
                rest = (1 - part) * sum(several) / len(several)
                left, longest = left + rest, max(longest, rest)
        eta = duration(max(left / self.jobs, longest)) if known else "?"
        failed = f", {self.count(HOLE)} failed" if self.count(HOLE) else ""
        return (f"{self.count(DONE)} of {len(self.points)} runs ended, {len(self._running)} running{failed}   "
                f"{100 * done / len(self.points):3.0f} %  ETA {eta}")


def pace_of(point):
    """What runs that take about as long per simulated second have in common."""
    return point.case.method, point.case.weight


def logs(folder):
    """The paths of the logs of a run's parts, the last one first."""
    names = [name for name in os.listdir(folder) if re.fullmatch(r"log\.interphase(-\d+)?", name)] if os.path.isdir(folder) else []
    return [os.path.join(folder, name) for name in sorted(names, key=lambda name: int(name.rpartition("-")[2]) if "-" in name else 1, reverse=True)]


def reached(folder):
    """The simulated time that a run has told last, s; 0 where it has not."""
    for log in logs(folder):
        with open(log, "rb") as stream:
            stream.seek(0, os.SEEK_END)
            stream.seek(max(0, stream.tell() - 20000))
            times = re.findall(r"^t = ([\d.e+-]+) +s ", stream.read().decode("utf-8", "replace"), re.M)
        if times:
            return float(times[-1])
    return 0.0


def cause(folder):
    """What a run in `folder` told of its failure, or nothing."""
    log = next(iter(logs(folder)), None)
    words = "\n".join(ending.cause(log)) if log else ""
    code = run_state.record(folder).get("exit_code")
    return words or (f"interphase stopped {ending.kind(code)}; see {log}" if code else "")


def short(words, most=300):
    """`words` on one line, not longer than `most`."""
    line = " ".join(words.split())
    return line if len(line) <= most else line[: most - 4] + " ..."


def duration(seconds):
    """0:39, 12:05, 3:02:10."""
    whole = round(seconds)
    hours, minutes = divmod(whole // 60, 60)
    return f"{hours}:{minutes:02}:{whole % 60:02}" if hours else f"{minutes}:{whole % 60:02}"
