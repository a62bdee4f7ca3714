# SPDX-License-Identifier: GPL-3.0-or-later
"""What tools/report finds of one or several runs: which time, which windows and cells, and the numbers of each run in them."""

import os
from dataclasses import dataclass

import h5py

from interphase import report_file, report_scene, run_report, run_state, stored
from interphase.box_mesh import BoxMesh, box_mesh
from interphase.input_error import InputError
from interphase.matching_times import Matching
from interphase.record_samples import Piece
from interphase.report_scene import Scene
from interphase.report_vessel import box_of, vessel_of
from interphase.run_records import find_run
from interphase.statistics_rows import scene_of_rows, statistics_rows
from interphase.start_up import StartUp, later_half, start_up_of_run


def opened(path):
    """The `Records` in the folder `path`."""
    run = find_run(run_state.checked_folder(path))
    if run is None:
        raise InputError(f"{path}: there is neither particles.h5 nor results.h5 in it: no run of interphase has written there")
    if run.particles is not None:
        with stored.open_h5(run.particles) as file:
            if "snapshots" not in file:
                run.particles = None  # opened, but nothing written yet
    return run


def names_of(runs):
    """Folders' names, or paths where two have the same."""
    short = [os.path.basename(os.path.abspath(run.path)) for run in runs]
    return short if len(set(short)) == len(short) else [os.path.normpath(run.path) for run in runs]


def _files(runs, names, scene_file):
    """(the `File` that says what to measure in each run, notes). A run without one is measured by that of the first run that has one."""
    files = [report_scene.opened(run.path, scene_file) for run in runs]
    has = [file.given for file in files]
    if all(has) or not any(has):
        return files, []
    first = has.index(True)
    without = [name for name, there in zip(names, has) if not there]
    return ([file if there else files[first] for file, there in zip(files, has)],
            [f"{' and '.join(without)} without a block `statistics`: measured as {names[first]} says"])


def _common_scene(files, runs, taken, start, end):
    """(`Scene`, notes): what to measure, of all runs the same; what `taken` (per run `StatisticsRows`, or None at all) have."""
    if taken is not None:
        scenes = [scene_of_rows(rows, report_scene.percentiles_of(file)) for rows, file in zip(taken, files)]
        _demand_same(runs, scenes, "by --snapshots and --scene FILE")
        return scenes[0], []
    meshes = [box_mesh(run.path) for run in runs]
    mesh = meshes[0] if all(other == meshes[0] for other in meshes) else next(
        (mesh for mesh in meshes if not isinstance(mesh, BoxMesh)), "the runs' meshes differ")
    boxes = [box_of(run, own if isinstance(own, BoxMesh) else None) for run, own in zip(runs, meshes)]
    where = Matching("time", None)
    vessel, notes = vessel_of(runs, boxes, lambda time: where.inside(time, start, end))
    found = [report_scene.scene_of(file, vessel, mesh) for file in files]
    _demand_same(runs, [scene for scene, _ in found], "by --scene FILE")
    return found[0][0], notes + found[0][1]


def _demand_same(runs, scenes, how):
    for run, scene in zip(runs[1:], scenes[1:]):
        if scene != scenes[0]:
            what = ", ".join(name for name in ("windows", "overlaps", "voidage") if getattr(scene, name) != getattr(scenes[0], name))
            raise InputError(f"{runs[0].path} and {run.path} do not measure the same ({what} differ); give one for all {how}")


@dataclass(frozen=True)
class Range:
    """`start` to `end` [s] in all runs, and `how` the start came about, a phrase; `unsettled`: per run its
    `StartUp` where that is not known to be over, else None."""

    start: float
    end: float
    how: str
    unsettled: tuple


def _time_range(runs, names, files, taken, start, end):
    """(`Range`, notes) that all runs have snapshots, rows of /statistics (`taken`) or of /series in; `start` and `end` [s] where given."""
    spans, notes, samples = [], [], []
    for at, (run, name) in enumerate(zip(runs, names)):
        times = run.snapshot_times() if taken is None else taken[at].time.tolist()
        if not times:
            notes.append(f"{name}: no snapshots were recorded: neither profiles nor overlaps nor voidage")
            series = run.series()
            times = [] if series is None else series[0]
        if not len(times):
            raise InputError(f"{run.path}: holds neither snapshots nor rows of /series: there is nothing to report")
        spans.append((float(times[0]), float(times[-1])))
        samples.append(times)
    asked, first = end, max(first for first, _ in spans)
    end = min(last for _, last in spans) if end is None else end
    settled = (None,) * len(runs)
    if start is not None:
        return _filled(runs, spans, samples, Range(start, end, "--from", settled)), notes
    if first > end:
        raise InputError(f"the runs have no time in common: they go {' and '.join(f'from {a:g} to {b:g} s' for a, b in spans)}")
    given = [start for file in files if (start := report_scene.start_of(file)) is not None]
    if given and max(given) <= end:
        return Range(max(given), end, f"`from` of {os.path.basename(files[0].path)}", settled), notes
    if given:
        notes.append(f"`from` = {max(given):g} s of {report_scene.SCENE} is after what there is in all runs, which ends at {end:g} s: "
                     "the end of start-up is looked for instead")
    found = [start_up_of_run(run, asked) for run in runs]
    ends = [each.end for each in found if each.end is not None]
    for at, each in enumerate(found):
        if each.end is not None and each.end >= end:
            found[at] = StartUp(None, reason=f"it ends at {each.end:.4g} s, what all runs have at {end:.4g} s")
    if any(each.reason for each in found):
        for name, each in zip(names, found):
            if each.reason:
                more = "" if each.needed is None else f"; a run to t = {each.needed:.3g} s at least may tell"
                notes.append(f"{name}: start-up not known to be over: {each.reason}{more}")
        start = max([later_half(first, end), *(each for each in ends if each < end)])
        return Range(start, end, "the latter half, as start-up is not known to be over",
                     tuple(each if each.reason else None for each in found)), notes
    last = max(found, key=lambda each: each.end)
    how = f"{last.by} settles last" if last.by else "steady from the first row on"
    return Range(max(last.end, first), end, f"start-up found by MSER-5: {how}", settled), notes


def _filled(runs, spans, samples, wanted):
    """The `Range` that was asked for; InputError where a run has nothing there."""
    where = Matching("time", None)
    for run, span, times in zip(runs, spans, samples):
        if not any(where.inside(time, wanted.start, wanted.end) for time in times):
            raise InputError(f"{run.path}: no snapshots from {wanted.start:g} to {wanted.end:g} s: it has them from {span[0]:g} to "
                             f"{span[1]:g} s; choose by --from and --until")
    return wanted


@dataclass(frozen=True)
class Reported:
    """Of several runs: the `names` they are told apart by, the time `range`, the `scene` that is measured, a `RunReport` of each, and `notes`."""

    names: list
    range: Range
    scene: Scene
    reports: list
    notes: list


def _taken(runs, names, snapshots):
    """(`StatisticsRows` of each run, notes), None where one has none, or `snapshots` are asked for."""
    found = [statistics_rows(run) for run in runs]
    if snapshots or not any(found):
        return None, []
    without = [name for name, rows in zip(names, found) if rows is None]
    if without:
        return None, [f"{' and '.join(without)} without rows of /statistics: all is measured of snapshots"]
    return found, []


def scene_of_all(runs, scene_file=None, snapshots=False):
    """(`Scene` that holds for all `Records` over all of their time, whether it is measured of snapshots, notes)."""
    names = names_of(runs)
    files, notes = _files(runs, names, scene_file)
    taken, of_rows = _taken(runs, names, snapshots or scene_file is not None)
    scene, more = _common_scene(files, runs, taken, None, None)
    return scene, taken is None, notes + of_rows + more


def reported(runs, start=None, end=None, scene_file=None, every=1, progress=lambda name, done, of, time: None, snapshots=False, scene=None, as_one=False):
    """`Reported` of the `Records` of several runs from `start` to `end` [s] (None: as tools/report chooses): of the rows of /statistics
    where each has them, unless `snapshots` or a `scene_file` (in the place of what the runs say) is given, else by each `every`-th
    snapshot. `scene` is measured instead of what the files say. `progress` is called at each snapshot. `as_one`: one report of all, as of one record in pieces."""
    names, where = names_of(runs), Matching("time", None)
    files, notes = _files(runs, names, scene_file)
    taken, of_rows = _taken(runs, names, snapshots or scene_file is not None or every > 1)
    looked_at, more = _time_range(runs, names, files, taken, start, end)
    more, of_scene = of_rows + more, []
    if scene is None:
        scene, of_scene = _common_scene(files, runs, taken, looked_at.start, looked_at.end)

    def inside(time):
        return where.inside(time, looked_at.start, looked_at.end)

    wanted = [set() if taken is not None else set([time for time in run.snapshot_times() if inside(time)][::every]) for run in runs]

    def piece(at):
        return Piece(runs[at], lambda frame: frame.time in wanted[at], inside, taken and taken[at], lambda done, time: progress(names[at], done, len(wanted[at]), time))

    reports = []
    for some in [range(len(runs))] if as_one else [[at] for at in range(len(runs))]:
        unsettled = next((found for at in some if (found := looked_at.unsettled[at])), None)
        reports.append(run_report.measure([piece(at) for at in some], scene, unsettled))
        if taken is None and not any(wanted[at] for at in some) and any(runs[at].snapshot_times() for at in some):
            reports[-1].notes.append(f"no snapshot lies between {looked_at.start:g} and {looked_at.end:g} s")
    return Reported(names, looked_at, scene, reports, notes + more + of_scene)


def statistics_of(folder):
    """{path: Stored} of what tools/report has written into results.h5 of the run in `folder`, or would write; the file stays as it is."""
    run = opened(folder)
    if kept := report_file.kept(run):
        return kept
    found = reported([run])
    with h5py.File("statistics", "w", driver="core", backing_store=False) as file:  # in memory
        report_file.fill(file, found.scene, found.reports[0])
        return stored.within(file, report_file.GROUPS)
