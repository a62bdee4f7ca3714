# SPDX-License-Identifier: GPL-3.0-or-later
"""Statistics of one or several runs over the same simulated time, side by side: profiles, overlaps, voidage, pressure."""

import argparse
import math
import os
import sys
from dataclasses import dataclass

from interphase import report_file, report_figure, report_keys, report_scene, report_table, run_report
from interphase.input_error import InputError
from interphase.matching_times import Matching
from interphase.report_scene import BoxMesh
from interphase.report_vessel import box_of, vessel_of
from interphase.run_records import find_run
from interphase.start_up import StartUp, later_half, start_up_of_run
from interphase.stored import open_h5

DETAILS = """Any run will do, of any vessel and length. x goes across, y is the depth from the front wall on, z is up.
Start-up is left out: what comes before --from, else before `from` of system/reportDict, else the time that MSER-5
finds in /series (pressure drop, bed height, kinetic energy, vertical velocity, number of particles; the latest of
them). Where a record is too short to tell, its latter half is shown, and no mean of it is trusted. What is measured where is
the vessel's (the box about the gas mesh, else about all spheres) unless system/reportDict says otherwise. From the
snapshots of particles.h5:

  velocity               mean of all real particles in a window (those of a sphere whose centre is in it), counted as
                         often as they are seen there
  granular temperature   (Theta_x + Theta_z)/3, Theta_x = 1/N sum (v_x - mean)^2 in a window, averaged over the
                         snapshots with two spheres or more, N real particles
  overlaps               of all pairs of spheres that overlap, over the diameter of the smaller one; not with walls
  voidage                of every cell of a uniform box mesh, the spheres' volume where it lies (a sphere that reaches
                         into several cells is divided by 64 points); the mapping of the run plays no part

and from /series of results.h5: pressure drop (mean, standard deviation, spectrum), bed height, kinetic energy.

Windows are read in a slice at the front wall (front) and over the whole depth (full). Both are written, one is shown:
front if each run tracks real particles, else full, since parcels are thicker than the slice.

Each number comes with the standard error of its mean, autocorrelation taken in. With several runs each is compared
with the first: the difference over its standard error sqrt(s1^2 + s2^2), and whether they agree (Welch's t,
--confidence for all quantities together). Records under 20 samples, or that drift, are not judged; the last lines say
how long the run would have to be, as far as the record shows.

The numbers go into each run's results.h5, below /profiles and /histograms, units as attributes; a second report
replaces the first.

exit code: 0, agreement or not; 2 where nothing can be reported (bad input, a run that is still going).

keys of system/reportDict, an OpenFOAM dictionary (none has to be there; see cases/sscp1):

@KEYS@

examples:
  tools/report runs/sscp1-CGPM-w8
  tools/report runs/sscp1-DEM-w1 runs/sscp1-CGPM-w8 --from 10
  tools/report runs/sscp1-CGPM-w8 --from 0.5 --no-write --out start-up.png""".replace("@KEYS@", "\n".join(report_keys.described()))


class Arguments(argparse.ArgumentParser):
    def error(self, message):
        raise InputError(f"{message}. Usage: tools/report RUN [RUN ...] [options]; see --help")


def arguments(given):
    parser = Arguments(
        prog="tools/report", description=__doc__, epilog=DETAILS, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("runs", metavar="RUN", nargs="+", help="a run's folder, with results.h5 and particles.h5")
    parser.add_argument(
        "--from", metavar="T", dest="start", type=number, help="leave out what is before T [s] (default: the case's, else found)"
    )
    parser.add_argument(
        "--until", metavar="T", dest="end", type=number,
        help="leave out what is after T [s] (default: the shortest run's end)",
    )
    parser.add_argument(
        "--out", metavar="FILE.png", help="the figure (default: RUN/report.png of the first run; with --no-write none)"
    )
    parser.add_argument("--depth", choices=("front", "full"), help="the windows to show (default: see below)")
    parser.add_argument("--every", metavar="N", type=int, default=1, help="read each N-th snapshot only (default: 1)")
    parser.add_argument("--scene", metavar="FILE", help="what to measure, instead of the runs' system/reportDict; same keys")
    parser.add_argument(
        "--confidence", metavar="C", type=number, default=0.95,
        help="of `agree` and `differ`, between 0 and 1 (default: 0.95)",
    )
    parser.add_argument(
        "--no-write", action="store_true", help="leave the runs' files alone; works on a run that is still going, too"
    )
    options = parser.parse_args(given)
    if options.every < 1:
        raise InputError(f"--every {options.every}: give a whole number above 0")
    if not 0 < options.confidence < 1:
        raise InputError(f"--confidence {options.confidence:g}: give a number between 0 and 1, such as 0.95")
    if options.start is not None and options.end is not None and options.start > options.end:
        raise InputError(f"--from {options.start:g} is after --until {options.end:g}: nothing is left to report")
    if options.out and not options.out.lower().endswith((".png", ".pdf", ".svg")):
        raise InputError(f"--out {options.out}: give a name that ends with .png (or .pdf, .svg)")
    if options.out and not os.path.isdir(os.path.dirname(os.path.abspath(options.out))):
        raise InputError(f"--out {options.out}: there is no folder {os.path.dirname(os.path.abspath(options.out))}")
    return options


def number(text):
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{text!r} is not a number")
    return value


def opened(path, no_write):
    """The `Records` in the folder `path`."""
    if not os.path.isdir(path):
        what = "is a file" if os.path.exists(path) else "no such folder"
        raise InputError(f"{path}: {what}; give a run's folder, such as runs/sscp1-CGPM-w8")
    run = find_run(path)
    if run is None:
        raise InputError(f"{path}: there is neither particles.h5 nor results.h5 in it: no run of interphase has written there")
    if run.particles is not None:
        with open_h5(run.particles) as file:
            if "snapshots" not in file:
                run.particles = None  # opened, but nothing written yet
    if not no_write:
        report_file.check_writable(run)
    return run


def started_from(run):
    """Which run this one started from, by tools/run --from, as a phrase; None where it did not."""
    start = run.record.get("from")
    if start is None:
        return None
    results = f", results.h5 of sha256 {start['results_sha256'][:12]}" if start["results_sha256"] else ""
    return f"starts from t = {start['time']:.9g} s of {start['run']} ({start['method']}{results}); {start['gas'] or 'no gas'}"


def names_of(runs):
    """Folders' names, or paths where two have the same."""
    short = [os.path.basename(os.path.abspath(run.path)) for run in runs]
    return short if len(set(short)) == len(short) else [os.path.normpath(run.path) for run in runs]


def common_scene(files, runs, start, end):
    """(`Scene`, notes): what to measure, of all runs the same."""
    meshes = [report_scene.box_mesh(run.path) for run in runs]
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


def snapshot_times(run):
    """Times of all snapshots [s]; none where none was recorded."""
    return [frame.time for frame in run.frames()]


@dataclass(frozen=True)
class Range:
    """`start` to `end` [s] in all runs, and `how` the start came about, a phrase; `unsettled`: per run its
    `StartUp` where that is not known to be over, else None."""

    start: float
    end: float
    how: str
    unsettled: tuple


def time_range(runs, names, files, options):
    """(`Range`, notes) that all runs have snapshots, or rows of /series, in."""
    spans, notes = [], []
    for run, name in zip(runs, names):
        times = snapshot_times(run)
        if not times:
            notes.append(f"{name}: no snapshots were recorded: neither profiles nor overlaps nor voidage")
            series = run.series()
            times = [] if series is None else series[0]
        if not len(times):
            raise InputError(f"{run.path}: holds neither snapshots nor rows of /series: there is nothing to report")
        spans.append((float(times[0]), float(times[-1])))
    first, end = max(first for first, _ in spans), min(last for _, last in spans)
    if options.end is not None:
        end = options.end
    settled = (None,) * len(runs)
    if options.start is not None:
        return _filled(runs, spans, Range(options.start, end, "--from", settled)), notes
    if first > end:
        raise InputError(f"the runs have no time in common: they go {' and '.join(f'from {a:g} to {b:g} s' for a, b in spans)}")
    given = [start for file in files if (start := report_scene.start_of(file)) is not None]
    if given and max(given) <= end:
        return Range(max(given), end, "`from` of system/reportDict", settled), notes
    if given:
        notes.append(f"`from` = {max(given):g} s of {report_scene.SCENE} is after what there is in all runs, which ends at {end:g} s: "
                     "the end of start-up is looked for instead")
    found = [start_up_of_run(run, options.end) for run in runs]
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
        times = snapshot_times(run) or run.series()[0]
        if not any(where.inside(time, wanted.start, wanted.end) for time in times):
            raise InputError(f"{run.path}: no snapshots from {wanted.start:g} to {wanted.end:g} s: it has them from {span[0]:g} to "
                             f"{span[1]:g} s; choose by --from and --until")
    return wanted


def described(windows, depth):
    """The windows in words."""
    low, high = windows.centre - windows.height / 2, windows.centre + windows.height / 2
    slice_of = f"front slice of {windows.front_depth:.3g} m" if depth == "front_slice" else "full depth"
    place = f"x = {windows.left:.4g} to {windows.right:.4g} m, z = {low:.4g} to {high:.4g} m, {slice_of}"
    return f"{windows.count} window{'s' * (windows.count > 1)} over {place}"


def report(options):
    runs = [opened(path, options.no_write) for path in options.runs]
    names, where = names_of(runs), Matching("time", None)
    files = [report_scene.opened(run.path, options.scene) for run in runs]
    looked_at, notes = time_range(runs, names, files, options)
    start, end = looked_at.start, looked_at.end
    scene, more = common_scene(files, runs, start, end)
    notes += more
    reports = []
    for name, run, unsettled in zip(names, runs, looked_at.unsettled):
        inside = [time for time in snapshot_times(run) if where.inside(time, start, end)]
        wanted = set(inside[::options.every])

        def progress(done, time):
            if sys.stderr.isatty():
                print(f"\r{name}: snapshot {done} of {len(wanted)}, t = {time:.4g} s ", end="", file=sys.stderr, flush=True)

        reports.append(run_report.measure(
            run, scene, lambda frame: frame.time in wanted, lambda time: where.inside(time, start, end), progress, unsettled,
        ))
        if not wanted and snapshot_times(run):
            reports[-1].notes.append(f"no snapshot lies between {start:g} and {end:g} s")
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr, flush=True)
    if options.depth:
        depth = "front_slice" if options.depth == "front" else "full_depth"
    else:
        depth = "front_slice" if all(run.recorded("weight") == 1 for run in runs) else "full_depth"

    print(f"from {start:g} to {end:g} s ({looked_at.how})" + (f"; {described(scene.windows, depth)}" if scene.windows else ""))
    print("\n".join(report_table.text(names, reports, depth, options.confidence)))
    for note in notes:
        print(f"note: {note}")
    for name, run, each in zip(names, runs, reports):
        if start := started_from(run):
            print(f"note: {name}: {start}")
        for note in each.notes:
            print(f"note: {name}: {note}")
    if not options.no_write:
        for run, each in zip(runs, reports):
            report_file.write(run, scene, each)
            print(f"numbers    {run.results} (/profiles, /histograms)")
    figure = options.out or (None if options.no_write else os.path.join(runs[0].path, "report.png"))
    if figure:
        report_figure.draw(figure, names, reports, depth, scene)
        print(f"figure     {figure}")


def main(given):
    try:
        report(arguments(given))
    except InputError as error:
        print(f"tools/report: error: {error}", file=sys.stderr)
        return 2
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except KeyboardInterrupt:
        sys.exit(130)
