# SPDX-License-Identifier: GPL-3.0-or-later
"""What the gas costs on a bubbling bed, and how wrong it is, for a choice of gas steps, time schemes, correctors and
matrix solvers.

One run with the case's own settings develops the bed until --start. From there every variant runs over the same short
--horizon, alone on one core: particles with position, velocity and spin of the last snapshot, gas with velocity, flux
and pressure of the last time folder, the same solid step for all. A bubbling bed is chaotic, so the horizon is a few
gas steps of the coarsest variant, in which the bed moves by about a particle but does not lose its memory.

cost       wall-clock seconds of the gas phase per simulated second: the median over --repeat rounds, all variants once a
           round, so that slow hours of a shared machine hit all alike. `spread` is half the range over the median.
error      at the end of the horizon against the reference: root mean square over cells or faces of the difference in
           velocity U, volume flux phi and pressure p, relative to that of the field (p: above the outlet's). It holds
           everything that changes with the gas step, the motion of the particles too.
algebra    the same against a variant of equal step and time scheme whose correctors and matrix solvers are converged:
           what correctors and tolerances alone cost in accuracy; the largest of the three.

The reference has the shortest step, the second-order time scheme, three outer and three inner correctors and
tight tolerances. The line `chaos` is the reference once more with every particle moved by 1e-9 m: errors below it are
none.

The study ends with a table in Markdown. A developed bed that an earlier study left in --out is taken again, unless
--fresh says otherwise.
"""

import argparse
import os
import re
import shutil
import statistics
import subprocess
import sys
from dataclasses import dataclass, replace

from interphase import Case, InputError, Run, StepFailed, launch, parameters, tables
from interphase.tree import REPOSITORY

# Divides every gas step below; of the shortest collision of sscp1: 1/40 for parcels of 8, 1/14 for single particles [s].
SOLID_STEP = 2.5e-5
PRESSURE_SOLVERS = {
    "PCG DIC": "solver PCG; preconditioner DIC;",
    "PCG GAMG": "solver PCG; preconditioner { preconditioner GAMG; smoother GaussSeidel; nVcycles 1; "
                "tolerance 1e-10; relTol 0; }",
    "GAMG GaussSeidel": "solver GAMG; smoother GaussSeidel;",
    "GAMG DICGaussSeidel": "solver GAMG; smoother DICGaussSeidel;",
}  # fmt: skip


@dataclass(frozen=True)
class Variant:
    """One choice of everything that costs; `step` in s. The defaults are what cases/sscp1 has."""

    step: float = 1e-3
    scheme: str = "backward"
    predictor: bool = False
    outer: int = 1
    inner: int = 2
    solver: str = "GAMG GaussSeidel"
    relative: float = 0.1  # of all but the last pressure solve
    tolerance: float = 1e-5  # of the last one
    velocity_tolerance: float = 1e-8
    cache: bool = True  # of gradients, by OpenFOAM

    def converged(self):
        """The same step and scheme, its equations solved."""
        return replace(self, predictor=True, outer=3, inner=3, solver="PCG DIC", relative=1e-3, tolerance=1e-9,
                       velocity_tolerance=1e-10, cache=True)

    def name(self):
        """Of its folder."""
        return re.sub(
            r"[^\w.+-]", "_",
            f"{self.step * 1e3:g}ms-{self.scheme}-o{self.outer}i{self.inner}-{'p' if self.predictor else 'n'}-{self.solver}"
            f"-r{self.relative:g}-t{self.tolerance:g}-u{self.velocity_tolerance:g}-{'c' if self.cache else 'n'}",
        )  # fmt: skip

    def solution(self):
        """fvSolution."""
        solver = PRESSURE_SOLVERS[self.solver]
        velocity = f"solver smoothSolver; smoother symGaussSeidel; tolerance {self.velocity_tolerance:g}; relTol 0;"
        return f"""solvers
{{
    p_rgh {{ {solver} tolerance {self.tolerance:g}; relTol {self.relative:g}; }}
    p_rghFinal {{ {solver} tolerance {self.tolerance:g}; relTol 0; }}
    "(U|UFinal)" {{ {velocity} }}
}}
PIMPLE
{{
    momentumPredictor {"yes" if self.predictor else "no"};
    nOuterCorrectors {self.outer};
    nCorrectors {self.inner};
    nNonOrthogonalCorrectors 0;
}}
cache {{ {"grad(U); grad(p_rgh);" if self.cache else ""} }}
"""


REFERENCE = Variant(step=1.25e-4, scheme="backward").converged()


def variants(base):
    """Group -> variants, each differing from `base` in one respect or two."""
    steps = [2.5e-4, 5e-4, 1e-3, 2e-3, 4e-3]
    return {
        "base": [base],
        "gas step, time scheme": [replace(base, step=s, scheme=t) for t in ("Euler", "backward") for s in steps],
        "correctors": [
            replace(base, predictor=p, outer=o, inner=i)
            for p, o, i in [(True, 1, 1), (False, 1, 1), (True, 1, 2), (False, 1, 2), (True, 1, 3), (False, 1, 3),
                            (True, 2, 1), (False, 2, 1), (True, 2, 2)]
        ],
        "matrix solver": [replace(base, solver=s) for s in PRESSURE_SOLVERS],
        "tolerance": [
            replace(base, relative=r, tolerance=t)
            for r, t in [(0.1, 1e-4), (0.1, 1e-5), (0.1, 1e-6), (0.01, 1e-5), (0.01, 1e-6), (0.01, 1e-7), (0.01, 1e-8)]
        ],
        "no cache of gradients": [replace(base, cache=False)],
    }  # fmt: skip


def developed_bed(options):
    """Runs the case until the start; its folder."""
    folder = os.path.join(options.out, "start")
    if options.fresh or not os.path.exists(os.path.join(folder, "results.h5")):
        print("developing the bed until", options.start, "s ...", flush=True)
        entries = {"system/controlDict:writeFormat": "ascii", **dict(setting.partition("=")[::2] for setting in options.set)}
        if not Case(options.case).set(entries).run(folder, until=options.start, overwrite=True).ok:
            sys.exit(f"gas-study: the run that develops the bed failed; its folder is {folder}")
    last = Run(folder).field_times[-1]
    if abs(last - options.start) > 1e-6:
        sys.exit(f"gas-study: {folder} ends at {last:g} s, not at {options.start:g} s; --fresh runs it again")
    return folder


def make_case(folder, variant, start, horizon, moved, environment):
    """A case in `folder` that goes on from the developed bed."""
    from interphase import case_folder, starting_point, starting_run

    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for part in ("0", "constant", "system", "dem"):
        shutil.copytree(os.path.join(start, part), os.path.join(folder, part))
    shutil.copy(os.path.join(start, "parameters"), folder)
    starting_point.put(starting_run.find(start), folder, "the study's case", "pimple", environment, lambda _: None, moved)

    case = case_folder.Dictionaries(folder)
    for entry, value in [("deltaT", f"{variant.step:g}"), ("endTime", f"{horizon:g}"), ("writeInterval", f"{horizon:g}"),
                         ("adjustTimeStep", "no"), ("writeFormat", "ascii")]:  # fmt: skip
        case.set("system/controlDict", entry, value)
    case.set("system/fvSchemes", "ddtSchemes/default", variant.scheme)
    case.write_into(folder)
    coupling = os.path.join(folder, "system", "couplingDict")
    with open(coupling, encoding="utf-8") as file:
        text = re.sub(r"(stepsPerCollision|solidStep)\s+[^;]+;", f"solidStep {SOLID_STEP:g};", file.read())
    with open(coupling, "w", encoding="utf-8") as file:
        file.write(text)
    with open(os.path.join(folder, "system", "fvSolution"), "w", encoding="utf-8") as file:
        file.write("FoamFile { version 2.0; format ascii; class dictionary; object fvSolution; }\n" + variant.solution())


def run_once(folder, environment, binary):
    """Runs the case in `folder`; the seconds of its gas phase."""
    with open(os.path.join(folder, "log.interphase"), "w") as log:
        code = subprocess.run([binary, "-case", folder], stdout=log, stderr=subprocess.STDOUT, env=environment).returncode
    if code != 0:
        sys.exit(f"gas-study: {binary} -case {folder} ended with exit code {code}; see log.interphase there")
    return Run(folder).timing["gas"]


def field(folder, name):
    """The values of the last time folder in cells or faces, [n] or [n, 3]."""
    return Run(folder).fields(name).values


def differences(folder, against, outlet_pressure):
    """Of U, phi and p_rgh: relative root mean squares."""
    import numpy

    result = []
    for name, origin in (("U", 0.0), ("phi", 0.0), ("p_rgh", outlet_pressure)):
        mine, other = field(folder, name), field(against, name)
        result.append(float(numpy.sqrt(((mine - other) ** 2).sum() / ((other - origin) ** 2).sum())))
    return result


def short(value):
    return f"{100 * value:.2g} %"


def arguments():
    parser = argparse.ArgumentParser(
        prog="tools/gas-study", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--case", default=os.path.join(REPOSITORY, "cases", "sscp1"), help="(default cases/sscp1)")
    parser.add_argument("--out", default=os.path.join(REPOSITORY, "runs", "gas-study"), metavar="DIR")
    parser.add_argument("--start", type=float, default=0.7, metavar="T", help="the bed's development [s] (default 0.7)")
    parser.add_argument("--horizon", type=float, default=0.04, metavar="T", help="of the comparison [s] (default 0.04)")
    parser.add_argument("--repeat", type=int, default=3, metavar="N", help="rounds of timing (default 3)")
    parser.add_argument("--group", action="append", metavar="NAME", help="only groups whose names hold NAME")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="handed to tools/run")
    for name, kind in (("step", float), ("scheme", str), ("outer", int), ("inner", int), ("solver", str),
                       ("relative", float), ("tolerance", float)):  # fmt: skip
        parser.add_argument(f"--{name}", type=kind, default=getattr(Variant, name),
                            help=f"of the base variant (default {getattr(Variant, name)})")
    parser.add_argument("--predictor", choices=("yes", "no"), default="no", help="of the base variant (default no)")
    parser.add_argument("--fresh", action="store_true", help="develop the bed again")
    options = parser.parse_args()
    if options.solver not in PRESSURE_SOLVERS:
        parser.error(f"--solver '{options.solver}': choose one of {', '.join(PRESSURE_SOLVERS)}")
    if options.repeat < 1 or not options.horizon > 0 or not options.start > 0:
        parser.error("--repeat, --horizon and --start must be above 0")
    coarsest = max(v.step for group in variants(Variant()).values() for v in group)
    if abs(options.horizon / coarsest - round(options.horizon / coarsest)) > 1e-6:
        parser.error(f"--horizon {options.horizon:g}: give a multiple of the longest gas step, {coarsest:g} s")
    return options


def main():
    options = arguments()
    base = Variant(options.step, options.scheme, options.predictor == "yes", options.outer, options.inner, options.solver,
                   options.relative, options.tolerance)  # fmt: skip
    groups = variants(base)
    if options.group:
        groups = {g: v for g, v in groups.items() if any(part in g for part in options.group)}
        if not groups:
            sys.exit(f"gas-study: --group {' '.join(options.group)}: the groups are {', '.join(variants(base))}")
    start = developed_bed(options)
    binary = launch.program("interphase")
    environment = {**os.environ, **launch.additions(os.environ)}

    timed = list(dict.fromkeys(v for group in groups.values() for v in group))
    companions = list(dict.fromkeys(v.converged() for v in timed))
    folder_of = {v: os.path.join(options.out, v.name()) for v in [*timed, *companions, REFERENCE]}
    chaos = os.path.join(options.out, "chaos")
    seconds = {}

    def run(variant, folder, moved=0.0):
        make_case(folder, variant, start, options.horizon, moved, environment)
        return run_once(folder, environment, binary)

    def show(done, of):
        print(f"\r{done} of {of} runs", end="", file=sys.stderr, flush=True)

    total, done = len(companions) + 2 + options.repeat * len(timed), 0
    for variant in dict.fromkeys([*companions, REFERENCE]):
        run(variant, folder_of[variant])
        show(done := done + 1, total)
    run(REFERENCE, chaos, 1e-9)
    for _ in range(options.repeat):
        for variant in timed:
            seconds.setdefault(variant, []).append(run(variant, folder_of[variant]) / options.horizon)
            show(done := done + 1, total)
    print(file=sys.stderr)

    outlet = float(parameters.read(os.path.join(start, parameters.PARAMETERS)).get("outletPressure", 0.0))
    noise = differences(chaos, folder_of[REFERENCE], outlet)
    print(f"chaos (reference with particles moved by 1e-9 m): "
          f"U {short(noise[0])}, phi {short(noise[1])}, p {short(noise[2])}\n")
    print(tables.markdown_head(("", "gas step", "time scheme", "predictor", "outer, inner", "pressure solver", "relTol, tolerance", "gas s/s",
                                "spread", "error U", "error phi", "error p", "algebra")))  # fmt: skip
    for group, members in groups.items():
        for v in members:
            cost = statistics.median(seconds[v])
            spread = (max(seconds[v]) - min(seconds[v])) / 2 / cost
            against = differences(folder_of[v], folder_of[REFERENCE], outlet)
            algebra = differences(folder_of[v], folder_of[v.converged()], outlet)
            print(tables.markdown_row((
                group, f"{v.step * 1e3:g} ms", v.scheme, "yes" if v.predictor else "no", f"{v.outer}, {v.inner}", v.solver,
                f"{v.relative:g}, {v.tolerance:g}", f"{cost:.1f}", f"{100 * spread:.0f} %", *map(short, against), short(max(algebra)))))
            group = ""


if __name__ == "__main__":
    try:
        main()
    except (InputError, StepFailed) as error:
        sys.exit(f"gas-study: {error}")
