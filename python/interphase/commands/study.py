# SPDX-License-Identifier: GPL-3.0-or-later
"""Make the runs of a study, methods and numerical parameters on one case, and a page of what they measured and cost.

What is missing is run: runs that were stopped go on from their checkpoints, the others are made. The same command again does the rest.
"""

import os
import sys

from interphase import exits, run_sheet, study_file, study_plan, sweep_plan, sweep_runs
from interphase.command_line import Parser, count
from interphase.commands import run as tools_run
from interphase.commands import sweep as tools_sweep
from interphase.input_error import InputError
from interphase.missing import module
from interphase.sweep_runs import DONE, GO_ON, HOLE, NEW, RUNNING
from interphase.tree import REPOSITORY

DETAILS = """the file, in OpenFOAM syntax; cases/sscp1-slice/study/study is one:

  case       "..";
  until      30;
  rows
  {
      DEM      { methods (DEM); }
      parcels  { methods (CGPM CGHS MPPIC); weights (8 27); }
      steps    { methods (CGHS); weights (8); solidSteps (0.5 2); until 10; }
  }

A row is the product of its lists; the keys of a row may stand in the file, too, for all rows. All of them:

@KEYS@

With `developed` a run of TDHS (W = 1) and one of CGHS (each other W) go to its `time` first, with the settings that all rows have alike but for the solid step;
all runs of that W start with their particles and gas, and their clocks at 0. With startTimes one bed gives several starts: replicates of a method that is too dear to run long, which the page takes as one record in pieces.

The folder of --out then holds a folder for each run, as of tools/run without picture, and report.html. What was made by another version of the program, or
with other settings, is told and left as it is: --anew puts it aside and runs it again.

--store DIR keeps what the page is made of, some 50 kB for each run; --from-stored DIR makes the page of that, without any run.

Ctrl-C (SIGINT) and SIGTERM end all runs after the gas step in progress, each with a checkpoint. A run that fails is told with its cause; the others go on.

exit code: 0 where all runs are there; 1 where some failed; 130 where it was stopped; 2 where it is refused, before anything runs.

examples:
  tools/study cases/sscp1-slice/study/study --dry-run
  tools/study cases/periodic-duct/study/study --out runs/duct
  tools/study cases/sscp1-slice/study/study --from-stored cases/sscp1-slice/study --html slice.html""".replace("@KEYS@", "\n".join(study_file.described()))


def arguments():
    parser = Parser("tools/study", "FILE", description=__doc__, epilog=DETAILS)
    parser.add_argument("file", metavar="FILE", help="the study")
    parser.add_argument("--dry-run", action="store_true", help="print the runs, no more")
    parser.add_argument("--ranks", metavar="N", type=count, default=1, help="MPI ranks of each run (default 1)")
    parser.add_argument("--jobs", metavar="N", type=count, help="runs at a time; ranks times jobs are at most the cores (default: as many as go)")
    parser.add_argument("--retry", action="store_true", help="try again what has failed")
    parser.add_argument("--anew", action="store_true", help="make again what is of another version or of other settings; the old folder is kept beside")
    parser.add_argument("--out", metavar="DIR", help="folder of the study (default: runs/study-<case>)")
    parser.add_argument("--html", metavar="FILE.html", help="the page (default: report.html in the folder of the study)")
    parser.add_argument("--store", metavar="DIR", help="keep what was measured as small text files")
    parser.add_argument("--from-stored", metavar="DIR", dest="stored", help="make the page of what --store has kept")
    given = parser.parse_args()
    if given.stored and (given.store or given.dry_run or given.anew or given.retry):
        raise InputError("--from-stored makes the page alone: leave --store, --dry-run, --anew and --retry away")
    return given


def matrix(plan, folder):
    """Lines: each run with what is particular to it."""
    tables = module("tables")
    rows = [["run", "method", "W", "until [s]", "gas steps", "settings", "starts from", "folder"]]
    for point in [*plan.beds, *plan.points]:
        steps = study_plan.steps(point)
        settings = " ".join(f"{name}={text}" for name, text in point.case.settings.items())
        there = sweep_runs.reached(os.path.join(folder, point.name))
        rows.append([point.name, point.case.method, f"{point.case.weight:g}", f"{point.until:g}", "-" if steps is None else f"{steps:,}", settings or "-",
                     os.path.basename(point.start) if point.start else "-", f"t = {there:g} s" if there else "new"])  # fmt: skip
    return tables.columns(rows)


def put_aside(points, folder, commit, anew):
    """Tell what is not the run that is asked for; with `anew` out of the way. Returns whether all may be used."""
    usable = True
    for point in points:
        path = os.path.join(folder, point.name)
        why = study_plan.unlike(point, path, commit)
        if not why:
            continue
        if anew:
            number = next(n for n in range(1, 10**6) if not os.path.exists(f"{path}.before-{n}"))
            os.rename(path, f"{path}.before-{number}")
            tools_sweep.say(f"anew     {point.name}: {why}; it is kept as {point.name}.before-{number}")
        else:
            fits = why != study_plan.OTHER_SETTINGS
            usable = usable and fits
            tools_sweep.say(f"{'note    ' if fits else 'refused '} {point.name}: {why}; --anew makes it again, the old one stays beside")
    return usable


def made(points, folder, notes, given, jobs):
    """(the Sweep of `points` after what could be run has run, whether it was not stopped)."""
    sweep = sweep_runs.Sweep(points, folder, notes, given.ranks, jobs, given.retry, tools_sweep.say)
    notes.write()
    with sweep.listening():
        counts = ", ".join(f"{sweep.count(stand)} {stand}" for stand in (DONE, RUNNING, GO_ON, NEW, HOLE) if sweep.count(stand))
        tools_sweep.say(f"{len(points)} runs in {folder}: {counts}; {jobs} at a time")
        if sweep.count(NEW, GO_ON, RUNNING) and jobs > 1:
            os.environ.setdefault("OMPI_MCA_hwloc_base_binding_policy", "none")  # each mpirun would bind its ranks to the same cores
        return sweep, sweep.go() if sweep.count(NEW, GO_ON, RUNNING) else True


def page(study, sheets, folders, notes, path):
    """The page of the study, and the table of its distances."""
    output, trade = module("report_output"), module("trade")
    named = study.reference
    if named is None or named not in [sheet.name for sheet in sheets]:
        if named is not None:
            notes.append(f"the reference {named} is not there: the others are held against another run")
        order = [*output.FIRST_OF, *{sheet.account.method for sheet in sheets}]
        named = min(sheets, key=lambda sheet: order.index(sheet.account.method)).name
    sheets = output.with_reference(sheets, named)
    check_quantities(study, sheets)
    output.write(path, output.title_of(sheets), sheets, output.depth_of(sheets), notes, folders, counted=study.quantities and named_quantities(study))
    depth = output.depth_of(sheets)
    for sheet in sheets[1:]:
        far = trade.overall(trade.distances(sheets[0].report, sheet.report, depth, study.quantities and named_quantities(study)))
        tools_sweep.say(f"{sheet.name}: distance to {named} {module('report_page').distance_words(far)}")
    tools_sweep.say(f"page       {path}")


def named_quantities(study):
    """As the page names them: `pressure_drop` is `pressure drop`."""
    return [name.replace("_", " ") for name in study.quantities]


def check_quantities(study, sheets):
    """InputError for a quantity that none of the runs has."""
    there = module("trade").quantities(sheets[0].report, module("report_output").depth_of(sheets))
    for name in named_quantities(study) if study.quantities else ():
        if name not in there:
            raise InputError(f"{study.path}: quantities: {name.replace(' ', '_')} is not measured: " + study_file.foam_file.nearest(
                name.replace(" ", "_"), [each.replace(" ", "_").replace(",", "") for each in there]))  # fmt: skip


def of_stored(study, given):
    output = module("report_output")
    if not output.is_stored(given.stored):
        raise InputError(f"--from-stored {given.stored}: holds nothing that --store has kept (NAME{run_sheet.END})")
    page(study, output.stored([given.stored]), None, [], given.html or os.path.join(given.stored, "report.html"))


def main():
    given = arguments()
    study = study_file.read(given.file)
    if given.html:
        module("report_output").check_name(given.html, "--html")
    if given.stored:
        of_stored(study, given)
        return 0
    folder = os.path.abspath(given.out or os.path.join(REPOSITORY, "runs", f"study-{os.path.basename(study.case)}"))
    plan = study_plan.of(study, folder)
    study_plan.check_windows(study)
    for point in plan.points:
        start = plan.starts[point.name]
        if start is not None and start >= point.until:
            raise InputError(f"{study.path}: {point.name} ends at {point.until:g} s, before from = {start:g} s")
    jobs = tools_sweep.jobs_of(given)
    if given.dry_run:
        print("\n".join(matrix(plan, folder)))
        return 0
    tools_run.check_folder(os.path.join(folder, plan.points[0].name), study.case, overwrite=True)
    digest = sweep_plan.digest(study.case)
    os.makedirs(folder, exist_ok=True)
    with tools_sweep.locked(folder):
        notes = sweep_runs.Notes(folder, study.case, digest)
        binary = os.environ["INTERPHASE_BIN"] = tools_run.program(quiet=False)
        study_plan.check_plugins(study, plan, binary)
        if not put_aside([*plan.beds, *plan.points], folder, study_plan.version_of(binary), given.anew):
            raise InputError(f"{folder} holds runs of other settings under the names of this study: --anew, or another folder by --out DIR")
        sweeps, whole = [], True
        for points in (plan.beds, plan.points):
            ready = [point for point in points if point.start is None or _bed_is_there(point)]
            lost = [point for point in points if point not in ready]
            if ready and whole:
                sweep, whole = made(ready, folder, notes, given, jobs)
                sweeps.append(sweep)
            for point in lost if whole else ():
                tools_sweep.say(f"not run  {point.name}: the bed that it starts from is not there")
        failed = sum(sweep.count(HOLE) for sweep in sweeps) + len(lost)
        measure(study, plan, folder, sweeps, given)
    if not whole:
        print("tools/study: stopped; the same command goes on", file=sys.stderr)
        return 130
    if failed:
        print(f"tools/study: {failed} runs failed or could not start; --retry tries them again", file=sys.stderr)
    return 1 if failed else 0


def _bed_is_there(point):
    try:
        module("starting_run").find(point.start)
    except InputError:
        return False
    return True


def measure(study, plan, folder, sweeps, given):
    """Page and stored text of what has ended."""
    done = [point for sweep in sweeps for point in sweep.points if sweep.stand[point.name] == DONE and point.name in plan.starts]
    if not done:
        tools_sweep.say("no run has ended: there is nothing to measure yet")
        return
    reporting = module("reporting")
    together = {}
    for point in done:
        together.setdefault(plan.pieces_of[point.name], []).append(point.name)
    groups = [[reporting.opened(os.path.join(folder, name)) for name in names] for names in together.values()]
    sheets, notes = run_sheet.each_over_its_own_time(groups, [plan.starts[names[0]] for names in together.values()], names=list(together))
    missing = [name for name in plan.starts if name not in {point.name for point in done}]
    notes += [f"not there: {', '.join(missing)}"] if missing else []
    folders = {sheet.name: runs[0].path for sheet, runs in zip(sheets, groups)}
    if given.store:
        for path in run_sheet.store(given.store, module("trades_of_runs").with_likeness(sheets, folders)):
            tools_sweep.say(f"stored     {path}")
    page(study, sheets, folders, notes, given.html or os.path.join(folder, "report.html"))


if __name__ == "__main__":
    exits.after(main, "tools/study", "study's folder")
