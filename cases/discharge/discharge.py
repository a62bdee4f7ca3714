# SPDX-License-Identifier: GPL-3.0-or-later
"""Discharge of a box through a slot in its floor, by LIGGGHTS's own DEM or by hard spheres: rate and angle of repose.

Every run has a folder <out>/<engine>-<label>-seed<n> with what LIGGGHTS read and wrote. In the end
all runs below --out are put together in a table: mean over seeds, its standard error, difference from the first group with the same floor and rolling friction.
"""

import argparse
import itertools
import json
import math
import os
import shutil
import sys
import time

import numpy

from interphase import InputError, data_file, launch, tables
from interphase.liggghts_dump import Dump
from interphase.stl import write_stl

CASE = os.path.dirname(os.path.realpath(__file__))
ROOT = os.path.dirname(os.path.dirname(CASE))

# The spheres and their contacts are those of cases/sscp1.
DIAMETER = 3.256e-3  # [m]
MATERIAL = {
    "weight": 1, "diameter": DIAMETER, "particleDensity": 1131, "springConstant": 800,
    "restitution": 0.84, "tangentialRestitution": 0.84, "wallRestitution": 0.92, "wallTangentialRestitution": 0.92,
    "friction": 0.35, "wallFriction": 0.35, "gravity": 9.81,
}  # fmt: skip
MASS = MATERIAL["particleDensity"] * math.pi / 6 * DIAMETER**3
COLLISION_TIME = math.sqrt(0.5 * MASS / MATERIAL["springConstant"] * (math.pi**2 + math.log(MATERIAL["restitution"]) ** 2))

VARIABLES = "variables.json"  # of the scripts, in each run's folder

# Geometry [m]; the depth is an option
WIDTH, SLOT = 40 * DIAMETER, 8 * DIAMETER
COUNT = 6000
START_PACKING = 0.40

FILL = 0.45  # [s]
RECORD, SNAPSHOT = 0.005, 0.15  # [s]
CREEPING = 2  # snapshots over which the pile is watched in the end

# The steady part of the discharge: between these shares of all spheres
FROM, TO = 0.10, 0.50


def rectangle(x0, x1, depth):
    """Two triangles of the floor, z = 0."""
    a, b, c, d = (x0, 0, 0), (x1, 0, 0), (x1, depth, 0), (x0, depth, 0)
    return [(a, b, c), (a, c, d)]


def glued(random, depth):
    """Centres of spheres that make the floor rough: rows on it, up to the lip, with gaps of up to half a diameter."""
    pitch = 1.25 * DIAMETER
    length = 0.5 * (WIDTH - SLOT)
    nx, ny = int(length / pitch), int(depth / pitch)
    spacing = numpy.array([length / nx, depth / ny])
    found = []
    for start in (0.0, 0.5 * (WIDTH + SLOT)):
        site = numpy.stack(numpy.meshgrid(numpy.arange(nx), numpy.arange(ny), indexing="ij"), axis=-1).reshape(-1, 2)
        place = [start, 0.0] + (site + 0.5) * spacing + random.uniform(-0.45, 0.45, site.shape) * (spacing - DIAMETER)
        found.append(numpy.column_stack([place, numpy.full(len(place), 0.5 * DIAMETER)]))
    return numpy.concatenate(found)


def write_bed(path, options, seed):
    """A loose jittered lattice above the floor, thrown about at up to 0.5 m/s so that nothing of the lattice stays."""
    count, depth = options.count, options.depth * DIAMETER
    random = numpy.random.default_rng(seed)
    pitch = (math.pi / 6 / START_PACKING) ** (1 / 3) * DIAMETER
    nx, ny = int(WIDTH / pitch), int(depth / pitch)
    # few spheres over a shallow depth stand far apart, and would overlap upwards
    spacing = numpy.array([WIDTH / nx, depth / ny, max(pitch**3 / (WIDTH / nx * depth / ny), 1.03 * DIAMETER)])
    number = numpy.arange(count)
    site = numpy.stack([number % nx, number // nx % ny, number // (nx * ny)], axis=1)
    centres = (site + 0.5) * spacing + random.uniform(-0.45, 0.45, (count, 3)) * (spacing - DIAMETER)
    velocities = random.uniform(-0.5, 0.5, (count, 3))
    if options.rough:
        centres[:, 2] += DIAMETER
        centres = numpy.concatenate([centres, glued(random, depth)])
        velocities = numpy.concatenate([velocities, numpy.zeros((len(centres) - count, 3))])
    top = 1.5 * centres[:, 2].max()
    beyond = DIAMETER * numpy.array([2, 0 if options.periodic else 2, 20])
    data_file.write(path, f"{len(centres)} spheres", -beyond, numpy.array([WIDTH, depth, top]) + beyond, centres, DIAMETER,
                    MATERIAL["particleDensity"], velocity=velocities)  # fmt: skip


def prepare(folder, options, seed):
    os.makedirs(folder)
    for source in (os.path.join(CASE, "dem", "in.liggghts"), os.path.join(ROOT, "cases", "sscp1", "dem", "contact.liggghts")):
        shutil.copy(source, folder)
    shutil.copy(os.path.join(CASE, "dem", f"{options.engine}.liggghts"), os.path.join(folder, "engine.liggghts"))
    left, right = 0.5 * (WIDTH - SLOT), 0.5 * (WIDTH + SLOT)
    depth = options.depth * DIAMETER
    write_stl(os.path.join(folder, "floor.stl"), {"surface": rectangle(0, left, depth) + rectangle(right, WIDTH, depth)})
    write_stl(os.path.join(folder, "plug.stl"), {"surface": rectangle(left, right, depth)})
    write_bed(os.path.join(folder, "bed.data"), options, seed)


def variables(options):
    hard = options.engine == "tdhs"
    if hard:
        style = "tdhs/rolling" if options.rolling else "tdhs"
    else:
        style = "hooke/stiffness tangential history" + " rolling_friction epsd2" * bool(options.rolling)
    step = options.step * COLLISION_TIME
    given = {
        **MATERIAL, "count": options.count, "hard": int(hard), "width": WIDTH, "depth": options.depth * DIAMETER, "solidStep": step,
        "skin": (0.6 if hard else 0.25) * DIAMETER, "periodic": int(options.periodic), "sides": "p" if options.periodic else "f",
        "style": style, "rollingFriction": options.rolling, "rollingStiffness": 71, "rollingDamping": 0.3, "words": options.tdhs,
    }  # fmt: skip
    for name, duration in (("fillSteps", FILL), ("dischargeSteps", options.seconds), ("recordSteps", RECORD), ("dumpSteps", SNAPSHOT)):
        given[name] = max(1, round(duration / step))
    for setting in options.set:
        name, _, value = setting.partition("=")
        if name not in given:
            sys.exit(f"run: --set {setting}: no such variable; known: {', '.join(given)}")
        given[name] = value
    return given


def simulate(folder, options, seed):
    given = variables(options)
    prepare(folder, options, seed)
    with open(os.path.join(folder, VARIABLES), "w", encoding="utf-8") as file:
        json.dump(given, file, indent=1)
        file.write("\n")
    start = time.monotonic()
    try:
        launch.liggghts("in.liggghts", folder, given, None if options.engine == "dem" else ["laws" if options.rolling else "hard_sphere"])
    except (InputError, launch.StepFailed) as error:
        sys.exit(f"run: {error}")
    return time.monotonic() - start


def snapshots(path):
    """Of a dump: (step, rows `id x y z` [n, 4]) one by one."""
    for frame in Dump(path, [path]).frames():
        state = frame.load()
        yield frame.step, numpy.column_stack([state.ids, state.quantities["position"]])


def surface(centres, depth, periodic):
    """Height of the highest centres over columns of a grid: (x [n], height [n]), averaged over the depth."""
    step = 0.5 * DIAMETER
    xs = numpy.arange(0.5 * DIAMETER, WIDTH - 0.5 * DIAMETER + 1e-9, step)
    ys = numpy.arange(0, depth - 0.5 * step, step) if periodic else numpy.arange(DIAMETER, depth - DIAMETER + 1e-9, step)
    heights = numpy.zeros((len(xs), len(ys)))
    for i, x in enumerate(xs):
        near = centres[abs(centres[:, 0] - x) < 0.75 * DIAMETER]
        for j, y in enumerate(ys):
            aside = near[:, 1] - y
            if periodic:
                aside -= depth * numpy.round(aside / depth)
            column = near[(near[:, 0] - x) ** 2 + aside**2 < (0.75 * DIAMETER) ** 2]
            heights[i, j] = column[:, 2].max() if len(column) else 0.0
    return xs, heights.mean(axis=1)


def angles(xs, heights):
    """Of the slopes left and right of the slot [degrees], the ends at the slot and at the wall left out."""
    left, right = 0.5 * (WIDTH - SLOT), 0.5 * (WIDTH + SLOT)
    found = []
    for part, sign in ((xs < left - 2.5 * DIAMETER) & (xs > 2.5 * DIAMETER), -1), (
        (xs > right + 2.5 * DIAMETER) & (xs < WIDTH - 2.5 * DIAMETER), 1):  # fmt: skip
        slope = numpy.polyfit(xs[part], heights[part], 1)[0]
        found.append(math.degrees(math.atan(sign * slope)))
    return found


def creep(then, rows, free):
    """How far the `free` spheres above the floor moved between two snapshots, on average along x and z [d]."""
    _, first, last = numpy.intersect1d(then[:, 0], rows[free & (rows[:, 3] > 0), 0], return_indices=True)
    moved = rows[free & (rows[:, 3] > 0)][last][:, [1, 3]] - then[first][:, [1, 3]]
    return float(numpy.linalg.norm(moved, axis=1).mean() / DIAMETER)


def scene_of(folder):
    """The variables of the scripts {name: value} of a run."""
    try:
        with open(os.path.join(folder, VARIABLES), encoding="utf-8") as file:
            return json.load(file)
    except FileNotFoundError:
        sys.exit(f"run: {folder}: there is no {VARIABLES} in it, as in runs of older versions; run it again, or take it away")


def measure(folder):
    scene = scene_of(folder)
    record = numpy.loadtxt(os.path.join(folder, "record.txt"), comments=("#", "time"))
    t, above, kinetic = record.T
    out = MASS * (above[0] - above)
    share = out / (MASS * above[0])
    part = (share > FROM) & (share < TO)
    rate = numpy.polyfit(t[part], out[part], 1)[0]
    # the last snapshot that runs with other steps have, too
    wanted = math.floor((t[-1] - 0.05) / SNAPSHOT)
    then, *_, rows = (rows for _, rows in itertools.islice(snapshots(os.path.join(folder, "snapshots.dump")), wanted - CREEPING, wanted + 1))
    centres = rows[:, 1:]
    beside_slot = abs(centres[:, 0] - 0.5 * WIDTH) > 0.5 * SLOT
    free = rows[:, 0] <= above[0]  # the others are glued
    filled = t <= FILL
    left, right = angles(*surface(centres[centres[:, 2] > 0], scene["depth"], scene["periodic"]))
    return {
        "rate": rate, "steady": [float(t[part][0]), float(t[part][-1])], "left": left, "right": right,
        "angle": 0.5 * (left + right),
        "height": float(centres[beside_slot & free & (centres[:, 2] > 0), 2].mean() / DIAMETER), "remaining": int(above[-1]),
        "rolling": scene["rollingFriction"], "creep": creep(then, rows, free) / (CREEPING * SNAPSHOT),
        "kinetic_energy_before": float(kinetic[filled][-1]), "kinetic_energy_after": float(kinetic[-1]),
    }  # fmt: skip


def table(out):
    groups = {}
    for name in sorted(os.listdir(out)):
        path = os.path.join(out, name, "wall_time")
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                wall_time = float(file.read())
            result = {**measure(os.path.join(out, name)), "wall_time": wall_time}
            groups.setdefault(name.rsplit("-seed", 1)[0], []).append(result)
    rows = [("", "seeds", "rate [g/s]", "angle [deg]", "mean height [d]", "left behind", "creeps [d/s]", "at rest [J]", "wall time [s]")]
    firsts = {}  # of each floor and rolling friction
    for name, runs in groups.items():
        scene = name.endswith("-rough"), runs[0]["rolling"]
        first = firsts.get(scene)
        cells = []
        means = {}
        for key, scale in (("rate", 1e3), ("angle", 1), ("height", 1), ("remaining", 1)):
            values = scale * numpy.array([run[key] for run in runs])
            error = values.std(ddof=1) / math.sqrt(len(values)) if len(values) > 1 else math.nan
            means[key] = values.mean()
            against = "" if first is None else f" {100 * (means[key] / first[key] - 1):+5.1f}%"
            cells.append(f"{means[key]:.2f} +- {error:.2f}{against}")
        firsts.setdefault(scene, means)
        rest = max(run["kinetic_energy_after"] for run in runs)
        wall = numpy.mean([run["wall_time"] for run in runs])
        creeping = numpy.mean([run["creep"] for run in runs])
        rows.append((name, str(len(runs)), *cells, f"{creeping:.1e}", f"{rest:.1e}", f"{wall:.0f}"))
    print("\n".join(tables.columns(rows)))


def arguments():
    parser = argparse.ArgumentParser(prog="run", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--engine", choices=("dem", "tdhs"), help="whose contacts (default: run nothing, read --out)")
    parser.add_argument("--step", type=float, metavar="S", help="solid step over the collision time (default dem 0.05, tdhs 1)")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3, 4], metavar="N", help="of the start (default 1 2 3 4)")
    parser.add_argument("--label", help="of the runs (default: the step)")
    parser.add_argument("--out", default=os.path.join(ROOT, "runs", "discharge"), metavar="DIR", help="(default runs/discharge)")
    parser.add_argument("--rough", action="store_true", help="spheres are glued to the floor, so that none can roll off on it")
    parser.add_argument("--seconds", type=float, default=1.75, metavar="T", help="from the opening to the end (default 1.75)")
    parser.add_argument("--rolling", type=float, default=0.0, metavar="MU", help="rolling friction, of all contacts (default 0); DEM: epsd2, TDHS: tdhs/rolling")
    parser.add_argument("--depth", type=int, default=8, metavar="N", help="of the box, in diameters (default 8)")
    parser.add_argument("--periodic", action="store_true", help="no walls in front and behind: the box repeats along its depth")
    parser.add_argument("--count", type=int, default=COUNT, metavar="N", help=f"spheres (default {COUNT})")
    parser.add_argument("--tdhs", default="", metavar="WORDS", help="of fix tdhs, such as 'passes 8' (default none)")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="a variable of the scripts, e.g. friction=0.3")
    options = parser.parse_args()
    if options.step is None:
        options.step = 0.05 if options.engine == "dem" else 1.0
    if not 0 <= options.rolling < math.inf:
        parser.error(f"--rolling {options.rolling:g}: give 0 or more")
    if options.depth < 3:
        parser.error(f"--depth {options.depth}: give 3 diameters or more; a sphere may not touch another one on two sides")
    return options


def main():
    options = arguments()
    options.out = os.path.abspath(options.out)
    os.makedirs(options.out, exist_ok=True)
    if options.engine:
        label = (options.label or f"{options.step:g}tc") + f"-roll{options.rolling:g}" * bool(options.rolling) + "-rough" * options.rough
        for seed in options.seeds:
            folder = os.path.join(options.out, f"{options.engine}-{label}-seed{seed}")
            shutil.rmtree(folder, ignore_errors=True)
            wall_time = simulate(folder, options, seed)
            with open(os.path.join(folder, "wall_time"), "w", encoding="utf-8") as file:
                file.write(f"{wall_time:.1f}\n")
            result = measure(folder)
            print(f"{os.path.basename(folder)}: {1e3 * result['rate']:.2f} g/s, {result['angle']:.2f} deg, {result['height']:.3f} d, "
                  f"creeps {result['creep']:.1e} d/s, {wall_time:.0f} s", flush=True)
    table(options.out)


if __name__ == "__main__":
    main()
