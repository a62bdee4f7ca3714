# SPDX-License-Identifier: GPL-3.0-or-later
"""What a case is and what each method would cost and get wrong, before anything long runs.

Short runs of the case in a scratch folder, on as many ranks as the run itself would have, tell particles, steps, memory and what each phase costs in seconds
of a processor, at the start; how that goes on as the bed loosens, cheaper runs of large parcels tell. What methods get wrong comes from measured scenes that are like this one.
"""

import contextlib
import os
import sys
import tempfile

from interphase import case_folder, evidence, exits, launch, plan_choice, tables
from interphase.case import Case
from interphase.command_line import Parser, count, end_time, positive
from interphase.commands import run as tools_run
from interphase.durations import told
from interphase.input_error import InputError
from interphase.missing import module
from interphase.sweep_plan import listed
from interphase.tree import CASES

EXAMPLES = """examples:
  tools/plan cases/sscp1 --until 60
  tools/plan cases/sscp1 --method CGHS,MPPIC --weight 2,8 --set inletVelocity=3.28 --ranks 2
  tools/plan cases/sscp1 --until 20 --within 2h --accuracy "pressure_drop_deviation 25%"
  tools/plan cases/snappy-vessel --method TDHS --check

Times are processor seconds of all ranks together, +- their standard error: by how much the cost per simulated second went up and down while it was measured,
and the trend that it had. "By the clock" holds where a core is free for each rank.

--check lets each method run for four times what it was measured on, in the same call, and compares what was foretold for that with what it took; processor
seconds of machines that others use, too, go up and down by some 10 % by themselves.

--accuracy "QUANTITY P%" (may be given again) asks for a method that is off by no more than that, twice the standard error of the measurement included;
--within 2h for one that is done by then. The cheapest is named, and on what evidence: scenes of python/interphase/trades.csv and each trades.csv in cases/*/study whose
Archimedes number, U/U_mf, and parcels, over depth and over cell, are near to those here. Where none is near, that is said.

exit code: 0; 1 where no method could be measured, or --check found one off by more than 20 %; 2 where the command line or the case is refused."""

USUAL_WEIGHT = 8.0
SCOUTING = 3.0  # times what the others may take
ENOUGH = 0.9  # of the run to plan, measured itself
OFF = 0.2  # of the cost: what --check calls wrong


def arguments():
    parser = Parser("tools/plan", "CASE", description=__doc__, epilog=EXAMPLES)
    parser.add_argument("case", metavar="CASE", help="a case folder, such as cases/sscp1")
    parser.add_argument("--set", metavar="NAME=VALUE", action="append", default=[], dest="settings", help="as of tools/run; may be given again")
    parser.add_argument("--method", metavar="M,M,...", help="collision methods (default: all that the case can run)")
    parser.add_argument("--weight", metavar="W,W,...", help="real particles per parcel (default: the case's, 8 where that is 1)")
    parser.add_argument("--until", metavar="T", type=end_time, help="simulated time of the run to plan, in s (default: the case's)")
    parser.add_argument("--ranks", metavar="N", type=count, default=1, help="MPI ranks of it (default 1)")
    parser.add_argument("--within", metavar="TIME", help="name the best method that is done by then, such as 2h, 30min")
    parser.add_argument("--accuracy", metavar='"QUANTITY P%"', action="append", default=[], help="name the cheapest method within it; may be given again")
    parser.add_argument("--calibrate", metavar="S", type=positive, default=5.0, help="processor seconds for a short run, about (default 5)")
    parser.add_argument("--check", action="store_true", help="then run each for longer, and compare")
    return parser.parse_args()


def candidates(case, given):
    """[(method, weight)] to be looked at, the cheap ones first; InputError for one that there is not."""
    named = [case.method_of(each) for each in listed(given.method)] if given.method else None
    weights = [case_folder.checked_weight(each) for each in listed(given.weight)] if given.weight else None
    weights = weights or [case.weight if case.weight > 1 else USUAL_WEIGHT]
    found = []
    for method in sorted(named or can_be_tried(case), key=cheap_first):
        found += [(method.name, weight) for weight in ([1.0] if method.of_particles else sorted(weights, reverse=True))]
    if named and given.weight and weights != [1.0] and all(method.of_particles for method in named):
        instead = " or ".join(dict.fromkeys(method.with_parcels for method in named if method.with_parcels))
        raise InputError(f"--weight {given.weight}: {', '.join(method.name for method in named)} track every particle (W = 1): "
                         + (f"add {instead}, or leave --weight away" if instead else "leave --weight away"))  # fmt: skip
    return list(dict.fromkeys(found))


def can_be_tried(case):
    """The methods that plug-ins of the case and LIGGGHTS bring; whether its script has them, a short run will tell. Its own alone where that is whatever a
    plug-in does."""
    own = case.method_of(None)
    brought = [each for each in case.methods().values() if each.plugin or not each.collisions_of_plugin]
    return brought if own in brought else [own]


def cheap_first(method):
    """A key to sort by: parcels before particles, means before impulses before springs."""
    return method.of_particles, ("none", "single", "resolved").index(method.contacts)


def changed(case, method, weight):
    """The Case with method and weight; InputError where it cannot have them."""
    return case.set(method=method, weight=f"{weight:g}")


def say(text=""):
    print(text, flush=True)


def measured(case, wanted, given, until, scratch):
    """([(method, weight, its Case, Calibration)], [words on why not]) of what can run."""
    calibration = module("plan_calibration")
    done, holes = [], []

    def measure(method, weight, seconds, name="measured"):
        if sys.stderr.isatty():
            print(f"measuring {named(method, weight)} ...", file=sys.stderr, flush=True)
        own = changed(case, method, weight)
        run = calibration.short_run(own, os.path.join(scratch, f"{name}-{method}-{weight:g}"), seconds, until, given.ranks)
        return own, calibration.of_run(run, own)

    for method, weight in wanted:
        try:
            done.append((method, weight, *measure(method, weight, given.calibrate)))
        except (InputError, launch.StepFailed) as error:
            holes.append(f"{named(method, weight)}: {' '.join(str(error).split())}")
    return with_scouts(done, calibration, given, until, measure) if done else done, holes


def with_scouts(done, calibration, given, until, measure):
    """`done`, its costs of particles beyond what was measured as those of large parcels of its kind go, which are cheap: scouts. The dearer scout, of springs,
    itself goes on as that of hard spheres does where that came further."""
    scouts = {}
    for kind in ("CGHS", "CGPM"):
        members = [each for each in done if calibration.SCOUT_OF.get(each[0]) == kind]
        if members:
            scouts[kind] = scout_of(kind, members, calibration, given, until, measure)
    furthest = max(scouts.values(), key=lambda scout: scout[1].reached, default=None)
    found = []
    for method, weight, own, each in done:
        name, scout = scouts.get(calibration.SCOUT_OF.get(method), (None, None))
        for its, other in ((name, scout), furthest if name else (None, None)):
            if other is not None and other.reached > each.reached:
                each = calibration.like(each, other, its)
        found.append((method, weight, own, each))
    return found


def scout_of(kind, members, calibration, given, until, measure):
    """(name, Calibration) of what went furthest among `members` and a scout, parcels of the method `kind`."""
    best = max(members, key=reached)
    if reached(best) < ENOUGH * until:
        seconds = SCOUTING * given.calibrate
        for weight in calibration.scout_weights(module("plan_scene").of_run(best[3].run), best[3], seconds, ENOUGH * until):
            with contextlib.suppress(InputError, launch.StepFailed):  # not every case can have parcels, or of that weight
                members = [*members, (kind, weight, *measure(kind, weight, seconds, "scout"))]
                break
    method, weight, _, furthest = max(members, key=reached)
    return named(method, weight), furthest


def reached(member):
    return member[3].reached


def named(method, weight):
    return f"{method} W = {weight:g}"


def planned_of(done, scene, until, ranks):
    found = []
    for method, weight, own, each in done:
        contact, step = each.run.meta.get("contact_duration"), float(each.run.meta["solid_step"])
        found.append(module("plan_choice").Planned(method, weight, contact / step if contact else None, each.cost(until).wall(ranks),
                                                   scene.of_parcels(weight), each))  # fmt: skip
    return found


def check(done, given, scratch):
    """Runs each for four times as long as it was measured; returns rows of (name, foretold, measured)."""
    calibration, model = module("plan_calibration"), module("cost_model")
    rows = []
    for method, weight, own, each in done:
        until = 4 * float(each.run.processor_time["gas"].time[-1])
        run = calibration.short_run(own, os.path.join(scratch, "check"), float("inf"), until, given.ranks)
        checked = calibration.of_run(run, own)
        end = checked.reached
        spent = {phase: float(run.processor_time[phase].values[-1] - run.processor_time[phase].values[0]) for phase in model.PHASES}
        foretold = each.cost(end)
        foretold.seconds["output"] = spent["output"]  # here, a row in each gas step is written, for the measuring
        rows.append((f"{named(method, weight)}, {end:.3g} s", foretold, model.Cost(spent, {}, checked.setup)))
    return rows


def asked_of(given, trades):
    return ([plan_choice.accuracy(text, trades) for text in given.accuracy],
            None if given.within is None else plan_choice.duration(given.within))


def main():
    given = arguments()
    path = case_folder.checked_case(given.case, CASES)
    case = Case(path).set(dict(_setting(text) for text in given.settings))
    until = given.until or case.end_time
    if until is None:
        raise InputError(f"{path}: endTime of system/controlDict is no number; give --until T")
    trades = evidence.everything()
    asked, within = asked_of(given, trades)
    wanted = candidates(case, given)
    if given.method and len(wanted) == 1:
        changed(case, *wanted[0])  # what is asked for and cannot be is refused, not left out
    if given.ranks > launch.cores():
        raise InputError(f"--ranks {given.ranks}: there are {launch.cores()} cores here: a cost by the clock cannot be measured; take fewer")
    os.environ["INTERPHASE_BIN"] = tools_run.program(quiet=False)
    table = module("plan_table")
    with tempfile.TemporaryDirectory(prefix="interphase-plan-") as scratch:
        done, holes = measured(case, wanted, given, until, scratch)
        if not done:
            raise launch.StepFailed("no method could be measured: " + "; ".join(holes))
        scene = module("plan_scene").of_run(done[-1][3].run)
        planned = planned_of(done, scene, until, given.ranks)
        say(f"{os.path.basename(path)}, {until:g} s simulated, {given.ranks} rank{'s' * (given.ranks > 1)}\n")
        say("\n".join(table.scene_lines(scene)))
        say("\n" + "\n".join(tables.columns(table.steps_rows(planned, scene), right=range(1, 8))))
        if any(each.method == "MPPIC" for each in planned) and scene.mean_cell:
            say(table.limits_of_mp_pic(scene, planned[0].calibration.gas_step))
        say("\n" + "\n".join(tables.columns(table.cost_rows(planned, until, given.ranks), right=range(1, 10))))
        for hole in holes:
            say(f"not measured: {hole}")
        for each in planned:
            for words in evidence.warnings(trades, each.method, each.numbers["parcel_over_depth"]):
                say(f"mind: {each.name}, {each.numbers['parcel_over_depth']:.2g} of the depth: {words}")
        if asked or within is not None:
            chosen, lines = plan_choice.cheapest(planned, trades, asked, within)
            say("\n" + "\n".join(lines))
            say(f"take {chosen.name}: {told(chosen.wall)} by the clock" if chosen else "none is named")
        if given.check:
            return told_check(table, check(done, given, scratch))
    return 0


def told_check(table, rows):
    say("\n" + "\n".join(tables.columns(table.check_rows(rows), right=(2, 3, 4))))
    off = [name for name, foretold, spent in rows if abs(foretold.total / spent.total - 1) > OFF]
    if off:
        print(f"tools/plan: off by more than {100 * OFF:g} %: {'; '.join(off)}", file=sys.stderr)
    return 1 if off else 0


def _setting(text):
    name, equals, value = text.partition("=")
    if not equals or not name.strip():
        raise InputError(f"--set {text}: give NAME=VALUE")
    if name.strip() in ("method", "weight"):
        raise InputError(f"--set {text}: give --{name.strip()} {value}")
    return name.strip(), value


if __name__ == "__main__":
    exits.after(main, "tools/plan", "folder for temporary files (TMPDIR)")
