# SPDX-License-Identifier: GPL-3.0-or-later
"""Make a film of a run: a frame of every snapshot, as tools/picture draws them, with one colour scale and one view."""

import argparse
import os
import sys

import matplotlib.pyplot as plt
import numpy

from interphase import command_line, exits, film
from interphase.commands import picture
from interphase.input_error import InputError
from interphase.picture_figure import Picture
from interphase.picture_scales import Scales
from interphase.picture_scene import Scene, evenly_spaced, view

RATE = 25.0  # frames a second
READABLE = 100.0  # pixels per inch at which words of 8 points are read
AROUND = 1.2  # inches above and below the panels
SPREAD = 25  # snapshots of which the view is taken: all of a long run would be read twice

EPILOG = """The colours are those of tools/picture --help, with one range for the whole film; the gas is that of the time that is nearest,
which is said above it. A run that is still going is filmed as far as its snapshots are whole.

examples
  tools/film runs/sscp1-CGPM-w8
  tools/film runs/sscp1-CGPM-w8 -o bed.webp --speed 0.5 --height 360
  tools/film runs/sscp1-CGPM-w8 --gas voidage --range=-1,1 --from 0.5 --to 2"""


def arguments():
    parser = argparse.ArgumentParser(prog="tools/film", description=__doc__, epilog=EPILOG, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", metavar="RUN", help="a run's folder (with particles.h5)")
    parser.add_argument("-o", "--output", metavar="FILE", help="the film, by its end .mp4, .webp or .gif (default: RUN/bed.mp4)")
    pace = parser.add_mutually_exclusive_group()
    pace.add_argument("--fps", metavar="N", type=command_line.positive, help=f"frames, that is snapshots, a second (default {RATE:g})")
    pace.add_argument("--speed", metavar="S", type=command_line.positive, help="simulated seconds in a second of the film; 1: as fast as it was")
    parser.add_argument("--from", metavar="T", type=command_line.number, dest="start", default=-numpy.inf, help="the first snapshot's time at least, in s")
    parser.add_argument("--to", metavar="T", type=command_line.number, dest="end", default=numpy.inf, help="the last one's at most, in s")
    parser.add_argument("--height", metavar="PIXELS", type=command_line.positive, default=720.0, help="of the film (default 720)")
    picture.add_looks(parser)
    return parser.parse_args()


def rate_of(given, times):
    """Frames a second."""
    if given.speed is None or len(times) < 2:
        return given.fps or RATE
    apart = numpy.diff(times)
    if apart.max() > 1.5 * apart.min():
        print(f"tools/film: warning: snapshots are {apart.min():.4g} to {apart.max():.4g} s apart, and each is shown as long as the others: the film "
              "runs at --speed on the mean", file=sys.stderr)  # fmt: skip
    return given.speed / apart.mean()


def frames(given, scene, snapshots):
    """Images of one size."""
    later = [each.time for each in snapshots[1:]]  # at the start there is none
    gas = picture.gas_of(given, [scene], [later]) if later or given.gas else None
    scales = Scales([scene], picture.colour_of(given, [scene]), gas, given.range, given.gas_range)
    spread = [snapshots[at] for at in {0, *evenly_spaced([each.time for each in snapshots], SPREAD)}]
    some = [scene.shown(each, scales.colour, gas) for each in spread]
    box, closed = view([scene], some)
    colours, of_gas = scales.colours(some)
    print(scales.words())
    highest = max(given.height / READABLE - AROUND, 1.0)
    for snapshot in snapshots:
        shown = scene.shown(snapshot, scales.colour, gas)
        figure = Picture([scene], [[shown]], box, closed, colours, gas, of_gas, highest=highest).figure()
        yield film.pixels(figure, given.height / figure.get_figheight())
        plt.close(figure)


def main():
    given = arguments()
    scene = Scene(given.run)
    output = given.output or os.path.join(given.run, "bed.mp4")
    film.kind_of(output)
    film.program()
    for note in scene.walls.script.notes:
        print(f"tools/film: {note}", file=sys.stderr)
    chosen = [each for each in scene.snapshots if given.start <= each.time <= given.end]
    if not chosen:
        raise InputError(f"{given.run}: no snapshots from {given.start:g} to {given.end:g} s; there are those of {scene.times[0]:g} to {scene.times[-1]:g} s")
    rate = rate_of(given, [each.time for each in chosen])
    film.write(output, frames(given, scene, chosen), rate)
    print(f"{output}: {len(chosen)} frames, {len(chosen) / rate:.3g} s, {rate:.4g} frames a second")


if __name__ == "__main__":
    exits.of_drawing(main, "tools/film")
