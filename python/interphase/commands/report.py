# SPDX-License-Identifier: GPL-3.0-or-later
"""Statistics of one or several runs over the same simulated time, side by side: profiles, overlaps, voidage, pressure."""

import os
import sys

from interphase import report_figure, report_file, report_keys, report_table, reporting
from interphase.command_line import Parser, check_order, count, share, time
from interphase.input_error import InputError

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

and from /series of results.h5: pressure drop (mean, standard deviation, spectrum
with its 95 % band, strongest frequency where a peak stands out of it), bed height, kinetic energy.

Windows are read in a slice at the front wall (front) and over the whole depth (full). Both are written, one is shown:
front if each run tracks real particles, else full, since parcels are thicker than the slice.

Each number comes with the standard error of its mean, autocorrelation taken in. With several runs each is compared
with the first: the difference over its standard error sqrt(s1^2 + s2^2), and whether they agree (Welch's t,
--confidence for all quantities together). Records under 20 samples, shorter than 20 times
their memory, or that drift, are not judged; the last lines say
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


def arguments(given):
    parser = Parser("tools/report", "RUN [RUN ...]", description=__doc__, epilog=DETAILS)
    parser.add_argument("runs", metavar="RUN", nargs="+", help="a run's folder, with results.h5 and particles.h5")
    parser.add_argument(
        "--from", metavar="T", dest="start", type=time, help="leave out what is before T [s] (default: the case's, else found)"
    )
    parser.add_argument(
        "--until", metavar="T", dest="end", type=time,
        help="leave out what is after T [s] (default: the shortest run's end)",
    )
    parser.add_argument(
        "--out", metavar="FILE.png", help="the figure (default: RUN/report.png of the first run; with --no-write none)"
    )
    parser.add_argument("--depth", choices=("front", "full"), help="the windows to show (default: see below)")
    parser.add_argument("--every", metavar="N", type=count, default=1, help="read each N-th snapshot only (default: 1)")
    parser.add_argument("--scene", metavar="FILE", help="what to measure, instead of the runs' system/reportDict; same keys")
    parser.add_argument(
        "--confidence", metavar="C", type=share, default=0.95,
        help="of `agree` and `differ`, between 0 and 1 (default: 0.95)",
    )
    parser.add_argument(
        "--no-write", action="store_true", help="leave the runs' files alone; works on a run that is still going, too"
    )
    options = parser.parse_args(given)
    check_order(options.start, options.end)
    if options.out and not options.out.lower().endswith((".png", ".pdf", ".svg")):
        raise InputError(f"--out {options.out}: give a name that ends with .png (or .pdf, .svg)")
    if options.out and not os.path.isdir(os.path.dirname(os.path.abspath(options.out))):
        raise InputError(f"--out {options.out}: there is no folder {os.path.dirname(os.path.abspath(options.out))}")
    return options


def started_from(run):
    """Which run this one started from, by tools/run --from, as a phrase; None where it did not."""
    start = run.record.get("from")
    if start is None:
        return None
    results = f", results.h5 of sha256 {start['results_sha256'][:12]}" if start["results_sha256"] else ""
    return f"starts from t = {start['time']:.9g} s of {start['run']} ({start['method']}{results}); {start['gas'] or 'no gas'}"


def described(windows, depth):
    """The windows in words."""
    low, high = windows.centre - windows.height / 2, windows.centre + windows.height / 2
    slice_of = f"front slice of {windows.front_depth:.3g} m" if depth == "front_slice" else "full depth"
    place = f"x = {windows.left:.4g} to {windows.right:.4g} m, z = {low:.4g} to {high:.4g} m, {slice_of}"
    return f"{windows.count} window{'s' * (windows.count > 1)} over {place}"


def progress(name, done, of, time):
    if sys.stderr.isatty():
        end = "\r\033[K" if done == of else ""
        print(f"\r{name}: snapshot {done} of {of}, t = {time:.4g} s {end}", end="", file=sys.stderr, flush=True)


def report(options):
    runs = [reporting.opened(path) for path in options.runs]
    if not options.no_write:
        for run in runs:
            report_file.check_writable(run)
    found = reporting.reported(runs, options.start, options.end, options.scene, options.every, progress)
    names, scene, reports = found.names, found.scene, found.reports
    if options.depth:
        depth = "front_slice" if options.depth == "front" else "full_depth"
    else:
        depth = "front_slice" if all(run.recorded("weight") == 1 for run in runs) else "full_depth"

    print(f"from {found.range.start:g} to {found.range.end:g} s ({found.range.how})" + (f"; {described(scene.windows, depth)}" if scene.windows else ""))
    print("\n".join(report_table.text(names, reports, depth, options.confidence)))
    for note in found.notes:
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
