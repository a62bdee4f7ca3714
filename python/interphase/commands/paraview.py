# SPDX-License-Identifier: GPL-3.0-or-later
"""Write a script by which ParaView opens a run: spheres at true size by their vertical velocity, the gas in the middle plane beside
them, the walls, seen from the front.

The script is RUN/show-in-paraview.py: `paraview --script=RUN/show-in-paraview.py` opens the run in ParaView, `pvpython RUN/show-in-paraview.py --screenshot FILE` draws
it without a window. It stands on its own, and moves with the folder.
"""

import argparse
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile

import numpy

from interphase import command_line, exits, gas_mesh, paraview_files
from interphase.commands.picture import span
from interphase.input_error import InputError
from interphase.picture_quantities import GAS
from interphase.picture_scales import Scales
from interphase.picture_scene import Scene, view

SCRIPT = "show-in-paraview.py"  # paraview.py would hide ParaView's own module
PIXELS = (1100, 900)


def arguments():
    parser = argparse.ArgumentParser(prog="tools/paraview", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", metavar="RUN", help="a run's folder (with particles.xdmf)")
    parser.add_argument("--screenshot", metavar="FILE", help="draw it, too; on a machine without a display by xvfb-run")
    parser.add_argument("--time", metavar="T", type=command_line.number, help="of the screenshot, in s (default: the last snapshot's)")
    parser.add_argument("--gas", metavar="NAME", default="voidage", help="a field of the gas, such as voidage, p_rgh, or none (default: voidage)")
    parser.add_argument("--range", metavar="LOW,HIGH", type=span, help="of the vertical velocity; --range=-1,1 where LOW is negative")
    parser.add_argument("--gas-range", metavar="LOW,HIGH", type=span, help="of the gas")
    return parser.parse_args()


def facts(given):
    """What the script has to know of the run, a dict of numbers and texts; and the names of surfaces that move."""
    scene = Scene(given.run)
    if not os.path.isfile(os.path.join(given.run, "particles.xdmf")):
        raise InputError(f"{given.run} holds no particles.xdmf, by which ParaView opens the snapshots: keep it beside particles.h5")
    scales = Scales([scene], "vertical_velocity", ends=given.range)
    (left, right, bottom, top), _ = view([scene], scales.samples)
    gas = None if given.gas == "none" or not gas_mesh.pieces(given.run) else given.gas
    parts = scene.gas.times(gas) if gas else {}
    if gas and not parts:
        if given.gas != "voidage":
            raise InputError(f"{given.run}: no {gas} of the gas was written")
        print(f"tools/paraview: {given.run}: no voidage of the gas was written: it is left out", file=sys.stderr)
        gas = None
    decomposed = bool(parts) and os.path.basename(os.path.dirname(parts[max(parts)][0])).startswith("processor")
    return {
        "folder": os.path.abspath(given.run), "title": "  ".join(scene.title) + "\n" + "  ".join(scene.operating_point),
        "low": [left, float(scene.depth[0]), bottom], "high": [right, float(scene.depth[1]), top], "y": float(scene.walls.y),
        "range": list(scales.ends), "gas": gas, "gas range": list(given.gas_range or gas_range(scene, gas)) if gas else None,
        "foam": paraview_files.foam_file(given.run) if gas else None, "decomposed": decomposed,
        "surfaces": paraview_files.surfaces(scene), "pixels": list(PIXELS),
    }, [each.name for each in scene.walls.script.surfaces if each.motion]  # fmt: skip


def gas_range(scene, gas):
    """That of tools/picture for what it draws, else the ends of the last field."""
    if gas in GAS:
        return Scales([scene], "vertical_velocity", gas).gas_ends
    values = scene.gas.nearest(gas, scene.times[-1]).values
    values = numpy.linalg.norm(values, axis=1) if values.ndim > 1 else values  # ParaView colours vectors by their magnitude
    return float(values.min()), float(values.max())


def screenshot(script, given):
    """By ParaView's Python, on the display or one of its own."""
    python = shutil.which("pvpython") or (sys.executable if importlib.util.find_spec("paraview") else None)
    if python is None:
        raise InputError(f"ParaView's Python is missing: tools/setup --no-build --with paraview (on Debian also apt-get install paraview); {script} is "
                         "written")  # fmt: skip
    display = []
    if not os.environ.get("DISPLAY"):
        if shutil.which("xvfb-run") is None:
            raise InputError(f"there is no display, and xvfb-run is missing: tools/setup --no-build --with xvfb --with xauth; {script} is written")
        # -noreset: ParaView connects, leaves and connects again, and a server that starts afresh in between refuses the second.
        display = ["xvfb-run", "--server-num", str(100 + os.getpid() % 10000), "-s", "-screen 0 1280x1024x24 -noreset"]
    with tempfile.TemporaryDirectory(prefix="interphase-paraview-") as folder:
        drawn = os.path.join(folder, "picture.png")
        words = [*display, python, script, "--screenshot", drawn, *(["--time", str(given.time)] if given.time is not None else [])]
        done = subprocess.run(words, capture_output=True, text=True, env={"LIBGL_ALWAYS_SOFTWARE": "1", **os.environ} if display else None)
        if done.returncode or not os.path.isfile(drawn):
            raise InputError(f"ParaView did not draw {given.screenshot} (code {done.returncode}):\n{(done.stdout + done.stderr)[-2000:]}")
        shutil.move(drawn, given.screenshot)


def main():
    given = arguments()
    if given.screenshot and not given.screenshot.endswith(".png"):
        raise InputError(f"--screenshot {given.screenshot}: the name of a picture ends in .png")
    known, moving = facts(given)
    script = os.path.join(given.run, SCRIPT)
    with open(paraview_files.TEMPLATE, encoding="utf-8") as stream:
        text = stream.read()
    with open(script, "w", encoding="utf-8") as stream:
        stream.write(text.replace("RUN = {}", f"RUN = {paraview_files.literal(known)}", 1))
    for surface in moving:
        print(f"tools/paraview: {surface} moves: ParaView shows it where it starts (tools/picture: where it is)", file=sys.stderr)
    print(script)
    if given.screenshot:
        screenshot(script, given)
        print(given.screenshot)
    else:
        print(f"paraview --script={script}")


if __name__ == "__main__":
    exits.of_drawing(main, "tools/paraview")
