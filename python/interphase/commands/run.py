# SPDX-License-Identifier: GPL-3.0-or-later
"""Set up, prepare and run a case of interphase, from a fresh machine to the picture.

The case is copied into a folder of its own and changed there only. Nothing beyond Python's standard library
is needed to start: tools/setup installs the rest.
"""

import argparse
import os
import shutil
import signal
import subprocess
import sys
import time

from interphase import case_folder, earlier_run, ending, exits, launch, mesh_choice, parts, run_state, until_error
from interphase.case_folder import CONTROL, COUPLING, PARAMETERS
from interphase.input_error import InputError
from interphase.missing import words_on
from interphase.run_folder import check_folder, default_folder
from interphase.tree import CASES, REPOSITORY, TOOLS, with_package


EXAMPLES = """examples:
  tools/run cases/sscp1
  tools/run cases/sscp1 --method DEM --ranks 2 --until 0.5 --set inletVelocity=3.28
  tools/run cases/sscp1 --set system/couplingDict:drag/law=Gidaspow --out runs/gidaspow
  tools/run cases/sscp1 --set mapping/width=0.02 --set 'forces=(virtualMass)'
  tools/run cases/sscp1 --out runs/gidaspow --resume --until 2
  tools/run cases/sscp1 --until 60 --until-error "pressure_drop 2%" --until-error "bed_height 0.005 m"
  tools/run cases/sscp1 --method CGHS --weight 8 --from runs/sscp1-CGPM-w8@0.7 --set inletVelocity=3.28

--set names an entry of the case's file `parameters`, one of system/couplingDict (mapping/width), or FILE:ENTRY of any other file in
OpenFOAM syntax, nested by '/'. Entries of couplingDict that a case does not mention are added where the program knows them
(`interphase -help keys`); all others are replaced, never added: what a case does not mention, add to its file first.

--from takes the particles of another run of the same weight, at the time of one of its snapshots, in place of those in the file that the
case's script reads (`read_data`), and its gas where fields were written then: the same mesh takes the values of the cells, another mesh of the
same vessel takes them interpolated. Inlets, walls and all other settings are the case's; the clock begins at 0. Springs of contacts, remembered
impulses and the gas's earlier steps are not taken: --resume is for runs that go on as they were.

The mesh is the case's constant/polyMesh where there is one, as it is; else blockMesh makes it of system/blockMeshDict or
constant/polyMesh/blockMeshDict. Which, is told.

The run's folder then holds results.h5, particles.h5 and particles.xdmf, the gas in OpenFOAM's time folders,
log.* of every program, and bed.png. The command line of the program is printed: on the prepared folder it does
the same without tools/run, under mpirun, srun or your own script.

environment:
  INTERPHASE_BIN   run this executable and set nothing up
  INTERPHASE_PLUGIN_PATH   folders with plug-ins, separated by ':'
  WM_PROJECT_DIR   the OpenFOAM to use (default: Debian's, /usr/share/openfoam)

Ctrl-C (SIGINT) and SIGTERM end the run after the gas step in progress, with gas, checkpoint, summary and picture; a
second one ends it at once. SIGUSR1 to the program, or `touch DIR/checkpoint`, writes a checkpoint.

exit code: the program's (0 only when the run reached its end; tools/CLUSTERS.md has the table); 2 where the command line
or the case is refused; 1 where a step before the program fails."""


def arguments():
    parser = argparse.ArgumentParser(
        prog="tools/run", description="Install and build what is missing, then run a case and draw its bed.",
        epilog=EXAMPLES, formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("case", metavar="CASE", nargs="?", help="a case folder, such as cases/sscp1")
    parser.add_argument("--method", help="collision method: DEM, CGPM, TDHS, CGHS, MPPIC, or one that a plug-in of the case brings (default: the case's)")
    parser.add_argument("--weight", metavar="W", help="real particles per parcel, 1 for DEM and TDHS (default: the case's)")
    parser.add_argument("--ranks", metavar="N", type=int, help="MPI ranks (default: 1)")
    parser.add_argument("--until", metavar="T", help="simulated time to end at, in s (default: the case's)")
    parser.add_argument(
        "--set", metavar="KEY=VALUE", action="append", default=[], dest="settings",
        help="change an entry of `parameters`, or of the coupling, or FILE:ENTRY=VALUE; may be given again",
    )
    parser.add_argument("--out", metavar="DIR", help="the run's folder (default: runs/<case>-<method>-w<weight>[-<N>ranks])")
    parser.add_argument("--overwrite", action="store_true", help="replace an earlier run in the run's folder")
    parser.add_argument(
        "--resume", action="store_true",
        help="go on from the newest whole checkpoint in the run's folder, to --until where that is given, on as many ranks or "
        "on --ranks",
    )
    parser.add_argument(
        "--wall-limit", metavar="S", dest="wall_limit",
        help="end, with a checkpoint from which --resume goes on, before the run has taken S seconds of wall time",
    )
    parser.add_argument(
        "--until-error", metavar='"NAME E"', action="append", default=[], dest="until_error",
        help="end the run as soon as the mean of a series of /series, start-up left out, has a standard error of E at most (95 %% bars: 2.0 to 2.3 of "
        'them): "pressure_drop 2%%", "bed_height 0.002 m"; may be given again, then all must be reached; --until ends it all the same',
    )
    parser.add_argument(
        "--from", metavar="RUN[@T]", dest="start",
        help="start with the bed and gas that the run in the folder RUN had at T s (default: its last snapshot)",
    )
    parser.add_argument("--no-picture", action="store_true", help="draw no bed.png")
    parser.add_argument("--quiet", action="store_true", help="print errors only; the program's output is in its log")
    given = parser.parse_args()
    if given.case is None:
        raise InputError(f"which case? Usage: tools/run CASE (see --help); {case_folder.listing(CASES)}")
    if given.ranks is not None and given.ranks < 1:
        raise InputError(f"--ranks {given.ranks}: at least one rank is needed")
    if given.wall_limit is not None and not is_time(given.wall_limit):
        raise InputError(f"--wall-limit {given.wall_limit}: give the seconds that the run may take, above 0")
    given.until_error = [until_error.target(text) for text in given.until_error]
    for option, there in (("--overwrite", given.overwrite), ("--set", given.settings), ("--from", given.start)):
        if given.resume and there:
            raise InputError(f"--resume and {option}: a run goes on as it is; leave one of them away")
    return given


def is_time(words):
    """Whether `words` are a number above 0, and no endless one."""
    try:
        return 0 < float(words) < float("inf")
    except ValueError:
        return False


def split_setting(case, setting):
    """`file:entry=value` -> (file, entry, value); where no file is named, it is `parameters`, or couplingDict for what stands there."""
    left, equals, value = setting.partition("=")
    left = left.strip()
    if not equals or not left:
        raise InputError(f"--set {setting}: give KEY=VALUE or FILE:ENTRY=VALUE")
    try:
        return (*case.place_of(left), value)
    except InputError as error:
        raise InputError(f"--set {setting}: {error}") from None


def apply_settings(case, given):
    """Write --set, --method, --weight and --until into the case's dictionaries; returns (method, weight).

    Method and weight end up the same whether they came by --set or by their own option.
    """
    chosen = {"method": given.method, "weight": given.weight, "until": given.until}
    by_option = {(PARAMETERS, "method"): "method", (COUPLING, "method"): "method", (CONTROL, "endTime"): "until",
                 (PARAMETERS, "weight"): "weight", (COUPLING, "weight"): "weight"}
    for setting in given.settings:
        file, entry, value = split_setting(case, setting)
        option = by_option.get((file, entry))
        if option:
            if chosen[option] not in (None, value.strip()):
                raise InputError(f"--set {setting} contradicts --{option} {chosen[option]}: give one of them")
            chosen[option] = value.strip()
            continue
        try:
            case.set(file, entry, value)
        except InputError as error:
            raise InputError(f"--set {setting}: {error}") from None
    if chosen["until"] is not None:
        if not is_time(chosen["until"]):
            raise InputError(f"--until {chosen['until']}: give a time in s, above 0")
        case.set_at_source(CONTROL, "endTime", chosen["until"])
    return case_folder.set_method_and_weight(case, chosen["method"], chosen["weight"])


def program(quiet):
    """The path of the interphase executable, set up and built where it is missing."""
    chosen = os.environ.get("INTERPHASE_BIN")
    if chosen:
        found = shutil.which(chosen)
        if found is None:
            raise InputError(f"INTERPHASE_BIN={chosen} is no executable file")
        return os.path.abspath(found)
    setup = os.path.join(TOOLS, "setup")
    # With --quiet what it prints is shown only if it fails.
    capture = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT} if quiet else {}
    done = subprocess.run([setup], **capture)
    if done.returncode != 0:
        sys.stderr.buffer.write(done.stdout or b"")
        raise launch.StepFailed(f"tools/setup failed {launch.how_it_ended(done.returncode)}; what it lacks stands above")
    built = os.path.join(REPOSITORY, "build", "release", "interphase")
    if not os.access(built, os.X_OK):
        raise launch.StepFailed(f"tools/setup ended well, but there is no executable {built}")
    return built


def start_of(given, case, name, method, weight, folder):
    """The run and time that --from names, checked against the case; None without it."""
    if given.start is None:
        return None
    try:
        from interphase import starting_point
    except ModuleNotFoundError as missing:
        raise InputError(f"--from: {words_on(missing)}") from None
    return starting_point.checked(given.start, case, name, method, weight, folder)


def prepare(case, folder, ranks, environment, say, begin=None):
    """Bring the copied case to where the program can start: scene, mesh, pieces for the ranks.

    `begin(gas)` is called before the pieces are cut.
    """
    gas = case.value(COUPLING, "gas/model", "pimple")
    step = steps(folder, environment, say)
    own = os.path.join(folder, "prepare")
    if os.access(own, os.X_OK):
        step(own)
    if gas != "none":
        mesher, told = mesh_choice.choose(folder, case.folder, gas)
        say(told)
        if mesher:
            step(mesher, "-case", folder)
    if begin is not None:
        begin(gas)
    parts.cut(folder, ranks, gas, step)
    return gas


def steps(folder, environment, say):
    """A function that runs one program of the way to the start."""
    def step(*command):
        name = os.path.basename(command[0])
        say(f"{name} ...")
        launch.step(list(command), os.path.join(folder, f"log.{name}"), environment, folder)

    return step


def finish(folder, name, gas, ranks, picture, environment, say):
    """Make the run easy to look at. The run itself is done: what fails here is told, no more."""
    def attempt(command, log):
        say(f"{os.path.basename(command[0])} ...")
        try:
            launch.step(command, os.path.join(folder, log), environment, folder)
        except launch.StepFailed as error:
            print(f"tools/run: warning: {error}", file=sys.stderr)

    if gas != "none":
        if ranks > 1 and parts.wrote_gas(folder):
            attempt(["reconstructPar", "-case", folder], "log.reconstructPar")
        with open(os.path.join(folder, f"{name}.foam"), "w", encoding="utf-8"):
            pass
    if picture:
        attempt([os.path.join(TOOLS, "picture"), folder], "log.picture")
    kinds = (("results", "results.h5"), ("particles", "particles.xdmf"), ("gas", f"{name}.foam"), ("picture", "bed.png"))
    for what, file in kinds:
        if os.path.exists(os.path.join(folder, file)):
            say(f"{what:<10} {os.path.join(folder, file)}")


def main():
    given = arguments()
    say = (lambda _: None) if given.quiet else (lambda text: print(text, flush=True))

    # Everything that can be refused is refused before anything is installed, built or written.
    case_path = case_folder.checked_case(given.case, CASES)
    case = case_folder.Dictionaries(case_path)
    method, weight = apply_settings(case, given)
    mesh_choice.check_settings(case, [split_setting(case, setting)[:2] for setting in given.settings])
    case_folder.anchor_plugins(case)
    name = os.path.basename(case_path)
    folder = os.path.abspath(given.out or default_folder(case_path, method, weight, given.ranks or 1))
    earlier = earlier_run.record_of(folder, name) if given.resume else None
    if earlier is None:
        given.ranks = given.ranks or 1
        check_folder(folder, case_path, given.overwrite)
    start = start_of(given, case, name, method, weight, folder)
    given.ranks = given.ranks or earlier["ranks"]
    if given.ranks > 1:
        case_folder.set_number_of_subdomains(case, given.ranks)

    binary = program(given.quiet)
    variables = launch.additions(os.environ)
    environment = with_package({**os.environ, **variables, "PATH": TOOLS + os.pathsep + os.environ.get("PATH", os.defpath)})

    if earlier is not None:
        if given.until is not None:
            earlier_run.set_end(folder, given.until)
        gas = case_folder.Dictionaries(folder).value(COUPLING, "gas/model", "pimple")
        parts.cut_anew(folder, given.ranks, gas, steps(folder, environment, say),
                       lambda words: print(f"tools/run: warning: {words}", file=sys.stderr))
        command = [*launch.command(binary, folder, given.ranks), "-resume"]
        record = {**earlier, "ranks": given.ranks, "until": given.until or earlier["until"], "command": command, "environment": variables,
                  "source": case_path, "process": run_state.this_process()}
        for of_its_end in ("exit_code", "wall_time", "until_error"):
            record.pop(of_its_end, None)
        run_state.write(folder, record)  # a kill leaves the number of ranks that the folder is cut for
        return run(given, name, folder, gas, command, record, earlier_run.free_log(folder), variables, environment, say)

    if os.path.isdir(folder) and os.listdir(folder):
        say(f"replacing the earlier run in {folder}")
        shutil.rmtree(folder)
    os.makedirs(folder, exist_ok=True)
    command = launch.command(binary, folder, given.ranks)
    record = {"case": name, "source": case_path, "process": run_state.this_process(), "method": method, "weight": weight, "ranks": given.ranks,
              "settings": given.settings, "until": given.until, "command": command, "environment": variables}
    run_state.write(folder, record)
    case_folder.copy(case_path, folder)
    case.write_into(folder)
    say(f"{name}, {method}, weight {weight:g}, {given.ranks} rank{'s' * (given.ranks > 1)}, in {folder}")

    def begin(gas):
        from interphase import starting_point
        record["from"] = starting_point.put(start, folder, name, gas, environment, say)
        run_state.write(folder, record)

    gas = prepare(case, folder, given.ranks, environment, say, begin if start else None)

    log = os.path.join(folder, "log.interphase")
    return run(given, name, folder, gas, command, record, log, variables, environment, say)


def run(given, name, folder, gas, command, record, log, variables, environment, say):
    """The program on a prepared case, and what makes its run easy to look at; returns its exit code."""
    say(f"running\n  cd {folder}\n  {launch.as_typed(command, variables)}")
    if given.wall_limit is not None:
        command = [*command, "-wallLimit", given.wall_limit]
    started, before = time.time(), launch.cpu_of_children()
    passed_on = []
    watch = until_error.Watch(given.until_error, folder) if given.until_error else None
    code = launch.run(command, log, environment, folder, given.quiet, passed_on, watch)
    if watch is not None and watch.reached and not passed_on and code == 128 + signal.SIGUSR2:
        code = 0
    spent = record.get("cpu_time", None if given.resume else 0.0)  # of all parts; unknown where an earlier one was killed before it told
    spent = None if spent is None else round(spent + launch.cpu_of_children() - before, 3)
    errors = {"until_error": watch.told()} if watch is not None else {}
    run_state.write(folder, {**record, "exit_code": code, "wall_time": round(time.time() - started, 3), "cpu_time": spent, **errors})
    if watch is not None and watch.refused and not passed_on:
        raise InputError(f"{watch.refused}. The run was stopped; what it recorded is in {folder}{ending.way_to_go_on(given.case, folder)}")
    go_on = ending.way_to_go_on(given.case, folder)
    stopped = ending.stopped_by(code, passed_on)
    if stopped:
        finish(folder, name, gas, given.ranks, not given.no_picture, environment, say)
        print(f"tools/run: stopped by {stopped} before its end. What it recorded is in {folder}{go_on}", file=sys.stderr)
        return code
    if code != 0:
        print(f"tools/run: {ending.closing_words(code, log, folder, given.quiet, go_on)}", file=sys.stderr)
        return code
    finish(folder, name, gas, given.ranks, not given.no_picture, environment, say)
    for line in errors.get("until_error", ()):
        say(line)
    return 0


if __name__ == "__main__":
    exits.after(main, "tools/run", "run's folder")
