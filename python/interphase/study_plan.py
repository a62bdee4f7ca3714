# SPDX-License-Identifier: GPL-3.0-or-later
"""The runs of a study: beds that are developed first, then a run of each combination; what is refused before any of them begins."""

import dataclasses
import math
import os
import re
import subprocess

from interphase import case_folder, foam_file, launch, methods, report_scene, run_state, stored, study_file, sweep_plan
from interphase.box_mesh import BoxMesh, box_mesh
from interphase.case import Case
from interphase.case_folder import CONTROL, COUPLING
from interphase.input_error import InputError
from interphase.report_vessel import Vessel


OTHER_SETTINGS = "it is a run of other settings"


@dataclasses.dataclass(frozen=True)
class Plan:
    """`beds` and then `points` (sweep_plan.Point) are run; `starts` {name: from when it is measured [s], None: found}; `pieces_of` {name: what replicates of several start
    times are together}."""

    beds: list
    points: list
    starts: dict
    pieces_of: dict


def of(study, folder):
    """The `Plan` of a `Study` in `folder`; InputError where one of its runs cannot be."""
    beds, points, starts, pieces_of = {}, [], {}, {}
    for row in study.rows:
        made = _points(study, row)
        for point in made:
            name = row.name if len(made) == 1 else f"{row.name}_{point.name}"
            times = [None] if study.developed is None else row.times or [study.developed.time]
            for time in times:
                called = name + (f"_from-{time:g}" if len(times) > 1 else "")
                if time is not None:
                    bed = beds.setdefault(point.case.weight, _bed(study, point.case.weight))
                    _check_snapshot(bed.case, time, study)
                    point = dataclasses.replace(point, start=f"{os.path.join(folder, bed.name)}@{time:.9g}")
                points.append(dataclasses.replace(point, name=called))
                starts[called], pieces_of[called] = row.start, name
    names = [point.name for point in points]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice:
        raise InputError(f"{study.path}: two runs would be named {twice}: rename a row")
    alike = {}
    for point in points:
        other = alike.setdefault((point.identity, point.start), point)
        if other is not point:
            raise InputError(f"{study.path}: {other.name} and {point.name} are the same run: take it out of one row")
    together = list(dict.fromkeys(pieces_of.values()))
    if study.reference is not None and study.reference not in together:
        raise InputError(f"{study.path}: reference {study.reference} is none of the runs: {foam_file.nearest(study.reference, together)}")
    return Plan(list(beds.values()), points, starts, pieces_of)


def _points(study, row):
    """Those of a row; methods that track every particle go with W = 1, whatever the list says."""
    methods = row.methods or [None]
    found = []
    base = Case(study.case)
    for method in methods:
        weights = row.weights
        if weights is not None and base.method_of(method).of_particles:
            weights = None if method is not None else ["1"]
        try:
            found += sweep_plan.plan(study.case, row.sets, None if method is None else [method], weights, row.seeds, row.until)
        except InputError as error:
            raise InputError(f"{study.path}: row {row.name}: {error}") from None
    return found


def _bed(study, weight):
    """The run that develops a bed: of the vessel, gas and particles that all rows have alike; its solid step is its own method's."""
    developed = study.developed
    method = developed.method if weight == 1 else developed.of_parcels
    first = study.rows[0].sets
    alike = {name: values[0] for name, values in first.items() if len(values) == 1 and all(row.sets.get(name) == values for row in study.rows)}
    alike.pop(study_file.SHORT["solidSteps"], None)
    case = Case(study.case).set(alike).set(method=method, weight=f"{weight:g}")
    return sweep_plan.Point(f"developed-w{weight:g}", case, developed.time, {})


def _check_snapshot(case, time, study):
    """Snapshots must be there at the time that a run starts from."""
    interval = case.dictionaries.number(COUPLING, "records/snapshotInterval", 0.0)
    if interval > 0 and abs(time / interval - round(time / interval)) > 1e-6:
        raise InputError(f"{study.path}: t = {time:g} s of the developed bed is no multiple of records/snapshotInterval = {interval:g} s: there "
                         "would be no snapshot to start from")  # fmt: skip


def check_plugins(study, plan, binary):
    """InputError where a method's plug-in is not there for the program."""
    case = case_folder.Dictionaries(study.case)
    folders = [each for each in os.environ.get("INTERPHASE_PLUGIN_PATH", "").split(":") if each]
    beside = os.path.dirname(os.path.realpath(binary))
    folders += [os.path.join(beside, "plugins"), os.path.normpath(os.path.join(beside, "..", "lib", "interphase", "plugins"))]
    for method in sorted({point.case.method for point in [*plan.beds, *plan.points]}):
        plugin = case_folder.method_of(case, method).plugin
        if plugin in methods.plugins_of_tree() and not any(os.path.isfile(os.path.join(each, f"lib{plugin}.so")) for each in folders):
            raise InputError(f"{study.path}: method {method} takes its collisions from the plug-in {plugin}, and no lib{plugin}.so is in {', '.join(folders)}: "
                             "build it (tools/setup), or leave the method out")  # fmt: skip


def check_windows(study):
    """InputError where the case's windows have no part in its vessel, as far as both stand in its files."""
    file, mesh = report_scene.opened(study.case), box_mesh(study.case)
    if not isinstance(mesh, BoxMesh):
        return
    size = max(b - a for a, b in zip(mesh.low, mesh.high))
    # No spheres are known yet: a size that makes no window too narrow
    vessel = Vessel(mesh.low, mesh.high, "the gas mesh", 1e-6 * size, 1e-6 * size, 1e-6 * size, (mesh.low[2] + mesh.high[2]) / 2)
    _, notes = report_scene.scene_of(file, vessel, mesh)
    if outside := next((note for note in notes if "outside" in note or "no part in" in note), None):
        raise InputError(f"{study.path}: {outside.split('; the default')[0]}")


def version_of(binary):
    """The commit of the program, "" where it does not tell."""
    said = subprocess.run([binary, "-version"], capture_output=True, text=True, env={**os.environ, **launch.additions(os.environ)}).stdout
    found = re.search(r"commit (\w+)", said)
    return found[1] if found else ""


def unlike(point, folder, commit):
    """Why what is in `folder` is not the run that `point` asks for, OTHER_SETTINGS or a phrase on its version; "" where it is, or nothing is there."""
    record = run_state.record(folder) if os.path.isdir(folder) else {}
    if "method" not in record:
        return ""
    start = record.get("from")
    is_of = sweep_plan.identity(record["method"], record["weight"], record.get("settings") or [])
    begins = None if start is None else f"{os.path.basename(start['run'])}@{start['time']:.9g}"
    asked = None if point.start is None else os.path.basename(point.start)
    if is_of != point.identity or (begins != asked and (start is not None or point.start is None)):
        return OTHER_SETTINGS
    results = os.path.join(folder, "results.h5")
    of = stored.attributes(results, "meta").get("commit", "") if os.path.isfile(results) else ""
    return f"it is of version {of[:10]}, the program is of {commit[:10]}" if of and commit and of != commit else ""


def steps(point):
    """Gas steps of a run, None where deltaT is no number."""
    step = point.case.dictionaries.number(CONTROL, "deltaT")
    return math.ceil(point.until / step - 1e-9) if step else None
