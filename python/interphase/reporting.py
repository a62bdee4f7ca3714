# SPDX-License-Identifier: GPL-3.0-or-later
"""What tools/report finds of one or several runs: which time, which windows and cells, and the numbers of each run in them."""

import os
from dataclasses import dataclass

import h5py

from interphase import report_file, report_scene, run_report, run_state, stored
from interphase.box_mesh import BoxMesh, box_mesh
from interphase.input_error import InputError
from interphase.matching_times import Matching
from interphase.report_scene import Scene
from interphase.report_vessel import box_of, vessel_of
from interphase.run_records import find_run
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
    """(the system/reportDict of each run, notes). A run without one is measured by that of the first run that has one."""
    files = [report_scene.opened(run.path, scene_file) for run in runs]
    has = [file.text != "" for file in files]
    if all(has) or not any(has):
        return files, []
    first = has.index(True)
    without = [name for name, there in zip(names, has) if not there]
    return ([file if there else files[first] for file, there in zip(files, has)],
            [f"{' and '.join(without)} without system/reportDict: measured as that of {names[first]} says"])


def _common_scene(files, runs, start, end):
    """(`Scene`, notes): what to measure, of all runs the same."""
    meshes = [box_mesh(run.path) for run in runs]
    mesh = meshes[0] if all(other == meshes[0] for other in meshes) else next(
        (mesh for mesh in meshes if not isinstance(mesh, BoxMesh)), "the runs' meshes differ")
    boxes = [box_of(run, own if isinstance(own, BoxMesh) else None) for run, own in zip(runs, meshes)]
    where = Matching("time", None)
    vessel, notes = vessel_of(runs, boxes, lambda time: where.inside(time, start, end))
    found = [report_scene.scene_of(file, vessel, mesh) for file in files]
    for run, (scene, _) in zip(runs[1:], found[1:]):
        if scene != found[0][0]:
            what = ", ".join(name for name in ("windows", "overlaps", "voidage") if getattr(scene, name) != getattr(found[0][0], name))
            raise InputError(f"{runs[0].path} and {run.path} do not measure the same ({what} of system/reportDict differ); give one "
                             "for all by --scene FILE")
    return found[0][0], notes + found[0][1]


@dataclass(frozen=True)
class Range:
    """`start` to `end` [s] in all runs, and `how` the start came about, a phrase; `unsettled`: per run its
    `StartUp` where that is not known to be over, else None."""

    start: float
    end: float
    how: str
    unsettled: tuple


def _time_range(runs, names, files, start, end):
    """(`Range`, notes) that all runs have snapshots, or rows of /series, in; `start` and `end` [s] where they are given."""
    spans, notes = [], []
    for run, name in zip(runs, names):
        times = run.snapshot_times()
        if not times:
            notes.append(f"{name}: no snapshots were recorded: neither profiles nor overlaps nor voidage")
            series = run.series()
            times = [] if series is None else series[0]
        if not len(times):
            raise InputError(f"{run.path}: holds neither snapshots nor rows of /series: there is nothing to report")
        spans.append((float(times[0]), float(times[-1])))
    asked, first = end, max(first for first, _ in spans)
    end = min(last for _, last in spans) if end is None else end
    settled = (None,) * len(runs)
    if start is not None:
        return _filled(runs, spans, Range(start, end, "--from", settled)), notes
    if first > end:
        raise InputError(f"the runs have no time in common: they go {' and '.join(f'from {a:g} to {b:g} s' for a, b in spans)}")
    given = [start for file in files if (start := report_scene.start_of(file)) is not None]
    if given and max(given) <= end:
        return Range(max(given), end, "`from` of system/reportDict", settled), notes
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


def _filled(runs, spans, wanted):
    """The `Range` that was asked for; InputError where a run has nothing there."""
    where = Matching("time", None)
    for run, span in zip(runs, spans):
        times = run.snapshot_times() or run.series()[0]
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


def scene_of_all(runs, scene_file=None):
    """(`Scene` that holds for all `Records` over all of their time, notes)."""
    files, notes = _files(runs, names_of(runs), scene_file)
    scene, more = _common_scene(files, runs, None, None)
    return scene, notes + more


def reported(runs, start=None, end=None, scene_file=None, every=1, progress=lambda name, done, of, time: None, scene=None):
    """`Reported` of the `Records` of several runs from `start` to `end` [s] (None: as tools/report chooses), by each `every`-th snapshot;
    `scene_file` takes the place of the runs' system/reportDict, `scene` of what that says to measure. `progress` is called at each snapshot."""
    names, where = names_of(runs), Matching("time", None)
    files, notes = _files(runs, names, scene_file)
    looked_at, more = _time_range(runs, names, files, start, end)
    of_scene = []
    if scene is None:
        scene, of_scene = _common_scene(files, runs, looked_at.start, looked_at.end)

    def inside(time):
        return where.inside(time, looked_at.start, looked_at.end)

    reports = []
    for name, run, unsettled in zip(names, runs, looked_at.unsettled):
        times = run.snapshot_times()
        wanted = set([time for time in times if inside(time)][::every])
        reports.append(run_report.measure(run, scene, lambda frame: frame.time in wanted, inside,
                                          lambda done, time: progress(name, done, len(wanted), time), unsettled))  # fmt: skip
        if times and not wanted:
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
