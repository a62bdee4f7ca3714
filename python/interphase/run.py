# SPDX-License-Identifier: GPL-3.0-or-later
"""A run in its folder: how it stands, what it has recorded, and how it is ended and gone on with."""

import os
import signal
import time

from interphase import run_state
from interphase.foam_file import nearest
from interphase.input_error import InputError
from interphase.launched import Launched
from interphase.missing import module
from interphase.tree import CASES


class Run:
    """The run in the folder `path`, also one that still goes; InputError where there is none."""

    def __init__(self, path, launched=None):
        """`launched`: the `Launched` that makes it, where this program does."""
        self.path = os.path.abspath(os.fspath(path))
        self._launched = launched
        run_state.checked_folder(path)
        if not any(os.path.exists(self._file(name)) for name in (run_state.MARK, "results.h5", "particles.h5")):
            raise InputError(f"{path}: there is none of run.json, results.h5, particles.h5 in it: it is no run")

    def _file(self, *names):
        return os.path.join(self.path, *names)

    @property
    def record(self):
        """What run.json says: case, method, weight, ranks, settings, command, exit_code, wall_time [s]; {} without one."""
        return run_state.record(self.path)

    @property
    def state(self):
        """One of running, ended, stopped, failed, broken off, unknown; run_state.state_of says which is what."""
        found = run_state.state_of(self.record)
        if found == run_state.UNKNOWN and "wall_time" in self.meta:
            return run_state.ENDED  # the program's own word, where it was started without tools/run
        return found

    @property
    def ok(self):
        """Whether the run has reached its end, without an error."""
        return self.state == run_state.ENDED

    @property
    def meta(self):
        """{name: number or text} of /meta of results.h5: version, commit, solid_step [s], real_particles, ...; {} before it is there."""
        stored = module("stored")
        return stored.attributes(self._file("results.h5"), "meta")

    @property
    def timing(self):
        """{phase: wall time [s], the slowest rank's} of solids, gas, mapping, exchange, output, waiting, setup; {} before the end."""
        stored = module("stored")
        return stored.attributes(self._file("results.h5"), "timing")

    @property
    def processor_time(self):
        """{phase: Series} of /processor_time: the seconds that the processors of all ranks have spent on it so far, a row with each of /series."""
        series = module("series")
        return series.Table(self._file("results.h5"), "processor_time")

    @property
    def series(self):
        """{name: Series} of /series of results.h5 as far as they are written: pressure_drop, bed_height, kinetic_energy, ..."""
        series = module("series")
        return series.Table(self._file("results.h5"), "series")

    @property
    def samples(self):
        """{name: Series} of /statistics of results.h5, the rows that the run takes at `statistics.interval`: windows, overlaps, voidage,
        surface, bubbles, energy; values [n] or [n, k]."""
        series = module("series")
        return series.Table(self._file("results.h5"), "statistics")

    @property
    def taps(self):
        """{name: Series} of /taps of results.h5: `pressure` [n, taps] at each of records.pressureTaps, at `statistics.tapInterval`."""
        series = module("series")
        return series.Table(self._file("results.h5"), "taps")

    @property
    def ledger(self):
        """{name: Series} of /ledger of results.h5: what was counted, and the residuals of the balances, in each gas step."""
        series = module("series")
        return series.Table(self._file("results.h5"), "ledger")

    @property
    def counters(self):
        """{name: Series} of /counters of results.h5: what fixes of plug-ins count, so far, a row with each of /series."""
        series = module("series")
        return series.Table(self._file("results.h5"), "counters")

    @property
    def snapshots(self):
        """The particle snapshots that are whole, in order of time: a sequence of `Snapshot`, read when asked for."""
        snapshots = module("snapshots")
        return snapshots.Snapshots(self._file("particles.h5"))

    def fields(self, name, time=None):
        """The gas field `name` (voidage, U, p_rgh, ...) in all cells at `time` [s] (default: the last that was written), a
        `GasField`: values [n] or [n, components], unit. InputError where it is not there, or still in pieces of the ranks."""
        gas_fields = module("gas_fields")
        return gas_fields.read(self.path, name, time)

    @property
    def field_times(self):
        """[n] times at which the gas was written, s, ascending."""
        gas_fields = module("gas_fields")
        return sorted(gas_fields.times(self.path).values())

    @property
    def statistics(self):
        """{path: Stored} of the numbers of `tools/report`, such as "profiles/means/pressure_drop": values, unit, and what else it says of
        them. Those that it has put into results.h5; where it has not been called, or the run has gone on since, the same, which takes as long
        as a call of it, and the file stays as it is. InputError where there is nothing to report."""
        return module("reporting").statistics_of(self.path)

    def wait(self):
        """Returns when the run is no longer running; errors as of Case.run."""
        if self._launched is not None:
            self._launched.wait()
            self._launched = None
        while self.state == run_state.RUNNING:
            time.sleep(0.1)
        return self

    def stop(self, wait=True):
        """End the run after the gas step in progress, with gas, checkpoint and records; `resume` goes on from there. InputError where no
        process of this machine runs it."""
        process = run_state.process_of(self.record)
        if process is None:
            raise InputError(f"{self.path}: the run is not running here ({self.state}): there is nothing to stop")
        self._launched.stop() if self._launched is not None else os.kill(process, signal.SIGTERM)
        return self.wait() if wait else self

    def resume(self, until=None, ranks=None, wall_limit=None, picture=False, quiet=True, wait=True, until_error=()):
        """Go on from the newest whole checkpoint, to `until` [s] where it is given, on as many ranks or on `ranks`; the rest is as of
        Case.run. InputError where the run still goes, or has no checkpoint."""
        if self.state == run_state.RUNNING:
            raise InputError(f"{self.path}: the run still goes; stop() or wait() come first")
        words = [self._source(), "--resume", *["--no-picture"] * (not picture)]
        for name, value in (("--until", until), ("--ranks", ranks), ("--wall-limit", wall_limit)):
            words += [] if value is None else [name, str(value)]
        words += until_error_words(until_error)
        self._launched = Launched(words, self.path, quiet)
        if wait:
            return self.wait()
        self._launched.accepted()
        return self

    def _source(self):
        """The folder of the case that this is a run of."""
        found = self.record
        if "case" not in found:
            raise InputError(f"{self.path}: run.json does not say of which case it is a run: tools/run did not make it; the program goes "
                             "on with it by `interphase -case FOLDER -resume`")  # fmt: skip
        places = [place for place in (found.get("source"), os.path.join(CASES, found["case"])) if place]
        there = [place for place in places if os.path.isdir(place)]
        if not there:
            raise InputError(f"{self.path}: its case is no longer at {places[0]}; put it back to go on")
        return there[0]

    def __repr__(self):
        return f"<Run {self.path}: {self.state}>"


def until_error_words(until_error):
    """Words of tools/run for `until_error`, one "pressure_drop 2%" or several."""
    return [word for each in ([until_error] if isinstance(until_error, str) else until_error) for word in ("--until-error", each)]


NO_PRESSURE_DROP = ("no pressure drop was recorded: the case has no pressure taps, or no gas; `records { pressureTaps ((x y z) (x y z)); }` in "
                    "system/couplingDict asks for it")  # fmt: skip


def no_such(what, name, names):
    """The InputError for a `name` that is not among `names`."""
    if name == "pressure_drop" and names:
        return InputError(f"{what}: {NO_PRESSURE_DROP}")
    return InputError(f"{what} has no '{name}': {nearest(name, names)}")
