# SPDX-License-Identifier: GPL-3.0-or-later
"""Run one LIGGGHTS script in the packaged `liggghts` and in the coupler without gas, compare and judge."""

import os
import re
import sys
import tempfile

from interphase import exits, validation, validation_scene
from interphase.command_line import Parser, end_time
from interphase.comparison import CANNOT
from interphase.input_error import InputError

DETAILS = """CASE_OR_SCRIPT is
  a LIGGGHTS script   with `timestep` and `run N`. Its folder is copied, so files that it reads must lie in it. Earlier runs
                      are LIGGGHTS's own on both sides; the last one is done by the coupler on its side. What follows is left out
  a case's folder     such as cases/sscp1: its script, variables, weight, method and solid step; its gas is left out. Methods of
                      plug-ins (TDHS, CGHS, MPPIC) run in interphase-liggghts, as the packaged binary has no plug-ins

Both write all particles every 1/40 of the last run, to the last bit. In this order it is asked:
  1. Are the dumps bit-equal?
  2. Has round-off grown to this? LIGGGHTS once more, with a solid step that differs in its last places: where that twin is
     off by less than 1 %, the coupler may be a thousand times as far off, no more.
  3. Are the flows alike by their means (tools/compare --statistics)?

exit code, the worst of all ranks:
  0  bit-equal, equal up to round-off, or statistically indistinguishable
  1  different
  2  could not be run or compared; the engine's own words are shown
  3  cannot be judged: run longer

examples:
  tools/validate my.liggghts
  tools/validate cases/sscp1 --method CGPM --weight 64 --until 0.02
  tools/validate my.liggghts --ranks 1 --only-coupler friction=0.5     # made wrong on purpose: must end with 1"""


def arguments(given):
    parser = Parser("tools/validate", "CASE_OR_SCRIPT", description=__doc__, epilog=DETAILS)
    parser.add_argument("scene", metavar="CASE_OR_SCRIPT", help="a LIGGGHTS script or a case's folder")
    parser.add_argument("--ranks", metavar="N,...", default="1,2", help="MPI ranks to try, both sides on the same (default: 1,2)")
    parser.add_argument("--until", metavar="T", type=end_time, help="of a case: simulated time [s] (default: the case's)")
    parser.add_argument("--set", metavar="KEY=VALUE", action="append", default=[], dest="settings", help="of a case: as tools/run has it")
    parser.add_argument("--var", metavar="NAME=VALUE", action="append", default=[], help="a variable of the script, on both sides")
    parser.add_argument("--only-coupler", metavar="NAME=VALUE", action="append", default=[], dest="wrong",
                        help="a variable's other value in the coupler alone: to see that a difference is found")
    parser.add_argument("--weight", metavar="W", type=float, help="real particles in each parcel (default: the case's; of a script 1)")
    parser.add_argument("--method", help="DEM, CGPM, ... (default: the case's; of a script DEM, with a weight CGPM)")
    parser.add_argument("--plugin", metavar="NAME", action="append", default=[], help="of a script: a plug-in that it wants")
    parser.add_argument("--out", metavar="DIR", help="keep both runs here: a folder that is empty or not there (default: deleted)")
    options = parser.parse_args(given)
    if not re.fullmatch(r"[1-9]\d*(,[1-9]\d*)*", options.ranks):
        raise InputError(f"--ranks {options.ranks}: give numbers such as 1,2")
    options.ranks = [int(n) for n in options.ranks.split(",")]
    options.var, options.wrong = (dict(map(pair, texts)) for texts in (options.var, options.wrong))
    if options.out and os.path.isdir(options.out) and os.listdir(options.out):
        raise InputError(f"--out {options.out}: it is not empty; give another folder")
    is_case = os.path.isdir(options.scene)
    wrong_kind = ("plugin",) if is_case else ("until", "settings")
    for name in wrong_kind:
        if getattr(options, name):
            raise InputError(f"--{name.replace('settings', 'set')} is not for {'a case' if is_case else 'a script'}; see --help")
    if is_case:
        options.settings += [f"{name}={value}" for name, value in (("method", options.method), ("weight", options.weight)) if value is not None]
    return options


def pair(text):
    name, equals, value = text.partition("=")
    if not equals or not name or not value:
        raise InputError(f"{text}: give NAME=VALUE")
    return name, value


def run(options, out):
    if os.path.isdir(options.scene):
        scene = validation_scene.scene_of_case(options.scene, out, options.settings, options.until, options.var, options.wrong)
    elif os.path.isfile(options.scene):
        scene = validation_scene.scene_of_script(
            options.scene, out, options.var, options.wrong, options.weight, options.method, options.plugin)
    else:
        raise InputError(f"{options.scene}: neither a script nor a case's folder")
    worst = 0
    for ranks in options.ranks:
        code, verdict, lines = validation.validate(scene, out, ranks)
        print(f"{ranks} rank{'s' if ranks > 1 else ''}: {verdict}")
        print("".join(f"  {line}\n" for line in lines), end="", flush=True)
        worst = max(worst, code, key=(0, 3, 2, 1).index)
    return worst


def main(given):
    try:
        options = arguments(given)
        if options.out:
            os.makedirs(options.out, exist_ok=True)
            return run(options, os.path.abspath(options.out))
        with tempfile.TemporaryDirectory(prefix="interphase-validate-") as out:
            return run(options, out)
    except (InputError, OSError) as error:
        print(f"tools/validate: {error}", file=sys.stderr)
        return CANNOT


if __name__ == "__main__":
    exits.with_verdict(main, "tools/validate", CANNOT)
