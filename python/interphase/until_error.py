# SPDX-License-Identifier: GPL-3.0-or-later
"""What `tools/run --until-error` asks for, and the watch on results.h5 that ends a run when its means are that certain.

Errors are standard errors, as everywhere else. Looking often would end a run at the moment in which its error happens to come out small:
it is looked at when the run has grown by a tenth only, and no error counts before 20 times the slow motion's memory (time_statistics.py).
"""

import math
import os
import threading
import time
from dataclasses import dataclass

from interphase.durations import told
from interphase.input_error import InputError

SECONDS_BETWEEN_LOOKS = 2
GROWTH = 1.1  # of the simulated time, from look to look


@dataclass(frozen=True)
class Target:
    """The mean of the series `name` is to have a standard error of `amount`: a share of the mean where `unit` is "%", else in `unit` ("": that of
    the series)."""

    name: str
    amount: float
    unit: str

    def __str__(self):
        return f"{self.name} {self.amount:g}" + ("%" if self.unit == "%" else f" {self.unit}" if self.unit else "")


def target(text):
    """The `Target` of "pressure_drop 2%", "bed_height 0.002" or "bed_height 0.002 m"; InputError for anything else."""
    words = text.replace("%", " % ").split()
    try:
        name, amount, *unit = words
        amount = float(amount)
        if len(unit) > 1:
            raise ValueError
    except ValueError:
        raise InputError(f"--until-error '{text}': give a series and its error, such as \"pressure_drop 2%\" or \"bed_height 0.002 m\"") from None
    if not 0 < amount < math.inf:
        raise InputError(f"--until-error '{text}': the error must be above 0")
    return Target(name, amount, unit[0] if unit else "")


@dataclass(frozen=True)
class Standing:
    """How far a run is from one `Target`: `reached`; `words` on it; `needed`: the time [s] to which the run would have to go, about, NaN where that
    is not known."""

    target: Target
    reached: bool
    words: str
    needed: float = math.nan


def standing(wanted, series, settled):
    """The `Standing` of the `Target` by a run.Series of one component; `settled`: the `StartUp` of the run. InputError where the unit is another one."""
    from interphase import time_statistics

    if wanted.unit not in ("", "%", series.unit):
        raise InputError(f"--until-error '{wanted}': {series.name} is in {series.unit}; give the error in it, or in %")
    if settled.end is None:
        return Standing(wanted, False, f"start-up not known to be over: {settled.reason}", settled.needed or math.nan)
    part = series.between(after=settled.end)
    first, last = float(part.time[0]), float(part.time[-1])
    try:
        mean = time_statistics.mean_with_error(part.values)
    except ValueError:
        raise InputError(f"--until-error '{wanted}': {series.name} holds NaN or infinite values, or has components") from None
    value, error = mean.value, mean.error
    known = f"{value:.6g} +- {error:.2g} {series.unit}, from {first:.4g} to {last:.4g} s"
    if mean.drifts:
        return Standing(wanted, False, f"{known}; {mean.reason}: while that goes on no length of the run helps; look at the series, or leave the drift out "
                                       "by a later start (tools/report --from)")  # fmt: skip
    if mean.reason:
        return Standing(wanted, False, f"{known}; error not to be trusted: {mean.reason}", first + (last - first) * mean.longer)
    allowed = wanted.amount / 100 * abs(value) if wanted.unit == "%" else wanted.amount
    if wanted.unit == "%" and abs(value) < 3 * error:
        return Standing(wanted, False, f"{known}: not told from zero, of which there is no share; give the error in {series.unit}")
    return Standing(wanted, error <= allowed, known, first + (last - first) * (error / allowed) ** 2 if allowed else math.nan)


def standings(targets, run):
    """[`Standing`] of the targets by the `Run`, and the time of its last row [s]. InputError where it does not record one of them."""
    from interphase.run_records import find_run
    from interphase.start_up import start_up_of_run

    table = run.series
    some = {wanted.name: table[wanted.name] for wanted in targets}
    settled = start_up_of_run(find_run(run.path), None)
    found = [standing(wanted, some[wanted.name], settled) for wanted in targets]
    return found, max(float(each.time[-1]) for each in some.values())


class Watch:
    """Ends the run in `folder` by calling `stop` once all `targets` are reached. `reached`: whether it did so; `refused`: an InputError, where
    a target does not fit the run, which then is stopped, too."""

    def __init__(self, targets, folder):
        self._targets, self._folder = targets, folder
        self._over = threading.Event()
        self.reached, self.refused = False, None
        self._found = []  # at the look that ended the run: rows written since may judge otherwise
        self._began = time.monotonic()
        self._seen = self._looked = self._from = None

    def start(self, stop):
        """Begin, in a thread of its own."""
        self._stop = stop
        self._thread = threading.Thread(target=self._watch, daemon=True)
        self._thread.start()

    def end(self):
        """The run is over."""
        self._over.set()
        self._thread.join()

    def _watch(self):
        while not self._over.wait(SECONDS_BETWEEN_LOOKS):
            try:
                last = self._last()
            except (InputError, OSError, KeyError, RuntimeError):  # not there yet, or being written
                continue
            if last is None:
                continue
            # A signal before the first steps would find nobody who listens: the rows must have grown under our eyes.
            grows, self._seen = self._seen is not None and last > self._seen, last
            if not grows or (self._looked is not None and last < GROWTH * self._looked):
                continue
            if self._from is None:
                self._from = last, time.monotonic()
            self._looked = last
            try:
                self._found, _ = standings(self._targets, self._run())
            except InputError as refused:
                self.refused = refused
            except (OSError, KeyError, RuntimeError):
                continue
            else:
                self.reached = all(each.reached for each in self._found)
            if self.reached or self.refused:
                self._stop()
                return

    def _run(self):
        from interphase.run import Run
        return Run(self._folder)

    def _last(self):
        if not os.path.isfile(os.path.join(self._folder, "results.h5")):
            return None
        times = self._run().series["time"].values
        return float(times[-1]) if len(times) else None

    def told(self):
        """Lines on how the run stands at its end: what is reached, and what the rest would take."""
        try:
            found, last = (self._found, math.inf) if self.reached else standings(self._targets, self._run())
        except InputError as error:
            return [str(error)]
        except (OSError, KeyError, RuntimeError):
            return ["not judged: the run ended before it recorded a row"]
        pace = None
        if self._from is not None and last > self._from[0]:
            pace = (time.monotonic() - self._from[1]) / (last - self._from[0])
        lines = []
        for each in found:
            lines.append(f"{'reached' if each.reached else 'not reached'}: {each.target}: {each.words}")
            if not each.reached and each.needed > last:
                wall = f", some {told(pace * (each.needed - last))} more at the pace so far" if pace else ""
                lines[-1] += f"; about to t = {each.needed:.3g} s{wall}"
        return lines
