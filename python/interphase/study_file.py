# SPDX-License-Identifier: GPL-3.0-or-later
"""The file of a study: a case, what is varied in rows, each a product of lists, and what the runs are held against."""

import dataclasses
import os
from dataclasses import dataclass, field
from typing import Optional

from interphase import foam_file, sweep_plan
from interphase.case_folder import Dictionaries, checked_case, method_of
from interphase.expanded_file import File
from interphase.input_error import InputError
from interphase.tree import CASES

# {key of a row: the entry that it varies, by the name that --set has for it}
SHORT = {"velocities": "inletVelocity", "solidSteps": "particles/stepsPerCollision", "gasSteps": "system/controlDict:deltaT",
         "dragLaws": "drag/law", "mappingWidths": "mapping/width"}  # fmt: skip
ROW = {
    "methods": ("", "list of collision methods", "the case's"),
    "weights": ("", "list of real particles per parcel; those that track every particle take 1", "the case's"),
    "velocities": ("m/s", "list, of `inletVelocity` of the case's parameters", "the case's"),
    "solidSteps": ("", "list, of particles/stepsPerCollision", "the case's"),
    "gasSteps": ("s", "list, of deltaT in system/controlDict", "the case's"),
    "dragLaws": ("", "list, of drag/law", "the case's"),
    "mappingWidths": ("m", "list, of mapping/width", "the case's"),
    "seeds": ("", "runs of each combination, with seed 1 ... N", "one, with the case's seed"),
    "set": ("", "block: any entry that --set of tools/run takes, with a value or a list", "nothing"),
    "until": ("s", "end of the runs", "the case's"),
    "from": ("s", "what is before is not measured", "of `statistics` in system/couplingDict, else found"),
    "startTimes": ("s", "list: a run from the developed bed at each of these times", "the `time` of developed"),
}
KEYS = {
    "": {
        "case": ("", "folder, from that of this file on, or cases/NAME", "none: it is needed"),
        "reference": ("", "name of the run that the others are held against", "the first one of DEM, of TDHS, or of all"),
        "quantities": ("", "list: what the overall distance is made of", "all that are measured"),
        "developed": ("", "block: runs of one W start from one bed", "each starts as the case does"),
        "rows": ("", "block of rows {...}; each has the keys below and is a product of its lists", "one row, of the keys of the file"),
        **ROW,
    },
    "developed": {
        "time": ("s", "when the bed is developed", "none: it is needed"),
        "method": ("", "that makes the bed of W = 1", "TDHS"),
        "methodOfParcels": ("", "that makes the beds of parcels", "CGHS"),
    },
}


@dataclass(frozen=True)
class Row:
    """One of the study: `name`; lists of texts, None where the case decides; `until`, `start` [s] or None."""

    name: str
    methods: Optional[list] = None
    weights: Optional[list] = None
    sets: dict = field(default_factory=dict)
    seeds: Optional[int] = None
    until: Optional[float] = None
    start: Optional[float] = None
    times: tuple = ()


@dataclass(frozen=True)
class Developed:
    """`time` [s] of the bed that runs of one W start from, and who makes it."""

    time: float
    method: str = "TDHS"
    of_parcels: str = "CGHS"


@dataclass(frozen=True)
class Study:
    path: str
    case: str
    rows: list
    reference: Optional[str]
    quantities: Optional[list]
    developed: Optional[Developed]


def described():
    """Lines of the help: every key with its unit, meaning and default."""
    lines = []
    for key, (unit, what, default) in {**KEYS[""], **{f"developed/{key}": each for key, each in KEYS["developed"].items()}}.items():
        lines += [f"  {key + (f' [{unit}]' if unit else ''):<22} {what}", f"{'':<24} default: {default}"]
    return lines


def read(path):
    """The `Study` at `path`; InputError with file, line and the nearest name for what is wrong in it."""
    if not os.path.isfile(path):
        raise InputError(f"{path}: no such file; give the file of a study, such as cases/sscp1-slice/study/study")
    file = File(path)
    _refuse_unknown(file)
    if file.words("case") is None:
        raise InputError(f"{path}: no entry case: add one")
    case = _case(file)
    of_case = Dictionaries(case)
    blocks = file.entry("rows")
    names = [entry.key for entry in blocks.entries] if blocks is not None else []
    of_file = _row(file, of_case, "", "", Row("study"))
    rows = [_row(file, of_case, f"rows/{name}/", name, dataclasses.replace(of_file, name=name)) for name in names] or [of_file]
    developed = None
    if file.entry("developed") is not None:
        makers = [method_of(of_case, _word(file, f"developed/{key}", default)) for key, default in (("method", "TDHS"), ("methodOfParcels", "CGHS"))]
        developed = Developed(file.number("developed/time"), *(each.name for each in makers))
        if developed.time <= 0:
            raise file.complaint("developed/time", f"= {developed.time:g}: a time above 0 is expected [s]")
        if [each.of_particles for each in makers] != [True, False]:
            raise file.complaint("developed", "takes a method that tracks every particle (DEM, TDHS), and one of parcels for methodOfParcels")
    for row in rows:
        if row.times and (developed is None or max(row.times) > developed.time):
            raise file.complaint("rows", f"of {row.name}: startTimes {row.times} need a block `developed {{ time T; }}` with T at least {max(row.times):g}")
    return Study(path, case, rows, _word(file, "reference", None), _list(file, "quantities"), developed)


def _refuse_unknown(file):
    for entry in file.root.entries:
        if entry.key not in KEYS[""] and entry.key != "FoamFile":
            raise file.complaint(entry.key, f"is unknown: {foam_file.nearest(entry.key, KEYS[''])}")
    for block in ("developed", "rows", "set"):
        if file.entry(block) is not None and not isinstance(file.entry(block), foam_file.Dictionary):
            raise file.complaint(block, "must be a block { ... }")
    for name in file.entry("developed").names() if file.entry("developed") is not None else ():
        if name not in KEYS["developed"]:
            raise file.complaint(f"developed/{name}", f"is unknown: {foam_file.nearest(name, KEYS['developed'])}")
    for row in file.entry("rows").entries if file.entry("rows") is not None else ():
        if not isinstance(row, foam_file.Dictionary):
            raise file.complaint(f"rows/{row.key}", "must be a block { ... }")
        for name in row.names():
            if name not in ROW:
                raise file.complaint(f"rows/{row.key}/{name}", f"is unknown: {foam_file.nearest(name, ROW)}")


def _case(file):
    word = foam_file.unquoted(file.words("case")[0])
    beside = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(file.path)), word))
    try:
        return checked_case(beside if os.path.isdir(beside) else os.path.join(os.path.dirname(CASES), word), CASES)
    except InputError as error:
        raise file.complaint("case", f"= {word}: {error}") from None


def _row(file, case, above, name, default):
    sets = dict(default.sets)
    for key, entry in SHORT.items():
        if (values := _list(file, above + key)) is not None:
            sets[entry] = values
    block = file.entry(above + "set")
    for entry in block.entries if block is not None else ():
        if isinstance(entry, foam_file.Dictionary):
            raise file.complaint(above + "set", f"holds a block {entry.key}: name entries by their path, such as mapping/width (0.01 0.02);")
        sets[foam_file.unquoted(entry.key)] = _texts(entry.value)
    methods = _list(file, above + "methods")
    seeds = file.whole(above + "seeds") if file.entry(above + "seeds") is not None else default.seeds
    times = {key: (file.number(above + key) if file.entry(above + key) is not None else before) for key, before in (
        ("until", default.until), ("from", default.start))}
    starts = file.ascending(above + "startTimes", default.times) if file.entry(above + "startTimes") is not None else default.times
    try:
        methods = default.methods if methods is None else [method_of(case, each).name for each in methods]
    except InputError as error:
        raise file.complaint(above + "methods", f": {error}") from None
    weights = _list(file, above + "weights")
    if times["until"] is not None and times["from"] is not None and times["from"] >= times["until"]:
        raise file.complaint(above + "until", f"= {times['until']:g} s is not after from = {times['from']:g} s: nothing is left to measure")
    return Row(name or default.name, methods, default.weights if weights is None else weights, sets, seeds, times["until"], times["from"], starts)


def _word(file, name, default):
    words = file.words(name)
    if words is None:
        return default
    if len(words) != 1:
        raise file.complaint(name, f"= {' '.join(words)}: one word is expected")
    return foam_file.unquoted(words[0])


def _list(file, name):
    entry = file.entry(name)
    if entry is None:
        return None
    if isinstance(entry, foam_file.Dictionary):
        raise file.complaint(name, "must be a value or a list, not a block")
    try:
        return _texts(entry.value)
    except InputError as error:
        raise file.complaint(name, f"= {entry.value}: {error}") from None


def _texts(value):
    """`(a b (c d))` as [a, b, (c d)]; a value that is no list as [value]."""
    value = value.strip()
    if not value.startswith("("):
        return [value]
    words, depth, found = foam_file.tokens(value[1:-1]), 0, []
    for token in words:
        if depth:
            found[-1] += " " + token.text
        else:
            found.append(token.text)
        depth += (token.text == "(") - (token.text == ")")
    return sweep_plan.listed(",".join(found))
