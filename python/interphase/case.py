# SPDX-License-Identifier: GPL-3.0-or-later
"""A case, with the changes that a script makes to it, and how it is run."""

import copy
import os

from interphase import case_folder, methods, parameters
from interphase.case_folder import COUPLING, PARAMETERS
from interphase.input_error import InputError
from interphase.launched import Launched
from interphase.run import Run, until_error_words
from interphase.run_folder import default_folder
from interphase.tree import CASES


class Case:
    """The case in the folder `path`, such as "cases/sscp1"; InputError where it is none. Its files are never changed."""

    def __init__(self, path):
        self.path = case_folder.checked_case(os.fspath(path), CASES)
        self._dictionaries = case_folder.Dictionaries(self.path)
        self._settings = {}
        self._method = self._weight = None

    def set(self, entries=None, **of_parameters):
        """Another Case, with entries changed; this one stays as it is.

        Keywords are entries of the case's `parameters`, in its units, and `method` and `weight`; `entries` also those of the coupling and of
        other files, {"mapping/width": 0.01, "system/fvSolution:PIMPLE/nCorrectors": 3}. Values are numbers, words, truth values, or lists of
        them. An entry of the coupling that the case does not mention is added; InputError with the nearest name for any other.
        """
        changed = copy.copy(self)
        changed._dictionaries, changed._settings = case_folder.Dictionaries(self.path), {}
        changed._dictionaries.take(self._dictionaries)
        changed._settings.update(self._settings)
        for name, value in {**(entries or {}), **of_parameters}.items():
            text = as_written(value)
            if name == "method":
                changed._method = text
            elif name == "weight":
                case_folder.checked_weight(text)
                changed._weight = text
            else:
                changed._dictionaries.set(*changed._dictionaries.place_of(name), text)
                changed._settings[name] = text
        if changed._method or changed._weight:
            method, _ = case_folder.set_method_and_weight(changed._dictionaries, changed._method, changed._weight)
            changed._method = changed._method and method
        return changed

    def value(self, name, default=None):
        """The text of the entry that `set` knows by this name, as changed; `default` where there is none."""
        file, path = self._dictionaries.place_of(name)
        return self._dictionaries.value(file, path, default) if self._dictionaries.has(file) else default

    @property
    def method(self):
        """The name of the collision method: DEM, CGPM, TDHS, CGHS, MPPIC, one of a plug-in of one's own, or PLUGIN."""
        return self.method_of(None).name

    def method_of(self, name):
        """The `methods.Method` of that name, or the case's own; InputError for one that there is not."""
        return case_folder.method_of(self._dictionaries, name)

    def methods(self):
        """{name: `methods.Method`} of all that there are for it: of this tree, and of its own plug-ins."""
        return methods.all_with(case_folder.plugins_of(self._dictionaries), self.path)

    @property
    def weight(self):
        """Real particles per tracked one."""
        return case_folder.checked_weight(self._dictionaries.value(COUPLING, "weight", "1"))

    @property
    def settings(self):
        """{name: text} of the entries that `set` has changed, `method` and `weight` apart."""
        return dict(self._settings)

    @property
    def dictionaries(self):
        """The `Dictionaries` of the case's files, as changed: a copy."""
        found = case_folder.Dictionaries(self.path)
        found.take(self._dictionaries)
        return found

    @property
    def end_time(self):
        """The simulated time that a run ends at where it is not told otherwise, s; None where the case does not say it as a number."""
        return case_folder.end_time(self._dictionaries)

    @property
    def parameters(self):
        """{name: number, word or tuple} of the case's `parameters`, as changed."""
        if not self._dictionaries.has(PARAMETERS):
            return {}
        values = parameters.values_of(self._dictionaries.text(PARAMETERS))
        return {name: parameters.numbers(value) if isinstance(value, str) else value for name, value in values.items()}

    def run(self, out=None, ranks=1, until=None, start=None, wall_limit=None, overwrite=False, picture=False, quiet=True, wait=True,
            until_error=()):
        """The `Run` of this case in the folder `out` (default: that of tools/run), on `ranks` MPI ranks to the simulated time `until` [s]
        (default: the case's).

        `start`: "RUN@TIME", whose bed and gas it begins with; `wall_limit` [s] of wall time; `until_error`: "pressure_drop 2%", or several, at
        which standard errors of means it ends before; `picture`: draw bed.png; `quiet`: the
        program's output goes into its log only. With `wait` false it returns once the run has begun: run.state, run.wait(), run.stop().
        A run that does not reach its end is returned, too, with the reason on standard error: see run.ok. InputError where the case is
        refused, or `out` holds an earlier run and not `overwrite`; StepFailed where a step before the program fails (build, mesh, prepare).
        """
        if int(ranks) != ranks or ranks < 1:
            raise InputError(f"ranks = {ranks!r}: give a whole number from 1 on")
        folder = os.path.abspath(out or default_folder(self.path, self.method, self.weight, ranks))
        words = [self.path, "--ranks", str(int(ranks))]
        for name, text in (("--method", self._method), ("--weight", self._weight), ("--until", until), ("--from", start),
                           ("--wall-limit", wall_limit)):  # fmt: skip
            words += [] if text is None else [name, as_written(text)]
        for name, text in self._settings.items():
            words += ["--set", f"{name}={text}"]
        words += until_error_words(until_error)
        words += ["--overwrite"] * bool(overwrite) + ["--no-picture"] * (not picture)
        launched = Launched(words, folder, quiet)
        launched.wait() if wait else launched.accepted()
        return Run(folder, launched)

    def __repr__(self):
        return f"Case({self.path!r})" + (f".set({', '.join(self._settings)})" if self._settings else "")


def as_written(value):
    """A value as OpenFOAM's files have it: 2.19, yes, (15 1 45); all digits of a number."""
    if isinstance(value, str):
        return value.strip()
    if hasattr(value, "tolist"):  # of numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (list, tuple)):
        return "(" + " ".join(map(as_written, value)) + ")"
    return repr(value)
