# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the time goes, as ratios measured side by side.

Commands:
  overhead   LIGGGHTS driven by interphase (`gas none`) against the packaged liggghts binary on the same script: the time
             of the step loop of each, run in turn. Prints the ratio native / coupled pair by pair and its median; 1 is parity.
  methods    The collision methods beside each other on sscp1, each from a bed that has bubbled for a while: seconds of the
             particle phase per simulated second, run in turn, and how many times faster than DEM each is.
  cost       Where a step of the hard spheres goes: search, walls, contacts, integration, communication.
  laws       What a law of contacts costs: beds that fall and rest, each law in turn, its time over the built-in one's.
  scaling    Cost per particle and step as their number grows: hard spheres in settled beds of 10^3 to 10^6 (TDHS), or
             parcels of MP-PIC in sscp1, 10^4 to 10^6 of them in the same vessel and mesh (MPPIC).
  phases     A coupled run: the share of each phase in its wall-clock time, what the coupling itself costs
             (mapping + exchange + output), and the whole against solids + gas alone.
  cost-model The cost of the particles against S, W and N beside the paper's model (eqs. 24 to 28), from beds that bubble; tools/COST.md.
  statistics What statistics in the run cost on sscp1: a sample, and the share of the time at an interval, without and with mean fields.
  records    What it costs that nothing is lost, on sscp1: rows, one a gas step; a checkpoint; as shares of the time.

Machines are noisy and often shared, so single seconds mean little: read the ratios, and repeat.

Examples:
  tools/bench overhead --until 0.02 --pairs 5
  tools/bench phases --method DEM --until 0.5
  tools/bench methods --rounds 3
  tools/bench cost
  tools/bench laws --lanes 4
  tools/bench scaling --method MPPIC
"""

import argparse
import contextlib
import os
import statistics
import sys
import tempfile

from interphase import Case, InputError, Run, StepFailed, cost_study, launch, law_benchmark, parameters, stored, tables
from interphase.settled_bed import loop_seconds, spans
from interphase.tree import CASES

CASE = os.path.join(CASES, "sscp1")


def parameter(name):
    """Of sscp1, a number."""
    return float(parameters.read(os.path.join(CASE, parameters.PARAMETERS))[name])


def ran(folder, until, start=None, **entries):
    """(timing, meta) of a run of sscp1 with its `entries`, those of files as {"FILE:ENTRY": value}."""
    run = Case(CASE).set(entries).run(folder, until=until, start=start, overwrite=True)
    if not run.ok:
        sys.exit(f"bench: the run in {folder} {run.state}")
    return run.timing, run.meta


def native_loop_seconds(folder, meta):
    """Time of the step loop of the packaged liggghts on the case that `folder` holds."""
    steps = round(meta["simulated_time"] / meta["solid_step"])
    with open(os.path.join(folder, "dem", "in.native"), "w") as stream:
        stream.write(f"include dem/in.liggghts\ntimestep {meta['solid_step']!r}\nrun {steps}\n")
    said = launch.liggghts("dem/in.native", folder, parameters.read(os.path.join(folder, parameters.PARAMETERS)))
    return loop_seconds(said)[-1]


def overhead(given):
    ratios = []
    with tempfile.TemporaryDirectory(prefix="interphase-bench-") as scratch:
        folder = os.path.join(scratch, "run")
        for pair in range(given.pairs):
            timing, meta = ran(folder, given.until, method=given.method, **{"gas/model": "none", "gas/coupling": "oneWay"})
            native = native_loop_seconds(folder, meta)
            ratios.append(native / timing["solids"])
            print(f"pair {pair + 1}: native {native:.2f} s, in the coupler {timing['solids']:.2f} s, "
                  f"native / coupled {ratios[-1]:.3f}", flush=True)
    print(f"median native / coupled {statistics.median(ratios):.3f} (min {min(ratios):.3f}, max {max(ratios):.3f})")


def phases(given):
    if given.run:
        timing, meta = Run(given.run).timing, Run(given.run).meta
    else:
        with tempfile.TemporaryDirectory(prefix="interphase-bench-") as scratch:
            timing, meta = ran(os.path.join(scratch, "run"), given.until, method=given.method)
    wall, simulated = meta["wall_time"], meta["simulated_time"]
    print(f"{meta['method']}, weight {meta['weight']:g}, {simulated:g} s simulated, {int(meta['ranks'])} rank(s)")
    rows = [("phase", "s per simulated s", "share")]
    for phase in ("solids", "gas", "mapping", "exchange", "output", "waiting", "setup"):
        seconds = timing[phase]
        rows.append((phase, f"{seconds / simulated:.2f}", f"{100 * seconds / wall:.1f} %"))
    print("\n".join(tables.columns(rows, right=(1, 2))))
    coupling = sum(timing[phase] for phase in ("mapping", "exchange", "output"))
    engines = timing["solids"] + timing["gas"]
    running = wall - timing["setup"]
    print(f"mapping + exchange + output: {100 * coupling / running:.1f} % of the time after set-up")
    print(f"whole / (solids + gas): {running / engines:.3f}")


PER_COLLISION, GAS_STEP = "particles/stepsPerCollision", "system/controlDict:deltaT"
METHODS = {  # name: method, weight, other entries
    "DEM": ("DEM", 1, {}),
    "TDHS": ("TDHS", 1, {}),
    "TDHS, 1.4 t_c": ("TDHS", 1, {PER_COLLISION: 0.5}),
    "TDHS, 1.7 t_c": ("TDHS", 1, {PER_COLLISION: 0.59, GAS_STEP: 1.2e-3}),
    "TDHS, 2 t_c": ("TDHS", 1, {PER_COLLISION: 0.5, GAS_STEP: 1.4e-3}),
    "TDHS, 2.9 t_c": ("TDHS", 1, {PER_COLLISION: 0.33333}),
    "CGHS": ("CGHS", 8, {}),
    "CGHS, 2 t_c": ("CGHS", 8, {PER_COLLISION: 0.5, GAS_STEP: 2e-3}),
    "CGHS, 3 t_c": ("CGHS", 8, {PER_COLLISION: 0.33333, GAS_STEP: 3e-3}),
}


def methods(given):
    wanted = given.only or list(METHODS)
    beds = {}
    for run in given.bed:
        beds[int(Run(run).meta["weight"])] = run
    with tempfile.TemporaryDirectory(prefix="interphase-bench-") as scratch:
        for weight in {METHODS[name][1] for name in wanted} - set(beds):
            beds[weight] = os.path.join(scratch, f"start-{weight}")
            ran(beds[weight], given.start, method="CGHS" if weight > 1 else "TDHS", weight=weight)
        seconds = {name: [] for name in wanted}
        for turn in range(given.rounds):
            for name in wanted:
                method, weight, entries = METHODS[name]
                span = given.span if method == "DEM" else given.span * 6
                span = round(span / 6e-3) * 6e-3
                timing, meta = ran(os.path.join(scratch, "run"), span, beds[weight], method=method, weight=weight, **entries)
                seconds[name].append(timing["solids"] / meta["simulated_time"])
            told = ", ".join(f"{name} {seconds[name][-1]:.2f}" for name in wanted)
            print(f"round {turn + 1}: seconds of solids per simulated second: {told}", flush=True)
    rows = [("method", "s per s", "DEM / it, median (least to most)")]
    for name in wanted:
        ratios = [dem / own for dem, own in zip(seconds["DEM"], seconds[name])] if "DEM" in wanted else []
        faster = f"{statistics.median(ratios):.1f} ({min(ratios):.1f} to {max(ratios):.1f})" if ratios else ""
        rows.append((name, f"{statistics.median(seconds[name]):.2f}", faster))
    print("\n".join(tables.columns(rows, right=(1, 2))))


NOTHING_ELSE = {"records/snapshotInterval": 1000, "system/controlDict:writeInterval": 1000, "checkpoint/wallInterval": 0}  # is written


def records(given):
    """Two lengths of a run, so that start and end of both cancel."""
    print(f"{'method':8s} {'tracked':>8s} {'a row [ms]':>11s} {'share':>8s} {'a checkpoint [s]':>17s} {'every 600 s':>12s}")
    for method, weight in (("TDHS", 1), ("CGHS", 8), ("CGHS", 64), ("MPPIC", 8)):
        rows = {"method": method, "weight": weight, "records/interval": given.interval, **NOTHING_ELSE}
        with tempfile.TemporaryDirectory(prefix="interphase-bench-") as scratch:
            def spent(until, **kept):
                timing, meta = ran(os.path.join(scratch, "run"), until, **rows, **kept)
                return timing["output"], meta["wall_time"], round(until / 1e-3), meta["particles"]

            short, long = spent(given.until), spent(3 * given.until)
            output, wall, steps = (b - a for a, b in zip(short[:3], long[:3]))
            count = 10
            kept = (spent(given.until, **{"checkpoint/interval": given.until / count})[0] - short[0]) / count
        print(f"{method:5s}{weight:3d} {short[3]:8.0f} {1e3 * output / steps:11.2f} {100 * output / wall:6.2f} % {kept:17.2f} "
              f"{100 * kept / 600:10.2f} %", flush=True)


def statistics_in_run(given):
    """From what a run itself books for its samples, without and with mean fields."""
    print(f"{'method':8s} {'tracked':>8s} {'a sample [ms]':>14s} {'share of the time':>18s} {'with mean fields [ms]':>22s} {'share of the time':>18s}")
    for method, weight in (("CGPM", 8), ("CGHS", 8), ("MPPIC", 8), ("TDHS", 1)):
        entries = {"method": method, "weight": weight, "statistics/interval": given.interval, **NOTHING_ELSE}
        measured = []
        for fields in ({}, {"statistics/fields/from": 0}):
            with tempfile.TemporaryDirectory(prefix="interphase-bench-") as scratch:
                folder = os.path.join(scratch, "run")
                _, meta = ran(folder, given.until, **entries, **fields)
                spent = stored.attributes(os.path.join(folder, "results.h5"), "statistics")["wall_time"]
                measured += [1e3 * spent / len(Run(folder).samples["spheres"].time), 100 * spent / meta["wall_time"]]
        print(f"{method:5s}{weight:3d} {meta['particles']:8.0f} {measured[0]:14.2f} {measured[1]:16.2f} % {measured[2]:22.2f} {measured[3]:16.2f} %", flush=True)


def cost(given):
    span = spans(given.count, (given.settle, given.steps))[-1]
    print(f"{given.count} spheres at rest, {span.pairs / given.count:.2f} contacts within the margin per sphere")
    rows = [("part", "ns per sphere and step", "share")]
    rest = span.seconds - sum(span.parts.values())
    for part, seconds in [*span.parts.items(), ("LIGGGHTS", rest), ("whole", span.seconds)]:
        rows.append((part, f"{1e9 * seconds / given.count:.1f}", f"{100 * seconds / span.seconds:.1f} %"))
    print("\n".join(tables.columns(rows, right=(1, 2))))


def scaling(given):
    {"TDHS": scaling_of_hard_spheres, "MPPIC": scaling_of_mp_pic}[given.method](given)


def scaling_of_hard_spheres(given):
    print(f"{'spheres':>9s} {'ns per sphere and step':>24s}")
    for count in (1_000, 10_000, 100_000, 1_000_000):
        span = spans(count, (given.settle, max(20, min(2000, 2_000_000 // count))))[-1]
        print(f"{count:9d} {1e9 * span.seconds / count:24.1f}", flush=True)


def scaling_of_mp_pic(given):
    count, diameter = parameter("particleCount"), parameter("diameter")
    print(f"{'parcels':>9s} {'solids':>10s} {'mapping and exchange':>22s}   ns per parcel and step")
    with tempfile.TemporaryDirectory(prefix="interphase-bench-") as scratch:
        for parcels in (10_000, 100_000, 1_000_000):
            # as much solid volume in each: the same bed
            timing, meta = ran(os.path.join(scratch, "run"), given.until, method="MPPIC", weight=1, particleCount=parcels,
                               diameter=diameter * (count / parcels) ** (1 / 3))  # fmt: skip
            steps = parcels * meta["simulated_time"] / meta["solid_step"]
            coupling = timing["mapping"] + timing["exchange"]
            print(f"{parcels:9d} {1e9 * timing['solids'] / steps:10.1f} {1e9 * coupling / steps:22.1f}", flush=True)


def cost_of_laws(given):
    found = law_benchmark.laws(given.against)
    unknown = set(given.only) - set(found)
    if unknown:
        raise InputError(f"--only {', '.join(sorted(unknown))}: none of the laws; there are {', '.join(found)}")
    wanted = {name: law for name, law in found.items() if name == law_benchmark.BUILT_IN or not given.only or name in given.only}
    print(f"{given.count} spheres, {given.lanes or 'as many as the processor takes'} contacts at once")
    seconds = law_benchmark.measure(given.count, given.rounds, wanted, given.lanes, lambda text: print(text, flush=True))
    print("time over that of the built-in law, median of the rounds (least to most)")
    print("\n".join(law_benchmark.report(seconds)))


def cost_of_the_model(given):
    if not given.show:
        with contextlib.nullcontext(given.keep) if given.keep else tempfile.TemporaryDirectory(prefix="interphase-bench-") as scratch:
            cost_study.study(given.rounds, given.start, scratch, given.table, lambda text: print(text, flush=True))
    print("\n".join(cost_study.report(given.table)))


def main():
    parser = argparse.ArgumentParser(prog="tools/bench", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    one = commands.add_parser("overhead", help="the coupler's LIGGGHTS against the packaged one")
    one.add_argument("--method", default="DEM", choices=["DEM", "CGPM"])
    one.add_argument("--until", type=float, default=0.02, help="simulated seconds (default 0.02)")
    one.add_argument("--pairs", type=int, default=3)
    two = commands.add_parser("phases", help="shares of the phases of a coupled run")
    two.add_argument("--method", default="CGPM", choices=["DEM", "CGPM"])
    two.add_argument("--until", type=float, default=0.2)
    two.add_argument("--run", metavar="DIR", help="read a finished run instead of making one")
    six = commands.add_parser("records", help="rows and checkpoints")
    six.add_argument("--until", type=float, default=0.1, help="simulated seconds of the shorter run (default 0.1)")
    six.add_argument("--interval", type=float, default=0.05, help="between two rows of /series [s] (default 0.05, the case's own); /ledger has one a gas step")
    seven = commands.add_parser("statistics", help="statistics in the run")
    seven.add_argument("--until", type=float, default=0.3, help="simulated seconds (default 0.3)")
    seven.add_argument("--interval", type=float, default=0.05, help="between two samples [s] (default 0.05)")
    three = commands.add_parser("methods", help="DEM, TDHS and CGHS beside each other")
    three.add_argument("--rounds", type=int, default=3)
    three.add_argument("--span", type=float, default=0.03, help="simulated seconds of DEM per round (default 0.03); others six times that")
    three.add_argument("--start", type=float, default=1.2, help="when the beds are taken [s] (default 1.2)")
    three.add_argument("--bed", metavar="RUN", action="append", default=[],
                       help="take the bed from this finished run of sscp1, for methods of its weight; may be given again")
    three.add_argument("--only", action="append", choices=list(METHODS), help="this one; may be given again")
    four = commands.add_parser("cost", help="parts of a hard-sphere step")
    four.add_argument("--count", type=int, default=95000)
    eight = commands.add_parser("laws", help="laws of contacts beside the built-in one")
    eight.add_argument("--count", type=int, default=20000, help="spheres (default 20000)")
    eight.add_argument("--rounds", type=int, default=7)
    eight.add_argument("--lanes", type=int, default=0, choices=[0, 1, 4, 8], help="contacts at once: 8 (512 bits), 4 (256 bits), 1; 0: what the processor has (default)")
    eight.add_argument("--only", metavar="LAW", action="append", default=[], help="this one beside the built-in one; may be given again")
    eight.add_argument("--against", metavar="DIR", help="build folder of another version, whose built-in law is run, too")
    five = commands.add_parser("scaling", help="cost of a step of hard spheres or MP-PIC as the number of particles grows")
    five.add_argument("--method", default="TDHS", choices=["TDHS", "MPPIC"])
    five.add_argument("--until", type=float, default=0.1, help="MPPIC: simulated seconds (default 0.1)")
    for one_of in (four, five):
        one_of.add_argument("--settle", type=int, default=1000, help="steps before measuring (default 1000)")
    four.add_argument("--steps", type=int, default=200)
    seven = commands.add_parser("cost-model", help="cost of the particles against S, W and N, beside the paper's model")
    seven.add_argument("--rounds", type=int, default=3)
    seven.add_argument("--start", type=float, default=0.4, help="when the beds are taken [s] (default 0.4)")
    seven.add_argument("--table", metavar="FILE", default="cost-model.csv", help="what is measured (default cost-model.csv)")
    seven.add_argument("--keep", metavar="DIR", help="leave the beds there, and take those that are there")
    seven.add_argument("--show", action="store_true", help="measure nothing: show the table that is there")
    given = parser.parse_args()
    try:
        {"overhead": overhead, "phases": phases, "methods": methods, "cost": cost, "scaling": scaling, "records": records,
         "cost-model": cost_of_the_model, "laws": cost_of_laws,
         "statistics": statistics_in_run}[given.command](given)
    except (InputError, StepFailed) as error:
        sys.exit(f"bench: {error}")


if __name__ == "__main__":
    main()
