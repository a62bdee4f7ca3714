# SPDX-License-Identifier: GPL-3.0-or-later
"""One colour scale and one view for all that is drawn: of several times, several runs, or the frames of a film."""

from interphase.picture_figure import Colours
from interphase.picture_quantities import GAS, PARTICLES, range_of
from interphase.picture_scene import evenly_spaced

SAMPLES = 8  # snapshots of each run that tell the ranges


class Scales:
    """`colour`: a name of PARTICLES; `gas`: one of GAS or None; `ends`, `gas_ends`: (low, high) or None, for which the runs are looked at: `SAMPLES`
    snapshots spread over each, whichever of them are drawn, so that pictures of the same runs agree."""

    def __init__(self, scenes, colour, gas=None, ends=None, gas_ends=None):
        self.colour, self.gas = PARTICLES[colour], gas
        for scene in scenes:
            scene.check(colour, self.colour)
        self.samples = [scene.shown(scene.snapshots[at], self.colour) for scene in scenes for at in evenly_spaced(scene.times, SAMPLES)]
        self.ends = ends or range_of(self.colour, [each.values for each in self.samples])
        self.gas_ends = gas_ends
        if gas and gas_ends is None:
            self.gas_ends = range_of(GAS[gas][1], [] if gas == "voidage" else [values for scene in scenes for values in self._gas(scene)])

    def _gas(self, scene):
        field, quantity = GAS[self.gas]
        times = list(scene.gas.times(field))
        return [quantity.of(scene.gas.nearest(field, times[at]).values) for at in evenly_spaced(times, SAMPLES)]

    def colours(self, shown):
        """(`Colours` of the spheres, of the gas or None) for a list of `Shown`."""
        of_gas = None
        if self.gas:
            of_gas = Colours(GAS[self.gas][1], self.gas_ends, [GAS[self.gas][1].of(each.gas.values) for each in shown])
        return Colours(self.colour, self.ends, [each.values for each in shown]), of_gas

    def words(self):
        """The ranges, as --range and --gas-range take them."""
        told = f"{self.colour.label}: --range={self.ends[0]:g},{self.ends[1]:g}"
        return told + (f"; {GAS[self.gas][1].label}: --gas-range={self.gas_ends[0]:g},{self.gas_ends[1]:g}" if self.gas else "")
