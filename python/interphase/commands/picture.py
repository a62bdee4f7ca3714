# SPDX-License-Identifier: GPL-3.0-or-later
"""Draw the bed of a run seen from the front: every tracked sphere at its true size, the walls, the gas beside it, and curves over time.

x runs to the right and z up; what is nearer to the front wall (small y) covers what is behind.
"""

import argparse
import os
import sys

import numpy

from interphase import command_line, exits, picture_curves, picture_figure, picture_law
from interphase.input_error import InputError
from interphase.picture_quantities import GAS, PARTICLES, range_text
from interphase.picture_scales import Scales
from interphase.picture_scene import Scene, view

PANELS = 4  # snapshots in a strip
DPI = 200

DESCRIPTION = f"""Draw a run from the front: a strip of up to {PANELS} evenly spaced times, spheres at true size in colours, the walls in the middle
plane, the gas there beside them, above curves over time. A run of few particles is drawn as their velocity and
height over time, beside what the drag law makes of them; a packing that is held with its pressure over the height."""

EPILOG = """colours
  One range holds for all that a call draws: for all times and all runs. By default it is a round number (1, 2 or 5 and
  zeros) above 98 % of the values of 8 snapshots spread over each run; a voidage goes from 0.4 to 1. It is printed, and
  --range, --gas-range with it make other pictures alike.

walls
  black: walls of the gas mesh in the middle plane, and of the particles (planes, cylinders, STL files; of these the edges,
  too, in their place at that time); blue: patches that gas passes; green: surfaces that let particles in or out.
  Those of the particles are read from dem/log.liggghts.

gas
  By default the voidage, where the run has written it at the times shown; those times are preferred. --gas takes the time
  that is nearest and says it above the panel.

examples
  tools/picture runs/sscp1-CGPM-w8
  tools/picture runs/sscp1-CGPM-w8 --time 0.5 --gas velocity -o bed-0.5s.png
  tools/picture runs/a runs/b --colour speed --range 0,2 -o both.png"""


def span(text):
    try:
        return range_text(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def add_looks(parser):
    """The options that tools/film has, too."""
    parser.add_argument("--colour", metavar="NAME", choices=PARTICLES, default=None,
                        help=f"of the spheres, by {', '.join(PARTICLES)} (default: vertical_velocity; force where nothing moves)")  # fmt: skip
    parser.add_argument("--range", metavar="LOW,HIGH", type=span, help="of their colours; --range=-1,1 where LOW is negative")
    parser.add_argument("--gas", metavar="NAME", choices=[*GAS, "none"], help=f"beside the particles: {', '.join(GAS)} or none")
    parser.add_argument("--gas-range", metavar="LOW,HIGH", type=span, help="of the colours of the gas")


def arguments():
    parser = argparse.ArgumentParser(prog="tools/picture", formatter_class=argparse.RawDescriptionHelpFormatter,
                                     description=DESCRIPTION, epilog=EPILOG)  # fmt: skip
    parser.add_argument("runs", metavar="RUN", nargs="+", help="a run's folder (with particles.h5); of several, a strip for each")
    parser.add_argument("-o", "--output", metavar="FILE", help="the picture (default: bed.png in the first RUN)")
    parser.add_argument("--time", metavar="T", type=command_line.number, help="one snapshot instead of a strip, that nearest to T, in s")
    parser.add_argument("--dpi", metavar="N", type=command_line.positive, default=DPI, help=f"pixels per inch (default {DPI})")
    add_looks(parser)
    return parser.parse_args()


def colour_of(given, scenes):
    return given.colour or ("force" if all(scene.held and "force" in scene.snapshots[-1].names for scene in scenes) else "vertical_velocity")


def gas_of(given, scenes, times):
    """The name of GAS to be drawn, or None; by default where it was written at the times shown."""
    if given.gas == "none":
        return None
    if given.gas:
        return given.gas
    return "voidage" if all(scene.has_gas_at(time, GAS["voidage"][0]) for scene, each in zip(scenes, times) for time in each) else None


def snapshots_of(given, scene, count, until):
    if given.time is not None:
        return [scene.snapshots[int(numpy.argmin(numpy.abs(scene.times - given.time)))]]
    return scene.chosen(count, None if given.gas == "none" else given.gas or "voidage", until)


def picture_of(given, scenes):
    """The matplotlib figure, and what to say of it."""
    if len(scenes) == 1 and scenes[0].few and given.time is None and not given.colour and not given.gas:
        return picture_figure.paths(scenes[0]), ""
    held = len(scenes) == 1 and scenes[0].held
    until = min(scene.times[-1] for scene in scenes)  # so that strips of several runs are of like times
    chosen = [snapshots_of(given, scene, 1 if held else PANELS, until) for scene in scenes]
    gas = gas_of(given, scenes, [[each.time for each in part] for part in chosen])
    scales = Scales(scenes, colour_of(given, scenes), gas, given.range, given.gas_range)
    shown = [[scene.shown(each, scales.colour, gas) for each in part] for scene, part in zip(scenes, chosen)]
    every = [each for part in shown for each in part]
    profile = None
    if held and gas == "voidage":
        at = every[-1].gas.time
        if all(scenes[0].has_gas_at(at, field) for field in ("p_rgh", "U")):
            profile = picture_law.profile(scenes[0], every[-1].gas, *(scenes[0].gas.nearest(field, at) for field in ("p_rgh", "U")))
    curves = picture_curves.curves_of(scenes) if given.time is None else ()
    colours, of_gas = scales.colours(every)
    drawn = picture_figure.Picture(scenes, shown, *view(scenes, every), colours, gas, of_gas, curves, profile)
    return drawn.figure(), scales.words()


def main():
    given = arguments()
    scenes = [Scene(path) for path in given.runs]
    for scene in scenes:
        for note in scene.walls.script.notes:
            print(f"tools/picture: {scene.name}: {note}", file=sys.stderr)
    figure, words = picture_of(given, scenes)
    output = given.output or os.path.join(given.runs[0], "bed.png")
    figure.savefig(output, dpi=given.dpi)
    print(output)
    if words:
        print(words)


if __name__ == "__main__":
    exits.of_drawing(main, "tools/picture")
