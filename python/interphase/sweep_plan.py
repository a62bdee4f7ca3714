# SPDX-License-Identifier: GPL-3.0-or-later
"""The runs of a sweep: every combination of the values that are asked for, each with a name of its own."""

import dataclasses
import fnmatch
import hashlib
import itertools
import json
import os
import re
from dataclasses import dataclass, field

from interphase import run_state
from interphase.case import Case
from interphase.case_folder import LEFT_BY_A_RUN
from interphase.input_error import InputError

SEED = "seed"


@dataclass(frozen=True)
class Point:
    """One run: its folder's `name`, the `Case` as it is set, its end `until` [s]; `values` {name: text} of what is swept, the seed
    (a whole number, or None) apart. `start`: "RUN@TIME" whose bed it begins with, None: the case's own."""

    name: str
    case: Case
    until: float
    values: dict = field(hash=False)
    seed: int = None
    start: str = None

    @property
    def identity(self):
        """What is the same in all parts of this run, and in no other one."""
        return identity(self.case.method, self.case.weight, (f"{name}={text}" for name, text in self.case.settings.items()))

    @property
    def key(self):
        """A few digits that stand for the identity."""
        return hashlib.sha256(self.identity.encode()).hexdigest()[:8]

    @property
    def group(self):
        """What runs that differ by their seed alone have in common."""
        return (*self.values.items(), ("method", self.case.method), ("weight", self.case.weight))


def identity(method, weight, settings):
    """Of a run with the `settings` ["NAME=VALUE", ...], a text."""
    return json.dumps([method, float(weight), sorted(settings)])


def listed(text):
    """The values of `1,2,(3 4)`; a comma within brackets or quotes parts none."""
    values, depth, quoted, begin = [], 0, False, 0
    for at, char in enumerate(text + ","):
        if char == '"':
            quoted = not quoted
        elif not quoted and char in "([{":
            depth += 1
        elif not quoted and char in ")]}":
            depth -= 1
        if char == "," and depth == 0 and not quoted:
            values.append(text[begin:at].strip())
            begin = at + 1
    if not values or not all(values) or depth or quoted:
        raise InputError(f"'{text}': give values with commas between them, such as 1,2,3")
    if len(set(values)) < len(values):
        twice = next(value for value in values if values.count(value) > 1)
        raise InputError(f"'{text}': {twice} is there twice; each value is run once, more runs of it are made by --seeds")
    return values


def settings(words):
    """{name: [value, ...]} of `NAME=VALUE,...` words."""
    found = {}
    for word in words:
        name, equals, text = word.partition("=")
        name = name.strip()
        if not equals or not name:
            raise InputError(f"--set {word}: give NAME=VALUE,VALUE,...")
        if name in found:
            raise InputError(f"--set {name}: given twice; put all its values into one list")
        if name in ("method", "weight"):
            raise InputError(f"--set {word}: give --{name} {text}")
        try:
            found[name] = listed(text)
        except InputError as error:
            raise InputError(f"--set {name}: {error}") from None
    return found


def plan(case, sets, methods=None, weights=None, seeds=None, until=None):
    """The `Point`s of the case in the folder `case`: the product of `sets` {name: [text, ...]}, `methods`, `weights` (lists of texts or
    None: the case's) and the seeds 1 ... `seeds` (None: the case's own). `until` [s]: their end (None: the case's). InputError where one of them
    is none that can be run."""
    base = Case(case)
    if seeds is not None:
        _check_seed(base, sets)
    swept = [name for name, values in sets.items() if len(values) > 1]
    points = []
    for method, weight, *values in itertools.product(methods or [None], weights or [None], *sets.values()):
        chosen = dict(zip(sets, values))
        for seed in [None] if seeds is None else range(1, seeds + 1):
            entries = {**chosen, **({} if seed is None else {SEED: str(seed)})}
            entries.update({name: text for name, text in (("method", method), ("weight", weight)) if text is not None})
            try:
                changed = base.set(entries)
            except InputError as error:
                raise InputError(f"{', '.join(f'{name}={text}' for name, text in entries.items())}: {error}") from None
            if until is not None and changed.end_time != base.end_time:
                raise InputError("--until and an end time by --set: give one of them")
            end = changed.end_time if until is None else until
            if end is None:
                raise InputError(f"{base.path}: endTime of system/controlDict is no number; give --until T")
            parts = [f"{name}-{chosen[name]}" for name in swept] + [f"{changed.method}-w{changed.weight:g}"]
            parts += [] if seed is None else [f"seed-{seed}"]
            points.append(Point(folder_name(parts), changed, end, {name: chosen[name] for name in swept}, seed))
    identities = [point.identity for point in points]
    if len(set(identities)) < len(identities):
        raise InputError(f"two of the runs are the same one: {next(each for each in identities if identities.count(each) > 1)}")
    return points


def placed(points, folder):
    """The `points` with the names of the folders below `folder` where their runs are, or will be: one that has fixed values or other lists
    in an earlier call is found again."""
    there = {}
    for name in sorted(os.listdir(folder)) if os.path.isdir(folder) else []:
        record = run_state.record(os.path.join(folder, name)) if os.path.isdir(os.path.join(folder, name)) else {}
        if "method" in record:
            there[identity(record["method"], record["weight"], record.get("settings") or [])] = name
    taken, found = set(there.values()), []
    for point in points:
        name = there.get(point.identity)
        if name is None:
            name = f"{point.name}_{point.key}" if point.name in taken else point.name
            taken.add(name)
        found.append(dataclasses.replace(point, name=name))
    return found


def _check_seed(base, sets):
    """A seed must mean something to the case: else its runs are one run, many times."""
    if SEED in sets:
        raise InputError(f"--seeds and --set {SEED}: give one of them")
    if SEED not in base.parameters:
        raise InputError(
            f"--seeds: {base.path} draws nothing that a seed would change: its `parameters` has no entry `{SEED}`. Where `prepare` writes the bed "
            f"by tools/bed, add `{SEED} 1;` there and hand it over as --seed (cases/sscp1 does); runs of one bed would not be independent"
        )


def folder_name(parts):
    """A name that OpenFOAM bears in a path."""
    return "_".join(re.sub(r"[^A-Za-z0-9.+_-]+", "-", re.sub(r'[()"]', "", part.rpartition(":")[2])) for part in parts)[:180]


def digest(case):
    """What tells whether the files of the case in the folder `case` are the same as in an earlier call; pages, pictures and what runs
    leave apart."""
    found = hashlib.sha256()
    for base, folders, files in os.walk(case):
        folders[:] = sorted(each for each in folders if not any(fnmatch.fnmatch(each, pattern) for pattern in LEFT_BY_A_RUN))
        for file in sorted(files):
            if file.endswith((".md", ".png", ".csv")) or any(fnmatch.fnmatch(file, pattern) for pattern in LEFT_BY_A_RUN):
                continue
            path = os.path.join(base, file)
            found.update(os.path.relpath(path, case).encode() + b"\0")
            try:
                with open(path, "rb") as stream:
                    found.update(hashlib.sha256(stream.read()).digest())
            except OSError as error:
                raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    return found.hexdigest()
