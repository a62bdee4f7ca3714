# SPDX-License-Identifier: GPL-3.0-or-later
"""Statistics of one or several runs over the same simulated time, side by side: profiles, overlaps, voidage, pressure."""

import os
import sys

from interphase import replicates, report_figure, report_file, report_keys, report_output, report_table, reporting, run_account, run_sheet, trades_of_runs
from interphase.command_line import Parser, check_order, count, share, time
from interphase.input_error import InputError

DETAILS = """Any run will do, of any vessel and length. x goes across, y is the depth from the front wall on, z is up.
Start-up is left out: what comes before --from, else before `from` of the block `statistics`, else the time that MSER-5
finds in /series (pressure drop, bed height, kinetic energy, vertical velocity, number of particles; the latest of
them). Where a record is too short to tell, its latter half is shown, and no mean of it is trusted. What is measured where is
the vessel's (the box about the gas mesh, else about all spheres) unless `statistics` of system/couplingDict says otherwise.
From the rows of /statistics, which a run takes itself where statistics.interval is set (no snapshot is read then), else
from the snapshots of particles.h5:

  velocity               mean of all real particles in a window (those of a sphere whose centre is in it), counted as
                         often as they are seen there
  granular temperature   (Theta_x + Theta_z)/3, Theta_x = 1/N sum (v_x - mean)^2 in a window, averaged over the
                         snapshots with two spheres or more, N real particles
  overlaps               of all pairs of spheres that overlap, over the diameter of the smaller one; not with walls
  voidage                from snapshots: of every cell of a uniform box mesh, the spheres' volume where it lies (a sphere that
                         reaches into several cells is divided by 64 points); the mapping of the run plays no part
  mapped voidage         from rows: of every cell of the gas's mesh, as the gas has it, spread by the mapping

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

keys of the block `statistics` of system/couplingDict (none has to be there; see cases/sscp1; an older case's
system/reportDict, with the same keys, is read where there is no such block):

@KEYS@

examples:
  tools/report runs/sscp1-CGPM-w8
  tools/report runs/sscp1-DEM-w1 runs/sscp1-CGPM-w8 --from 10
  tools/report runs/sscp1-CGPM-w8 --from 0.5 --no-write --out start-up.png""".replace("@KEYS@", "\n".join(report_keys.described()))


def arguments(given):
    parser = Parser("tools/report", "RUN [RUN ...]", description=__doc__, epilog=DETAILS)
    parser.add_argument("runs", metavar="RUN", nargs="+", help="a run's folder, with results.h5 and particles.h5; or a folder that --store has written")
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
    parser.add_argument("--html", metavar="FILE.html", help="a page of all of it, pictures inside; the first RUN is what the others are held against")
    parser.add_argument("--store", metavar="DIR", help="keep what the page is made of as a text file for each run, some 50 kB: `tools/report DIR` needs no run")
    parser.add_argument("--trades", metavar="FILE.csv", help="keep how far each run lies off the reference as evidence for tools/plan, which reads each trades.csv in cases/*/study")
    parser.add_argument("--reference", metavar="NAME", help="the run that the others are held against (default: the first; of a stored folder, DEM or TDHS)")
    parser.add_argument("--depth", choices=("front", "full"), help="the windows to show (default: see below)")
    parser.add_argument("--every", metavar="N", type=count, default=1, help="read each N-th snapshot only, and no rows (default: 1)")
    parser.add_argument("--own-time", action="store_true", help="each run to its own end, not to the shortest one's; nothing is written into the runs then")
    parser.add_argument("--pool", action="store_true", help="runs that differ in where they begin only (seed, packing, --from) as one record, errors by their scatter where that is more; each run to its own end")
    parser.add_argument("--scene", metavar="FILE", help="what to measure of snapshots, instead of what the runs' `statistics` say; same keys")
    parser.add_argument("--snapshots", action="store_true", help="measure snapshots, also where a run has rows of /statistics")
    parser.add_argument(
        "--confidence", metavar="C", type=share, default=0.95,
        help="of `agree` and `differ`, between 0 and 1 (default: 0.95)",
    )
    parser.add_argument(
        "--no-write", action="store_true", help="leave the runs' files alone; works on a run that is still going, too"
    )
    options = parser.parse_args(given)
    check_order(options.start, options.end)
    options.own_time = options.own_time or options.pool
    if options.own_time and options.end is not None:
        raise InputError(f"{'--pool' if options.pool else '--own-time'} and --until: each run goes to its own end, or all to one; give one of them")
    if options.html:
        report_output.check_name(options.html, "--html")
    if options.trades and not options.trades.endswith(".csv"):
        raise InputError(f"--trades {options.trades}: give a name that ends with .csv")
    if options.store and os.path.exists(options.store) and not os.path.isdir(options.store):
        raise InputError(f"--store {options.store}: is a file; give a folder")
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


def measured(options):
    """([`Sheet`], {name: folder}, notes) of runs; their files get the numbers unless --no-write."""
    runs = [reporting.opened(path) for path in options.runs]
    if not options.no_write and not options.own_time:
        for run in runs:
            report_file.check_writable(run)
    if options.own_time:
        groups = [[run] for run in runs]
        if options.pool:
            groups = [[runs[at] for at in some] for some in replicates.alike([run_account.of_run(run) for run in runs])]
            if len(groups) == len(runs):
                raise InputError("--pool: no two of the runs are alike in all but seed, packing and the bed that they begin with; leave it out")
        sheets, notes = run_sheet.each_over_its_own_time(groups, [options.start] * len(groups), options.scene, options.every, progress, options.snapshots)
        return sheets, {sheet.name: some[0].path for sheet, some in zip(sheets, groups)}, notes
    found = reporting.reported(runs, options.start, options.end, options.scene, options.every, progress, options.snapshots)
    notes = found.notes + [f"{name}: {start}" for name, run in zip(found.names, runs) if (start := started_from(run))]
    if not options.no_write:
        for run, each in zip(runs, found.reports):
            report_file.write(run, found.scene, each)
            print(f"numbers    {run.results} (/profiles, /histograms)")
    return run_sheet.of_reported(runs, found), {name: run.path for name, run in zip(found.names, runs)}, notes


def kept(options):
    """The same of folders that --store has written."""
    others = [path for path in options.runs if not report_output.is_stored(path)]
    if others:
        raise InputError(f"{others[0]} is no folder that --store has written, and others are: give runs, or stored folders, not both")
    for option, given in (("--from", options.start is not None), ("--until", options.end is not None), ("--pool", options.pool), ("--scene", options.scene), ("--store", options.store),
                          ("--snapshots", options.snapshots)):
        if given:
            raise InputError(f"{option}: what is stored has been measured already; give the runs themselves")
    return report_output.stored(options.runs), {}, []


def report(options):
    of_stored = any(map(report_output.is_stored, options.runs))
    sheets, folders, notes = kept(options) if of_stored else measured(options)
    if not of_stored and (options.store or options.trades):
        sheets = trades_of_runs.with_likeness(sheets, folders)
    sheets = report_output.with_reference(sheets, options.reference)
    names, reports, scene = [sheet.name for sheet in sheets], [sheet.report for sheet in sheets], sheets[0].scene
    if options.depth:
        depth = "front_slice" if options.depth == "front" else "full_depth"
    else:
        depth = report_output.depth_of(sheets)

    first = sheets[0]
    print(f"from {first.start:g} to {first.end:g} s ({first.how})" + (f"; {described(scene.windows, depth)}" if scene.windows else ""))
    print("\n".join(report_table.text(names, reports, depth, options.confidence)))
    for note in notes:
        print(f"note: {note}")
    for name, each in zip(names, reports):
        for note in each.notes:
            print(f"note: {name}: {note}")
    figure = options.out or (None if options.no_write or options.own_time or of_stored else os.path.join(folders[names[0]], "report.png"))
    if figure:
        report_figure.draw(figure, names, reports, depth, scene)
        print(f"figure     {figure}")
    if options.store:
        for path in run_sheet.store(options.store, sheets):
            print(f"stored     {path}")
    if options.trades:
        trades = trades_of_runs.trades_of(sheets, depth)
        trades_of_runs.write(options.trades, trades)
        print(f"trades     {options.trades}: {len(trades)} lines")
        if unplaced := [sheet.name for sheet in sheets[1:] if not trades_of_runs.is_placed(sheet)]:
            print(f"note: {', '.join(unplaced)}: no evidence, as gas, mesh, weight or velocity there are not known, by which a scene is told to be near")
    if options.html:
        report_output.write(options.html, report_output.title_of(sheets), sheets, depth, notes, folders, options.confidence)
        print(f"page       {options.html}")


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
