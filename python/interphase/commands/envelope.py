# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the coupling holds: runs of dense scenes over the gas step x, in relaxation times m/k of a particle at its hindered
velocity, and the solid fraction; each is measured against the drag law.

scenes      closed     a box full of spheres and water: the middle third falls at the hindered velocity
            fluidized  a column in a stream of water: height or solid fraction are the law's equilibrium
            packed     a bed in gas: the drop is the law's below minimum fluidization, the weight above
            fine       the same of 75 um in air, parcels
verdicts    calm and right: within 2 %, deviation in time at most 5 %, nothing alternates by more than 2 %
            calm with stated error: the same, off by more than 2 % (at most 25 %)
            told: the run stopped with a message, or warned
            failed: wrong without a word, or crashed
            not run: a step would carry particles past a cell, or the scene needs too many steps

The folder of --out holds map.png, map.csv, map.md and a small file per run, which a later call takes instead of running again.
Exit code 0 when nothing failed, 1 otherwise.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

from interphase import envelope_map, launch
from interphase.envelope_measures import measure
from interphase.envelope_scenes import FRACTIONS, METHODS, RATIOS, SCENES, NotRun, Point, plan
from interphase.envelope_verdict import BEYOND, FAILED, TOLD, verdict
from interphase.input_error import InputError
from interphase.tree import REPOSITORY, TOOLS


# One point of each kind: below, at and above where an explicit pressure force gives way
QUICK = [Point(*point) for point in (
    ("closed", "TDHS", 0.3, 0.3), ("closed", "TDHS", 0.4, 1.0), ("closed", "DEM", 0.4, 2.0), ("closed", "MPPIC", 0.3, 1.0),
    ("closed", "CGPM", 0.5, 3.0), ("fluidized", "CGHS", 0.4, 10.0), ("packed", "TDHS", 0.57, 0.8),
)]  # fmt: skip


def arguments():
    parser = argparse.ArgumentParser(prog="tools/envelope", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    several = {"nargs": "+", "metavar": "NAME"}
    numbers = {"nargs": "+", "type": float, "metavar": "X"}
    parser.add_argument("--scene", choices=SCENES, **several, default=list(SCENES), help="default: all")
    parser.add_argument("--method", choices=METHODS, **several, default=list(METHODS), help="default: all")
    parser.add_argument("--phi", **numbers, help="solid fractions (default: those of each scene)")
    parser.add_argument("--x", **numbers, default=list(RATIOS), help="gas steps over relaxation time (default: 1e-3 to 1e2)")
    parser.add_argument("--quick", action="store_true", help=f"{len(QUICK)} runs only, one core, less than 90 s")
    parser.add_argument("--ranks", type=int, default=1, metavar="N", help="MPI ranks of each run (default 1)")
    parser.add_argument("--jobs", type=int, metavar="N", help="runs at a time (default: cores over ranks; --quick: 1)")
    parser.add_argument("--out", default=os.path.join(REPOSITORY, "runs", "envelope"), metavar="DIR", help="default: runs/envelope")
    parser.add_argument("--fresh", action="store_true", help="run again what is there")
    parser.add_argument("--keep", action="store_true", help="keep the runs' folders; without it those that did not fail go")
    parser.add_argument("--longest", type=float, default=120, metavar="S", help="seconds after which a run is ended: failed (default 120)")
    given = parser.parse_args()
    if given.ranks < 1 or (given.jobs or 1) < 1:
        parser.error("--ranks and --jobs are 1 or more")
    if min(given.x) <= 0 or (given.phi and not all(0 < phi < 0.6 for phi in given.phi)):
        parser.error("--x must be above 0, --phi between 0 and 0.6")
    return given


def points(given):
    """All that is asked for; those that take long first, so that the last ones end together."""
    if given.quick:
        return QUICK
    chosen = [Point(scene, method, phi, ratio) for scene in given.scene for method in given.method
              for phi in (given.phi if given.phi and len(FRACTIONS[scene]) > 1 else FRACTIONS[scene]) for ratio in given.x
              if scene != "fine" or method not in ("DEM", "TDHS")]  # fmt: skip
    return chosen


def command(point, made, folder, ranks):
    line = [os.path.join(TOOLS, "run"), os.path.join(REPOSITORY, "cases", made.case), "--method", point.method, "--weight", f"{made.weight:g}",
            "--ranks", str(ranks), "--until", f"{made.until:.9g}", "--out", folder, "--overwrite", "--no-picture", "--quiet"]  # fmt: skip
    for key, value in made.settings.items():
        line += ["--set", f"{key}={value}"]
    return line


def run(point, given):
    """The row of a point: taken from an earlier call, or run, measured, and kept."""
    kept = os.path.join(given.out, point.name() + ("" if given.ranks == 1 else f"-{given.ranks}ranks"))
    if os.path.isfile(kept + ".json") and not given.fresh:
        with open(kept + ".json", encoding="utf-8") as file:
            return json.load(file)
    row = {"scene": point.scene, "method": point.method, "phi": point.phi, "ratio": point.ratio, "ranks": given.ranks}
    try:
        made = plan(point)
    except NotRun as reason:
        return {**row, "verdict": BEYOND, "seen": str(reason)}
    started = time.monotonic()
    program = subprocess.Popen(command(point, made, kept, given.ranks), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True, errors="replace")  # fmt: skip
    try:
        said, _ = program.communicate(timeout=given.longest)
        code = program.returncode
    except subprocess.TimeoutExpired:
        program.terminate()  # tools/run passes it on
        program.communicate()
        said, code = f"no end after {given.longest:g} s", -1
    if code == 2:
        raise InputError(said.strip())
    try:
        with open(os.path.join(kept, "log.interphase"), encoding="utf-8", errors="replace") as file:
            log = file.read()
    except FileNotFoundError:  # a step before the program failed
        raise InputError(f"{point.name()}: {said.strip()}") from None
    try:
        found = measure(kept, point, made)
    except InputError:
        found = None
    name, seen = (FAILED, said) if code == -1 else verdict(code, log, found)
    row.update(gas_step=made.step, steps=round(made.until / made.step), verdict=name, seen=seen, exit_code=code,
               wall_time=round(time.monotonic() - started, 2))  # fmt: skip
    if found and code == 0:
        row.update(error=found.worst()[1], rms=found.rms, alternation=found.alternation, books=found.closed)
    with open(kept + ".json", "w", encoding="utf-8") as file:
        json.dump(row, file, indent=1)
    if not given.keep and name != FAILED:
        shutil.rmtree(kept, ignore_errors=True)
    return row


def main():
    given = arguments()
    os.makedirs(given.out, exist_ok=True)
    chosen = points(given)
    jobs = given.jobs or (1 if given.quick else max(1, launch.cores() // given.ranks))

    def one(point):
        row = run(point, given)
        print(f"{point.name():<28} {row['verdict']:<23} {row.get('wall_time', 0):6.1f} s  {row['seen'][:150]}", flush=True)
        return row

    if chosen and not os.environ.get("INTERPHASE_BIN"):
        subprocess.run([os.path.join(TOOLS, "setup")], check=True)  # once, before several at a time would
    with ThreadPoolExecutor(jobs) as pool:
        rows = list(pool.map(one, chosen))
    envelope_map.write_csv(os.path.join(given.out, "map.csv"), rows)
    with open(os.path.join(given.out, "map.md"), "w", encoding="utf-8") as file:
        file.write(envelope_map.markdown(rows))
    envelope_map.draw(os.path.join(given.out, "map.png"), rows)
    print(envelope_map.markdown(rows))
    failed = [row for row in rows if row["verdict"] == FAILED]
    told = sum(row["verdict"] == TOLD for row in rows)
    print(f"{len(rows)} points, {told} told, {len(failed)} failed; map.png, map.csv and map.md are in {given.out}")
    return 1 if failed else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except InputError as error:
        sys.exit(f"envelope: {error}")
    except KeyboardInterrupt:
        sys.exit(130)
