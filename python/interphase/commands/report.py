# SPDX-License-Identifier: GPL-3.0-or-later
"""Statistics of one or several runs over the same simulated time, side by side: profiles, overlaps, voidage, pressure."""

import argparse
import json
import math
import os
import sys

from interphase import report_file, report_figure, report_scene, report_table, run_report
from interphase.input_error import InputError
from interphase.matching_times import Matching
from interphase.run_records import find_run, open_h5

DETAILS = """What is measured where stands in the case's system/reportDict (see cases/sscp1). x goes across, y is the depth from
the front wall on, z is up. From the snapshots of particles.h5:

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
--confidence for all quantities together). Records under 20 snapshots, or that drift, are not judged.

The numbers go into each run's results.h5, below /profiles and /histograms, units as attributes; a second report
replaces the first.

exit code: 0, agreement or not; 2 where nothing can be reported (bad input, a run that is still going).

examples:
  tools/report runs/sscp1-DEM-w1 runs/sscp1-CGPM-w8 --from 10
  tools/report runs/sscp1-CGPM-w8 --from 0.5 --no-write --out start-up.png"""


class Arguments(argparse.ArgumentParser):
    def error(self, message):
        raise InputError(f"{message}. Usage: tools/report RUN [RUN ...] [options]; see --help")


def arguments(given):
    parser = Arguments(
        prog="tools/report", description=__doc__, epilog=DETAILS, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("runs", metavar="RUN", nargs="+", help="a run's folder, with particles.h5 and results.h5")
    parser.add_argument(
        "--from", metavar="T", dest="start", type=number, help="leave out what is before T [s] (default: the case's)"
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
    parser.add_argument("--scene", metavar="FILE", help="what to measure, instead of the runs' system/reportDict")
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
    """The `Run` in the folder `path`."""
    if not os.path.isdir(path):
        what = "is a file" if os.path.exists(path) else "no such folder"
        raise InputError(f"{path}: {what}; give a run's folder, such as runs/sscp1-CGPM-w8")
    run = find_run(path)
    if run is None or run.particles is None:
        raise InputError(f"{path}: there is no particles.h5 in it: no run of interphase has written particles there")
    if not no_write:
        report_file.check_writable(run)
    return run


def weight_of(run):
    """Real particles per tracked one, from /meta or run.json; None where neither says."""
    try:
        if run.results:
            with open_h5(run.results) as file:
                return float(file["meta"].attrs["weight"])
    except (InputError, KeyError):
        pass
    try:
        with open(os.path.join(run.path, "run.json"), encoding="utf-8") as file:
            return float(json.load(file)["weight"])
    except (OSError, ValueError, KeyError, TypeError):
        return None


def started_from(run):
    """Which run this one started from, by tools/run --from, as a phrase; None where it did not."""
    try:
        with open(os.path.join(run.path, "run.json"), encoding="utf-8") as file:
            start = json.load(file)["from"]
        results = f", results.h5 of sha256 {start['results_sha256'][:12]}" if start["results_sha256"] else ""
        return f"starts from t = {start['time']:.9g} s of {start['run']} ({start['method']}{results}); {start['gas'] or 'no gas'}"
    except (OSError, ValueError, KeyError, TypeError):
        return None


def names_of(runs):
    """Folders' names, or paths where two have the same."""
    short = [os.path.basename(os.path.abspath(run.path)) for run in runs]
    return short if len(set(short)) == len(short) else [os.path.normpath(run.path) for run in runs]


def common_scene(runs, scene_file):
    """What to measure: of all runs the same."""
    scenes = [report_scene.read(run.path, scene_file) for run in runs]
    for run, scene in zip(runs[1:], scenes[1:]):
        if scene != scenes[0]:
            what = ", ".join(name for name in ("windows", "overlaps", "voidage", "start")
                             if getattr(scene, name) != getattr(scenes[0], name))
            raise InputError(
                f"{runs[0].path} and {run.path} do not measure the same ({what.replace('start', 'from')} of "
                "system/reportDict or the mesh differ); give one for all by --scene FILE"
            )
    return scenes[0]


def time_range(runs, scene, options):
    """(start, end) [s] that all runs have snapshots in."""
    start = scene.start if options.start is None else options.start
    spans = []
    for run in runs:
        times = [frame.time for frame in run.frames()]
        if not times:
            raise InputError(f"{run.particles}: holds no snapshots yet")
        spans.append((times[0], times[-1]))
    end = min(last for _, last in spans) if options.end is None else options.end
    where = Matching("time", None)
    for run, span in zip(runs, spans):
        if not any(where.inside(frame.time, start, end) for frame in run.frames()):
            raise InputError(
                f"{run.path}: no snapshots from {start:g} to {end:g} s: it has them from {span[0]:g} to {span[1]:g} s; "
                "choose by --from and --until" + (f" (`from` of the case is {scene.start:g} s)" if options.start is None else "")
            )
    return start, end


def report(options):
    runs = [opened(path, options.no_write) for path in options.runs]
    scene = common_scene(runs, options.scene)
    if not (scene.windows or scene.overlaps or scene.voidage):
        print("tools/report: note: the case asks for neither windows nor overlaps nor voidage", file=sys.stderr)
    start, end = time_range(runs, scene, options)
    names, where = names_of(runs), Matching("time", None)
    reports = []
    for name, run in zip(names, runs):
        inside = [frame.time for frame in run.frames() if where.inside(frame.time, start, end)]
        wanted = set(inside[::options.every])

        def progress(done, time):
            if sys.stderr.isatty():
                print(f"\r{name}: snapshot {done} of {len(wanted)}, t = {time:.4g} s ", end="", file=sys.stderr, flush=True)

        reports.append(run_report.measure(
            run, scene, lambda frame: frame.time in wanted, lambda time: where.inside(time, start, end), progress,
        ))
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr, flush=True)
    if options.depth:
        depth = "front_slice" if options.depth == "front" else "full_depth"
    else:
        depth = "front_slice" if all(weight_of(run) == 1 for run in runs) else "full_depth"

    print(f"from {start:g} to {end:g} s" + (f"; windows: {depth.replace('_', ' ')}" if scene.windows else ""))
    print("\n".join(report_table.text(names, reports, depth, options.confidence)))
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
