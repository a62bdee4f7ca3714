# SPDX-License-Identifier: GPL-3.0-or-later
"""The figure of tools/picture and tools/film: strips of panels, a strip for each run, above curves over time."""

import matplotlib
import numpy

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the back end is chosen first)

from interphase import picture_curves, picture_labels, picture_law, picture_panels  # noqa: E402
from interphase import picture_layout as sizes  # noqa: E402
from interphase.picture_panels import INK  # noqa: E402
from interphase.picture_quantities import GAS  # noqa: E402

FONT = {"font.size": 8, "axes.edgecolor": INK, "axes.linewidth": 0.8, "axes.labelcolor": INK, "xtick.color": INK, "ytick.color": INK,
        "text.color": INK}  # fmt: skip


class Colours:
    """`quantity` over `low` to `high`; `over`, `under`: whether values lie beyond, which the bar's arrows tell."""

    def __init__(self, quantity, ends, values):
        self.quantity, (self.low, self.high) = quantity, ends
        finite = [each[numpy.isfinite(each)] for each in values]
        self.over = any((each > self.high * (1 + 1e-9) + 1e-12).any() for each in finite)
        self.under = any((each < self.low - 1e-9 * abs(self.low) - 1e-12).any() for each in finite)
        self.mapper = plt.cm.ScalarMappable(matplotlib.colors.Normalize(self.low, self.high), quantity.map)

    def bar(self, figure, place):
        extend = {(True, True): "both", (True, False): "min", (False, True): "max", (False, False): "neither"}[self.under, self.over]
        bar = figure.colorbar(self.mapper, cax=figure.add_axes(place), extend=extend)
        bar.set_label(self.quantity.label)
        bar.formatter.set_powerlimits((-3, 4))
        if self.quantity.kind == "numbers":
            bar.set_ticks(range(int(numpy.ceil(self.low)), int(self.high) + 1))


class Picture:
    """`scenes` with the `Shown` of each; `colours` of the spheres and, where `gas` names a quantity, `gas_colours`."""

    def __init__(self, scenes, shown, view, closed, colours, gas=None, gas_colours=None, curves=(), profile=None, highest=sizes.HIGHEST):
        """`profile`: (height, pressure, the law's or None) of a packing that is held, as picture_law.profile gives it; `highest`: of all panels, in inches."""
        self.profile, self.highest = profile, highest
        self.scenes, self.shown, self.view, self.closed = scenes, shown, view, closed
        self.colours, self.gas, self.gas_colours, self.curves = colours, gas, gas_colours, curves

    def figure(self):
        plt.rcParams.update(FONT)
        left, right, bottom, top = self.limits = picture_panels.with_margin(self.view, self.closed)
        aspect = (top - bottom) / max(right - left, 1e-12)
        plan = sizes.layout(max(len(each) for each in self.shown), self.gas is not None, len(self.scenes), aspect, self.profile is not None, self.highest)
        heads = [self._head(scene, plan) for scene in self.scenes]
        strips = [sum(size * 1.0 for _, size in head) + 0.18 + plan.rows * (sizes.TIME + plan.height) + sizes.TICKS for head in heads]
        below = sizes.CURVES + sizes.ABOVE_CURVES + sizes.BELOW_CURVES if self.curves else 0.1
        total = sum(strips) + below
        figure = plt.figure(figsize=(plan.total, total), facecolor=picture_panels.BACKGROUND)
        top = total
        for scene, shown, head, strip in zip(self.scenes, self.shown, heads, strips):
            self._strip(figure, plan, total, top, scene, shown, head)
            top -= strip
        for number, curve in enumerate(self.curves):
            whole = plan.total - sizes.LEFT - 0.2 if plan.more else plan.strip
            width = (whole - sizes.BETWEEN * (len(self.curves) - 1)) / len(self.curves)
            axes = figure.add_axes((
                (sizes.LEFT + number * (width + sizes.BETWEEN)) / plan.total, sizes.BELOW_CURVES / total, width / plan.total, sizes.CURVES / total))
            picture_curves.draw_curve(axes, curve, self.scenes, [each.time for each in self.shown[0]])
        picture_labels.thin(figure)
        return figure

    def _head(self, scene, plan):
        """[(text, height in inches)]: title, operating point, what the lines mean and how spheres are drawn."""
        width = plan.strip + 0.6 * sizes.BAR
        title = scene.title + ([scene.name] if len(self.scenes) > 1 and scene.name != scene.title[0] else [])
        return [(line, sizes.LINE) for line in picture_labels.wrapped(title, 11, width)] + [
            (line, sizes.SMALL) for line in picture_labels.wrapped(scene.operating_point, 8, width)]  # fmt: skip

    def _strip(self, figure, plan, total, top, scene, shown, head):
        """The panels of one run below `top` inches."""
        y = top - 0.14
        for text, size in head:
            figure.text(sizes.LEFT / plan.total, y / total, text, fontsize=11 if size == sizes.LINE else 8, ha="left", va="top", color=INK)
            y -= size
        y -= 0.04
        drawn = []
        for number, each in enumerate(shown):
            lines = scene.walls.lines(each.time - scene.times[0], self.view)
            drawn += lines
            for row, gas in enumerate((False, True) if self.gas else (False,)):
                column, line = (2 * number + row, 0) if plan.beside else (number, row)
                low = y - (line + 1) * (sizes.TIME + plan.height)
                axes = figure.add_axes((plan.x(column) / plan.total, low / total, plan.width / plan.total, plan.height / total))
                self._gas(axes, each) if gas else self._bed(axes, scene, each, plan)
                picture_panels.draw_walls(axes, lines)
                picture_panels.frame(axes, self.limits, self.closed, scene.walls.known)
                axes.set_title(self._time(each, gas), fontsize=9, pad=3)
                axes.set_xlabel("x [m]" if line == plan.rows - 1 else "")
                axes.tick_params(labelbottom=line == plan.rows - 1, labelleft=column == 0, left=column == 0 or not scene.walls.known)
                axes.set_ylabel("z [m]" if column == 0 else "")
        self._bars(figure, plan, total, y)
        if self.profile is not None:
            width = (sizes.PROFILE - 0.6) / plan.total
            axes = figure.add_axes((1 - width - 0.1 / plan.total, (y - sizes.TIME - plan.height) / total, width, plan.height / total))
            picture_curves.draw_profile(axes, *self.profile)
            axes.set_ylim(self.limits[2:])
        self._legend(figure, plan, total, top, drawn, head)

    def _time(self, each, gas):
        if not gas:
            return f"t = {each.time:.4g} s"
        # Where the gas is of another time than the spheres beside it, it is said.
        late = abs(each.gas.time - each.time) > 1e-3 * max(abs(each.time), 1e-12)
        return f"{self.gas}, {each.gas.time:.4g} s" if late else self.gas

    def _bed(self, axes, scene, shown, plan):
        picture_panels.draw_bed(axes, shown, self.colours.mapper, scene.depth, 72 * plan.width / max(self.limits[1] - self.limits[0], 1e-12))

    def _gas(self, axes, shown):
        picture_panels.draw_gas(axes, shown.gas, GAS[self.gas][1].of(shown.gas.values), self.gas_colours.mapper)
        if self.gas == "velocity":
            picture_panels.draw_arrows(axes, shown.gas, self.view)

    def _bars(self, figure, plan, total, y):
        x = plan.x(plan.across - 1) + plan.width + (plan.room - plan.width) / 2 + 0.14
        colours = [self.colours] + [self.gas_colours] * (self.gas is not None)
        for number, each in enumerate(colours):
            if plan.beside and plan.bars == 1:  # one above the other
                high = (plan.height - 0.5) / 2
                low, at = y - sizes.TIME - (high if number == 0 else plan.height), x
            elif plan.beside:
                high, at = plan.height, x + number * 0.95 * sizes.BAR
                low = y - sizes.TIME - plan.height
            else:
                high, at = min(plan.height, 3.2), x
                low = y - number * (sizes.TIME + plan.height) - sizes.TIME - (plan.height + high) / 2
            each.bar(figure, (at / plan.total, low / total, 0.12 / plan.total, high / total))

    def _legend(self, figure, plan, total, top, lines, head):
        """What the lines are, at the right of the title, where there is room for it."""
        words = picture_panels.kinds(lines)
        note = f"spheres at true size, paler farther from the front; walls{' and gas' if self.gas else ''} in the middle plane"
        free = plan.strip - max(picture_labels.width_of(text, 11 if size == sizes.LINE else 8) for text, size in head)
        x = (sizes.LEFT + plan.strip) / plan.total
        if free > picture_labels.width_of(note, 6.5) + 0.2:
            figure.text(x, (top - 0.18) / total, note, fontsize=6.5, ha="right", va="top", color="0.45")
        if words and free > 0.2 + sum(picture_labels.width_of(text, 6.5) + 0.4 for text, _ in words):
            handles = [plt.Line2D([], [], color=colour, linewidth=width) for _, (colour, width) in words]
            figure.legend(handles, [text for text, _ in words], loc="upper right", ncol=len(words), frameon=False, fontsize=6.5, handlelength=1.8,
                          bbox_to_anchor=(x, (top - 0.33) / total), borderaxespad=0, borderpad=0, columnspacing=1.2)  # fmt: skip


def paths(scene):
    """The figure of a run of few particles: their velocity and height over time, beside the drag law's."""
    plt.rcParams.update(FONT)
    width = 6.2
    head = [(line, 11) for line in picture_labels.wrapped(scene.title, 11, width)]
    head += [(line, 8) for line in picture_labels.wrapped(scene.operating_point, 8, width)]
    figure = plt.figure(figsize=(width + 0.9, 5.2), facecolor=picture_panels.BACKGROUND)
    y = 5.2 - 0.14
    for text, size in head:
        figure.text(0.1, y / 5.2, text, fontsize=size, ha="left", va="top", color=INK)
        y -= sizes.LINE if size == 11 else sizes.SMALL
    velocity = figure.add_axes((0.1, 2.35 / 5.2, 0.86, (y - 2.35 - 0.35) / 5.2))
    height = figure.add_axes((0.1, 0.45 / 5.2, 0.86, 1.7 / 5.2), sharex=velocity)
    picture_curves.draw_paths(velocity, height, scene)
    picture_labels.thin(figure)
    return figure

