# SPDX-License-Identifier: GPL-3.0-or-later
"""The tutorial's bed by interphase and by OpenFOAM's MPPICFoam and DPMFoam: height, pressure drop, and the time each takes.

Installs Debian's openfoam-examples where it is missing, copies the two tutorials Goldschmidt, changes in them what PEERS
says, and runs everything one after the other, on one core each. What --out holds already is not run again: call it once
more to go on, or to read and draw with other options. Every run goes through the same Python:

  height         twice the mean height of the tracked centres above the bottom [m]
  pressure drop  from 5 mm to 400 mm above the bottom; at each the mean over the cross-section, linear between layers of cells [Pa]
  CPU            seconds of the processor, without waiting for other programs; wall: with it
"""

import argparse
import json
import os
import re
import resource
import shutil
import subprocess
import sys
import time

import numpy

from interphase import Case, InputError, Run, foam_field, gas_fields, launch, parameters, tables

CASE = os.path.dirname(os.path.realpath(__file__))
REPOSITORY = os.path.dirname(os.path.dirname(CASE))
TOOLS = os.path.join(REPOSITORY, "tools")

TUTORIALS = "/usr/share/doc/openfoam-examples/examples/lagrangian"
TAPS = (0.005, 0.4)  # [m]
INTERVAL = 0.01  # between the times that all write [s]

CONTROL, CLOUD, GAS = "system/controlDict", "constant/kinematicCloudProperties", "constant/transportProperties"
LAW = ((CLOUD, "PlessisMasliyahDrag", "ErgunWenYuDrag"),)
# So that DPMFoam gets to where beds can be compared: contacts last (1e8/1e6)^0.4 = 6.3 times as long, and are resolved, at the
# 0.1 m/s at which most spheres meet, in about 20 steps (its own count of 6 is for twice the highest speed of all).
SOFT = (
    (GAS, "nu              1e-05;", "nu              1.568e-05;"),  # the gas of MPPICFoam's tutorial
    (CLOUD, "youngsModulus   1e8;", "youngsModulus   1e6;"),  # of particles and walls
    (CLOUD, "collisionResolutionSteps 12;", "collisionResolutionSteps 6;"),
    (CONTROL, "deltaT          2e-5;", "deltaT          1e-4;"),
    (CONTROL, "writeFormat     binary;", "writeFormat     ascii;"),
)
FINE = {"cells": "(30 2 90)"}

# What to run: name -> (program, what is changed in its tutorial), or entries of the case
PEERS = {
    "MPPICFoam": ("MPPICFoam", ()),
    "MPPICFoam-ErgunWenYu": ("MPPICFoam", LAW),
    "DPMFoam": ("DPMFoam", SOFT),
}
OURS = {
    "MPPIC": {"method": "MPPIC"},
    "DEM": {"method": "DEM", **FINE},
    "DEM-soft": {"method": "DEM", **FINE, "springConstant": 100},  # t_c = 1.0 ms, as DPMFoam's at 0.1 m/s
    "TDHS": {"method": "TDHS", **FINE},
    "CGPM": {"method": "CGPM", "weight": 8},
    "CGHS": {"method": "CGHS", "weight": 8},
}


def changed(folder, file, old, new):
    path = os.path.join(folder, file)
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    if old not in text:
        sys.exit(f"compare: '{old}' does not stand in {path}; the tutorial is not that of openfoam-examples 1912: adapt PEERS")
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text.replace(old, new))


def peer(folder, program, changes, until):
    """The tutorial of `program`, copied into `folder`, changed and run."""
    tutorial = os.path.join(TUTORIALS, program, "Goldschmidt")
    if not os.path.isdir(tutorial):
        code = subprocess.run([os.path.join(TOOLS, "setup"), "--no-build", "--with", "openfoam-examples"]).returncode
        if code != 0 or not os.path.isdir(tutorial):
            sys.exit(f"compare: there is no tutorial {tutorial}; the Debian package openfoam-examples brings it")
    shutil.copytree(tutorial, folder)
    for file, old, new in (*changes, (CONTROL, "endTime         5;", f"endTime         {until:g};")):
        changed(folder, file, old, new)
    environment = {**os.environ, **launch.additions(os.environ)}
    for command in ("blockMesh", program):
        launch.step([command], os.path.join(folder, f"log.{command}"), environment, folder)


def run(name, folder, until):
    """Runs what is called `name` in `folder`, and leaves there what it cost."""
    shutil.rmtree(folder, ignore_errors=True)
    print(f"compare: {name} to {until:g} s ...", flush=True)
    before, started = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    if name in PEERS:
        peer(folder, *PEERS[name], until)
    else:
        ran = Case(CASE).set(OURS[name]).run(folder, until=until)
        if not ran.ok:
            sys.exit(f"compare: {name} {ran.state}; its folder is {folder}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cost = {"wall": time.monotonic() - started,
            "cpu": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime}
    with open(os.path.join(folder, "cost.json"), "w", encoding="utf-8") as stream:
        json.dump(cost, stream)


def numbers(path, pattern):
    """What the groups of `pattern` match in the one list of the OpenFOAM file `path`, an array."""
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    listed = text[text.index("\n(\n") :]
    return numpy.array(re.findall(pattern, listed, re.M), dtype=float)


def pressure_drop(path, layers, height):
    """Between TAPS, of the file `p`, in its unit. blockMesh numbers cells layer by layer from the bottom."""
    field = foam_field.internal_field(path)
    if field.uniform:
        return 0.0  # at the start
    of_layer = field.values.reshape(layers, -1).mean(axis=1)
    z = (numpy.arange(layers) + 0.5) * height / layers
    low, high = numpy.interp(TAPS, z, of_layer)
    return low - high


def mesh(folder):
    """(cells along the height, the height [m]) of the run."""
    levels = numpy.unique(foam_field.points(folder)[:, 2].round(9))
    return len(levels) - 1, levels[-1] - levels[0]


def density(folder):
    return float(parameters.read(os.path.join(folder, GAS))["rho.air"])


def times(folder):
    """Names of the time folders after the start, in their order."""
    found = gas_fields.times(folder)
    return sorted((name for name in found if found[name] > 0 and os.path.exists(os.path.join(folder, name, "p"))), key=found.get)


def read(name, folder):
    """{time in intervals: (height, drop)}, and side views {time in intervals: centres [n, 2] of width and height, m}."""
    layers, height = mesh(folder)
    curve, centres = {}, {}
    if name in PEERS:
        unit = density(folder)
        for t in times(folder):
            try:
                found = numbers(os.path.join(folder, t, "lagrangian", "kinematicCloud", "positions"), r"^\(\S+ (\S+) (\S+)\)")
                drop = unit * pressure_drop(os.path.join(folder, t, "p"), layers, height)
            except (FileNotFoundError, ValueError, InputError):
                continue  # being written by a run that goes on
            key = round(float(t) / INTERVAL)
            centres[key] = found + (0.075, 0)
            curve[key] = (2 * found[:, 1].mean(), drop)
        return curve, centres
    drops = {round(float(t) / INTERVAL): pressure_drop(os.path.join(folder, t, "p"), layers, height) for t in times(folder)}
    for snapshot in Run(folder).snapshots:
        key = round(snapshot.time / INTERVAL)
        if key in drops:
            centres[key] = snapshot.positions[:, (0, 2)]
            curve[key] = (2 * centres[key][:, 1].mean(), drops[key])
    return curve, centres


def cost(folder):
    with open(os.path.join(folder, "cost.json"), encoding="utf-8") as stream:
        return json.load(stream)


def table(curves, folders, since, until):
    """Means from `since` to `until` with the deviation in brackets, and root mean square differences from DPMFoam's curve."""
    print("\n" + tables.markdown_head(("", "height [mm]", "drop [Pa]", "lowest height [mm]", "highest drop [Pa]", "off DPMFoam [mm, Pa]",
                                       "wall [s per s]", "CPU [s per s]")))  # fmt: skip
    reference = curves.get("DPMFoam", {})
    for name, curve in curves.items():
        folder = folders[name]
        keys = [k for k in sorted(curve) if since <= k * INTERVAL + 1e-9 and k * INTERVAL <= until + 1e-9]
        if not keys:
            print(tables.markdown_row((name, f"nothing from {since:g} to {until:g} s", *6 * [""])))
            continue
        values = numpy.array([curve[k] for k in keys])
        whole = numpy.array([curve[k] for k in sorted(curve) if k * INTERVAL <= until + 1e-9])
        if keys[-1] < round(until / INTERVAL):
            name += f" (to {keys[-1] * INTERVAL:.2f} s)"
        common = [k for k in sorted(curve) if k in reference and k * INTERVAL <= until + 1e-9]
        off = numpy.sqrt(numpy.mean([(numpy.array(curve[k]) - reference[k]) ** 2 for k in common], axis=0)) if common else (0, 0)
        end = max(curve) * INTERVAL
        spent = {what: seconds / end for what, seconds in cost(folder).items()}
        print(tables.markdown_row((
            name, f"{1e3 * values[:, 0].mean():.0f}", f"{values[:, 1].mean():.0f} ({values[:, 1].std():.0f})",
            f"{1e3 * whole[:, 0].min():.1f}", f"{whole[:, 1].max():.0f}", f"{1e3 * off[0]:.1f}, {off[1]:.0f}", f"{spent['wall']:.0f}",
            f"{spent['cpu']:.0f}")))


def draw(curves, views, path, moment):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure = pyplot.figure(figsize=(12, 8.5), layout="constrained")
    grid = figure.add_gridspec(2, max(2, len(curves)))
    half = max(2, len(curves)) // 2
    height, drop = figure.add_subplot(grid[0, :half]), figure.add_subplot(grid[0, half:])
    colours = {}
    for name, curve in curves.items():
        keys = sorted(curve)
        t = numpy.array(keys) * INTERVAL
        style = {"lw": 2.5, "alpha": 0.8} if name in PEERS else {"lw": 1.3, "ls": "--"}
        (line,) = height.plot(t, [1e3 * curve[k][0] for k in keys], label=name, **style)
        colours[name] = line.get_color()
        drop.plot(t, [curve[k][1] / 1e3 for k in keys], color=line.get_color(), **style)
    height.set(xlabel="time [s]", ylabel="bed height [mm]")
    drop.set(xlabel="time [s]", ylabel="pressure drop [kPa]")
    height.legend(frameon=False, fontsize=8)
    for column, (name, centres) in enumerate(views.items()):
        axes = figure.add_subplot(grid[1, column])
        key = min(round(moment / INTERVAL), max(centres))
        axes.plot(*(1e3 * centres[key]).T, ".", ms=1.2 if len(centres[key]) > 10000 else 3.2, color=colours[name], mew=0)
        axes.set(xlim=(0, 150), ylim=(0, 450), aspect="equal", xticks=[], yticks=[])
        axes.set_title(f"{name.replace('-', chr(10))}\n{key * INTERVAL:.2f} s", fontsize=7)
    figure.savefig(path, dpi=90)
    print(f"compare: drawn in {path}")


def arguments():
    names = [*PEERS, *OURS]
    parser = argparse.ArgumentParser(prog="compare", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"what to run and show (default: all of {' '.join(names)})")
    parser.add_argument("--until", type=float, default=0.5, metavar="T", help="simulated seconds (default 0.5)")
    parser.add_argument("--since", type=float, default=0.2, metavar="T", help="means are from here on [s] (default 0.2)")
    parser.add_argument("--moment", type=float, default=0.3, metavar="T", help="of the side views [s] (default 0.3)")
    parser.add_argument("--out", default=os.path.join(REPOSITORY, "runs", "goldschmidt"), metavar="DIR", help="(default runs/goldschmidt)")
    parser.add_argument("--read", action="store_true", help="run nothing; show what is there, also of runs that go on or were stopped")
    options = parser.parse_args()
    for name in options.names:
        if name not in names:
            parser.error(f"'{name}' is unknown; valid names: {', '.join(names)}")
    if not INTERVAL <= options.since < options.until:
        parser.error(f"--since {options.since:g} and --until {options.until:g}: give {INTERVAL:g} <= since < until, in s")
    options.names = options.names or names
    return options


def main():
    options = arguments()
    folders = {name: os.path.join(os.path.abspath(options.out), name) for name in options.names}
    for name, folder in folders.items():
        if not options.read and not os.path.exists(os.path.join(folder, "cost.json")):
            run(name, folder, options.until)
    found = {name: read(name, folder) for name, folder in folders.items() if os.path.exists(os.path.join(folder, "cost.json"))}
    if not found:
        sys.exit(f"compare: no finished run in {options.out}")
    table({name: curve for name, (curve, _) in found.items()}, folders, options.since, options.until)
    draw({n: c for n, (c, _) in found.items()}, {n: v for n, (_, v) in found.items()}, os.path.join(options.out, "compare.png"), options.moment)


if __name__ == "__main__":
    main()
