# SPDX-License-Identifier: GPL-3.0-or-later
"""Sizes of a picture in inches: panels of one size side by side, so that spheres keep their size, and what stands around them."""

from dataclasses import dataclass

LEFT, BAR, GAP = 0.72, 0.95, 0.14
NARROWEST = 0.62  # of the room for a panel: the words above it must fit
STRIP = 3.6  # at least, for titles and curves
HIGHEST = 6.0  # all panels together
TIME, TICKS, LINE, SMALL = 0.24, 0.44, 0.2, 0.15  # above a panel, below it, and lines of text
PROFILE = 2.5  # a profile over the height, with its label
CURVES, ABOVE_CURVES, BELOW_CURVES, BETWEEN = 1.35, 0.3, 0.45, 0.95
BESIDE, BESIDE_ONE = 1.4, 0.7  # height over width from which on the gas stands beside the particles, not below: in a strip, and of one or two times


@dataclass(frozen=True)
class Layout:
    """`across` panels of `width` x `height` in a room of `room` each, `rows` of them for each of the runs."""

    across: int
    rows: int
    width: float
    height: float
    beside: bool
    bars: int
    more: float

    @property
    def room(self):
        return max(self.width, NARROWEST)

    @property
    def inside(self):
        return self.across * self.room + (self.across - 1) * GAP

    @property
    def strip(self):
        return max(self.inside, STRIP)

    @property
    def total(self):
        """Width of the figure."""
        return LEFT + self.strip + 0.1 + BAR * self.bars + self.more

    def x(self, number):
        """Left end of panel `number` from the left."""
        return LEFT + (self.strip - self.inside) / 2 + number * (self.room + GAP) + (self.room - self.width) / 2


def layout(times, gas, runs, aspect, profile=False, highest=HIGHEST):
    """For `times` snapshots of each of `runs`, with a panel of the gas for each where `gas`; `aspect`: height over width of a panel;
    `profile`: whether a profile stands at the right; `highest`: of all panels together."""
    beside = gas and aspect >= (BESIDE if times > 2 else BESIDE_ONE)
    across = times * (2 if beside else 1)
    rows = 2 if gas and not beside else 1
    width = {1: 4.2, 2: 2.9, 3: 2.4, 4: 2.1}.get(across, max(9.6 / across, 1.15))
    height = width * aspect
    highest /= rows * runs
    if not 1.2 <= height <= highest:  # a flat box or a tall column
        height = min(max(height, min(1.2, highest)), highest)
        width = min(height / aspect, 12.0 / across)
        height = width * aspect
    # Two bars stand one above the other where there is room.
    return Layout(across, rows, width, height, beside, 2 if beside and height < 2.6 else 1, PROFILE if profile else 0.0)
