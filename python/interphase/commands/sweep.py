# SPDX-License-Identifier: GPL-3.0-or-later
"""Run a case for every combination of settings, methods and seeds, and put what they measured into a table and a figure.

Runs that are there are kept, those that were stopped go on from their checkpoints, the others are made, as many at a time as there are cores for.
The same command again does what is missing.
"""

import fcntl
import os
import shutil
import sys

from interphase import case_folder, exits, launch, sweep_plan, sweep_runs
from interphase.command_line import Parser, count, end_time, time
from interphase.commands import run as tools_run
from interphase.input_error import InputError
from interphase.missing import module
from interphase.run_folder import check_folder
from interphase.sweep_runs import DONE, GO_ON, HOLE, NEW, RUNNING
from interphase.tree import CASES, REPOSITORY

EXAMPLES = """examples:
  tools/sweep cases/sscp1 --set inletVelocity=1,2,3 --method CGHS,MPPIC --seeds 3 --until 2 --after 1
  tools/sweep cases/packed-bed --set inletVelocity=0.5,1 --set dragLaw=BVK,Ergun --quantity pressure_drop
  tools/sweep cases/sscp1 --weight 8,27 --set mapping/width=0.01,0.02 --ranks 2 --jobs 1 --out runs/width

--set is that of tools/run, with a list of values; one value is the same for all runs. A list of OpenFOAM, (15 1 45), is one value.

--seeds N makes N runs of each combination, with `seed` 1 ... N in the case's `parameters`, from which its `prepare` draws the
places of the particles at the start. A case without that entry is refused: its runs would be one run. Two runs that are equal
to the last bit count once.

A --quantity that the runs do not record is refused by the first run that records anything; the runs that go end then, and can go on.

The mean is that over the rows of /series from --after on, and over the runs of different seeds. Its standard error is the
larger one of two: by the scatter of the runs' means, and by each run's own error, autocorrelation taken in. `?` says that the
error is not to be trusted; the reasons follow the table. Quantities that are constant in all runs are in sweep.csv only.

A run that fails is a hole in table and figure, told with its cause; the others go on. It is tried again with --retry: from its last
checkpoint where the disk was full or it was killed, else from the start.

Ctrl-C (SIGINT) and SIGTERM end all runs after the gas step in progress, each with a checkpoint; a second one ends them at once.

The folder of --out then holds a folder for each run, as of tools/run without picture, sweep.csv, sweep.png and sweep.json.

exit code: 0 where all runs are there; 1 where some failed; 130 where it was stopped; 2 where the command line is refused, before anything runs."""


def arguments():
    parser = Parser("tools/sweep", "CASE", description=__doc__, epilog=EXAMPLES)
    parser.add_argument("case", metavar="CASE", help="a case folder, such as cases/sscp1")
    parser.add_argument("--set", metavar="NAME=V,V,...", action="append", default=[], dest="settings", help="values of an entry; may be given again")
    parser.add_argument("--method", metavar="M,M,...", help="collision methods, as of tools/run (default: the case's)")
    parser.add_argument("--weight", metavar="W,W,...", help="real particles per parcel (default: the case's; DEM and TDHS: 1)")
    parser.add_argument("--seeds", metavar="N", type=count, help="runs of each combination, each from another start")
    parser.add_argument("--until", metavar="T", type=end_time, help="simulated time to end at, in s (default: the case's)")
    parser.add_argument("--after", metavar="T", type=time, help="average from this time on, in s (default: the later half of each run)")
    parser.add_argument("--quantity", metavar="Q,Q,...", help="series to show, such as pressure_drop (default: all that vary)")
    parser.add_argument("--ranks", metavar="N", type=count, default=1, help="MPI ranks of each run (default 1)")
    parser.add_argument("--jobs", metavar="N", type=count, help="runs at a time; ranks times jobs are at most the cores (default: as many as go)")
    parser.add_argument("--retry", action="store_true", help="try again what has failed")
    parser.add_argument("--out", metavar="DIR", help="folder of the sweep (default: runs/sweep-<case>)")
    given = parser.parse_args()
    given.quantity = given.quantity and sweep_plan.listed(given.quantity)
    return given


def say(text):
    """On standard output, as long as somebody reads it."""
    try:
        print(text, flush=True)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def jobs_of(given):
    cores = launch.cores()
    most = cores // given.ranks
    if given.jobs is None:
        if not most:
            raise InputError(f"--ranks {given.ranks}: there are {cores} cores here; take fewer ranks")
        return most
    if given.jobs > most:
        raise InputError(f"--jobs {given.jobs} of {given.ranks} ranks: there are {cores} cores here; take fewer")
    return given.jobs


def locked(folder):
    """A lock on the folder, for as long as the file is open: two sweeps would run the same."""
    lock = open(os.path.join(folder, ".lock"), "w", encoding="utf-8")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise InputError(f"{folder}: another tools/sweep is at work there; wait for it, or give another folder by --out DIR") from None
    return lock


def report(sweep, given, name):
    """Table, sweep.csv and sweep.png of what has ended."""
    table = module("sweep_table")
    result = table.measure(sweep, given.after, given.quantity)
    part = "the later half of each run" if given.after is None else f"t >= {given.after:g} s"
    say(f"\n{name}, means over {part} +- standard error\n")
    say("\n".join(table.lines(result, shutil.get_terminal_size((150, 24)).columns)))
    for remark in result.remarks:
        say(f"? {remark}")
    for point in sweep.points:
        if sweep.stand[point.name] == HOLE:
            say(f"failed: {point.name}: {sweep_runs.short(sweep.notes.holes[point.key])}")
    written = [os.path.join(sweep.folder, "sweep.csv")]
    table.write_csv(written[0], result, given.after)
    picture = os.path.join(sweep.folder, "sweep.png")
    if result.quantities:
        written.append(picture)
        module("sweep_figure").draw(picture, result, f"{name}, {part}, bars: one standard error")
    elif os.path.exists(picture):
        os.remove(picture)  # it shows what an earlier call was asked for
    say("\n" + "  ".join(written))


def main():
    given = arguments()
    lists = {name: text and sweep_plan.listed(text) for name, text in (("method", given.method), ("weight", given.weight))}
    case = case_folder.checked_case(given.case, CASES)
    points = sweep_plan.plan(case, sweep_plan.settings(given.settings), lists["method"], lists["weight"], given.seeds, given.until)
    if given.after is not None and given.after >= min(point.until for point in points):
        raise InputError(f"--after {given.after:g}: the runs end at {min(point.until for point in points):g} s")
    jobs = jobs_of(given)
    name = os.path.basename(case)
    folder = os.path.abspath(given.out or os.path.join(REPOSITORY, "runs", f"sweep-{name}"))
    check_folder(os.path.join(folder, points[0].name), case, overwrite=True)
    digest = sweep_plan.digest(case)
    os.makedirs(folder, exist_ok=True)
    with locked(folder):
        points = sweep_plan.placed(points, folder)
        sweep = sweep_runs.Sweep(points, folder, sweep_runs.Notes(folder, case, digest), given.ranks, jobs, given.retry, say, given.quantity)
        sweep.notes.write()
        counts = ", ".join(f"{sweep.count(stand)} {stand}" for stand in (DONE, RUNNING, GO_ON, NEW, HOLE) if sweep.count(stand))
        whole = True
        with sweep.listening():
            say(f"{len(points)} runs of {name} in {folder}: {counts}; {jobs} at a time")
            if sweep.count(NEW, GO_ON, RUNNING):
                os.environ["INTERPHASE_BIN"] = tools_run.program(quiet=False)  # once, before several at a time would
                if jobs > 1:
                    # Each mpirun would bind its ranks to the same first cores.
                    os.environ.setdefault("OMPI_MCA_hwloc_base_binding_policy", "none")
                whole = sweep.go()
        report(sweep, given, name)
        if not whole:
            print(f"tools/sweep: stopped; {sweep.count(NEW, GO_ON)} runs are not at their end. The same command goes on", file=sys.stderr)
            return 130
        if sweep.count(HOLE):
            print(f"tools/sweep: {sweep.count(HOLE)} of {len(points)} runs failed; --retry tries them again", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    exits.after(main, "tools/sweep", "sweep's folder")
