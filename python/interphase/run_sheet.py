# SPDX-License-Identifier: GPL-3.0-or-later
"""All that a page says of one run, its pictures apart; and how it is kept as a small text file that the page can be made of again.

A file is JSON, an object for each dataclass with its class's name in `class`, of several in a list with `columns`. Numbers keep DIGITS digits. One that another
version has written is read as far as it says the same: what a class has no more is refused, what it has more keeps its default.
"""

import dataclasses
import importlib
import json
import math
import os
from dataclasses import dataclass, field
from typing import Optional

import numpy

from interphase import gas_profile, reporting, run_account, whole_file
from interphase.input_error import InputError
from interphase.report_scene import Scene
from interphase.run_account import Account
from interphase.run_report import RunReport

KIND = "sheet of a run of interphase"
END = ".sheet.json"
DIGITS = 7
MOST_ROWS = 600  # of a series that is kept for its curve


@dataclass(frozen=True)
class Sheet:
    """`name` of the run; what it was (`account`) and measured (`report`, of `scene`) from `start` to `end` [s], a range that came about by `how`.
    `likeness`: by which tools/plan finds scenes that are near (trades_of_runs.likeness), {} where it was not asked for.
    `profile`: (height, pressure, error) of the gas's mean pressure, None where `profile_missing` says why."""

    name: str
    account: Account
    report: RunReport
    scene: Scene
    start: float
    end: float
    how: str
    profile: Optional[tuple] = None
    profile_missing: str = ""
    likeness: dict = field(default_factory=dict)


def of_reported(runs, found):
    """[`Sheet`] of the `Records` and what reporting.reported has found of them."""
    return [_of_group([run], name, report, found) for name, run, report in zip(found.names, runs, found.reports)]


def each_over_its_own_time(groups, starts=None, scene_file=None, every=1, progress=lambda *_: None, snapshots=False, names=None):
    """([`Sheet`], notes) of lists of `Records`, of one run or of replicates, which become one record in pieces; each measured from its entry of `starts` [s] (None: as
    tools/report finds it) to its own end; what is measured is the same in all. For runs of different length. `names`: None, those of `names_of_groups`."""
    scene, snapshots, notes = reporting.scene_of_all([run for runs in groups for run in runs], scene_file, snapshots or every > 1)
    found = [reporting.reported(runs, start, None, scene_file, every, progress, snapshots, scene, as_one=True) for runs, start in zip(groups, starts or [None] * len(groups))]
    sheets = [_of_group(runs, name, each.reports[0], each) for runs, name, each in zip(groups, names or names_of_groups(groups), found)]
    return sheets, list(dict.fromkeys(notes + [note for each in found for note in each.notes]))


def names_of_groups(groups):
    """Of lists of `Records`: a run's own, what the names of replicates begin with alike ("DEM" of DEM_from-4 and DEM_from-8); none twice."""
    names = iter(reporting.names_of([run for runs in groups for run in runs]))
    each = [[next(names) for _ in runs] for runs in groups]
    short = [some[0] if len(some) == 1 else os.path.commonprefix(some).rstrip("-_. ").removesuffix("_from") for some in each]
    return [name if name and short.count(name) == 1 else "+".join(some) for name, some in zip(short, each)]


def _of_group(runs, name, report, found):
    """The `Sheet` of a run, or of replicates as one, with their `report` among what reporting.reported has `found`."""
    profiles = [gas_profile.pressure_profile(run.path, found.range.start, found.range.end) for run in runs]
    profile, missing = gas_profile.of_replicates([each for each, _ in profiles]), next((why for _, why in profiles if why), "")
    how = found.range.how if len(runs) == 1 else f"{found.range.how}, of each of {len(runs)} runs"
    account = run_account.of_replicates([run_account.of_run(run) for run in runs])
    return Sheet(name, account, report, found.scene, found.range.start, found.range.end, how, profile, missing)


def store(folder, sheets):
    """Write each into `folder`; the paths."""
    os.makedirs(folder, exist_ok=True)
    paths = []
    for sheet in sheets:
        path = os.path.join(folder, sheet.name.replace(os.sep, "_") + END)
        whole_file.write(path, as_text(sheet))
        paths.append(path)
    return paths


def stored_in(folder):
    """Paths of the sheets in `folder`, sorted."""
    if not os.path.isdir(folder):
        return []
    return [os.path.join(folder, name) for name in sorted(os.listdir(folder)) if name.endswith(END)]


def read(path):
    """The `Sheet` at `path`; InputError where it is none that can be read."""
    try:
        with open(path, encoding="utf-8") as stream:
            found = json.load(stream)
        if found.get("kind") != KIND:
            raise InputError(f"{path}: is no sheet of a run; tools/report RUN --store DIR writes them")
        sheet = _decoded(found["sheet"])
        if not isinstance(sheet, Sheet):
            raise KeyError("Sheet")
        return sheet
    except (OSError, ValueError, KeyError, TypeError, AttributeError, ModuleNotFoundError) as error:
        raise InputError(f"{path}: cannot be read as the sheet of a run: {error}; it may be of another version: store it again by tools/report "
                         "RUN --store DIR") from None  # fmt: skip


def as_text(sheet):
    """The file's text."""
    report = dataclasses.replace(sheet.report)
    if report.pressure is not None and len(report.pressure[0]) > MOST_ROWS:
        report.pressure = None if report.spectrum is not None else tuple(each[:: -(-len(each) // MOST_ROWS)] for each in report.pressure)
    if report.spectrum is not None:
        report.spectrum = _thinned(report.spectrum)
    encoded = _encoded(dataclasses.replace(sheet, report=report))
    inside = encoded.pop("report")
    # A line for each part, so that one finds one's way and versions can be compared.
    lines = [f'"{name}": {_line(value)}' for name, value in encoded.items()]
    lines.append('"report": {\n  ' + ",\n  ".join(f'"{name}": {_line(value)}' for name, value in inside.items()) + "}")
    return f'{{"kind": "{KIND}",\n"sheet": {{' + ",\n".join(lines) + "}}\n"


def _thinned(spectrum):
    """The `Spectrum` at frequencies half a resolution apart: those between depend on them."""
    spacing = float(spectrum.frequency[1] - spectrum.frequency[0])
    kept = slice(None, None, max(1, round(spectrum.resolution / 2 / spacing)))
    return dataclasses.replace(spectrum, **{name: getattr(spectrum, name)[kept] for name in ("frequency", "power", "low", "high")})


def _line(value):
    return json.dumps(value, allow_nan=False, separators=(",", ":"), ensure_ascii=False)


def _encoded(value):
    if dataclasses.is_dataclass(value):
        return {"class": _name(value), **_fields(value)}
    if isinstance(value, numpy.ndarray):
        return {"array": _numbers(value.tolist())}
    if isinstance(value, numpy.generic):
        return _encoded(value.item())
    if isinstance(value, float):
        if not math.isfinite(value):
            return {"number": repr(value)}
        return _shortened(value)
    if isinstance(value, tuple):
        return {"tuple": [_encoded(each) for each in value]}
    if isinstance(value, list):
        if len(value) > 1 and dataclasses.is_dataclass(value[0]) and all(type(each) is type(value[0]) for each in value):
            names = [each.name for each in dataclasses.fields(value[0])]
            return {"class": _name(value[0]), "columns": {name: _encoded([getattr(each, name) for each in value]) for name in names}}
        return [_encoded(each) for each in value]
    if isinstance(value, dict):
        return {"map": {str(key): _encoded(each) for key, each in value.items()}}
    return value


def _shortened(value):
    short = float(f"{value:.{DIGITS}g}")
    return int(short) if short == int(short) and abs(short) < 1e15 else short


def _numbers(values):
    """Of an array, as lists; what is not finite is null."""
    if isinstance(values, list):
        return [_numbers(each) for each in values]
    return _shortened(float(values)) if math.isfinite(values) else None


def _name(value):
    return f"{type(value).__module__.removeprefix('interphase.')}.{type(value).__name__}"


def _fields(value):
    return {each.name: _encoded(getattr(value, each.name)) for each in dataclasses.fields(value)}


def _decoded(value):
    if isinstance(value, list):
        return [_decoded(each) for each in value]
    if not isinstance(value, dict):
        return value
    if "class" in value:
        return _object(value)
    if "number" in value:
        return float(value["number"])
    if "array" in value:
        return numpy.array(value["array"], dtype=float)  # of null it makes NaN
    if "tuple" in value:
        return tuple(_decoded(each) for each in value["tuple"])
    return {key: _decoded(each) for key, each in value["map"].items()}


def _object(value):
    module, _, name = value["class"].rpartition(".")
    if not module.isidentifier():
        raise KeyError(value["class"])
    kind = getattr(importlib.import_module(f"interphase.{module}"), name)
    if not dataclasses.is_dataclass(kind):
        raise KeyError(value["class"])
    if "columns" in value:
        columns = {key: _decoded(each) for key, each in value["columns"].items()}
        return [kind(**dict(zip(columns, row))) for row in zip(*columns.values())]
    return kind(**{key: _decoded(each) for key, each in value.items() if key != "class"})
