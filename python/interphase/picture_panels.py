# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels of a picture: the spheres from the front, and the gas in the middle plane, both with the walls."""

import matplotlib
import numpy
from matplotlib.collections import EllipseCollection, LineCollection, PolyCollection

BACKGROUND = "white"
INK = "0.2"
# What lies behind fades towards the background, so that bubbles in front of other particles stay visible.
FADE = 0.55
MARGIN = 0.02  # of the larger side of the view, so that walls at its edge are whole
# (colour, width in points); the later ones cover the earlier: where gas passes, the particles may have a wall
STYLES = {
    "solid edge": ("0.25", 0.7),
    "solid": ("0.15", 1.3),
    "wall": ("0.15", 1.3),
    "open": ("#4a90c2", 1.3),
    "passage": ("#2e933c", 1.1),
}
ARROWS = 14  # along the longer side of a panel of the gas's velocity


def faded(colours, depth):
    """`colours` [n, 4] mixed with the background by `depth` [n], 0 in front and 1 at the back."""
    share = (FADE * numpy.clip(depth, 0, 1))[:, None]
    mixed = colours.copy()
    mixed[:, :3] = colours[:, :3] * (1 - share) + numpy.array(matplotlib.colors.to_rgb(BACKGROUND)) * share
    return mixed


def draw_bed(axes, shown, mapper, depth, points_per_metre):
    """Spheres of `shown` at true size; what is nearer to the front, at `depth[0]`, covers what is behind."""
    order = numpy.argsort(-shown.position[:, 1], kind="stable")
    position, diameter = shown.position[order], shown.diameter[order]
    behind = (position[:, 1] - depth[0]) / max(depth[1] - depth[0], 1e-300)
    colours = faded(mapper.to_rgba(shown.values[order]), behind)
    # A rim tells spheres of one colour apart; it is drawn inside the true size and goes where it would fill it.
    rim = min(0.25, 0.06 * float(numpy.median(diameter)) * points_per_metre) if len(diameter) else 0.0
    edges = colours.copy()
    edges[:, :3] *= 0.55
    inner = diameter - rim / points_per_metre
    axes.add_collection(EllipseCollection(
        inner, inner, numpy.zeros_like(inner), units="xy", offsets=position[:, (0, 2)], transOffset=axes.transData,
        facecolors=colours, edgecolors=edges, linewidths=rim,
    ))


def draw_gas(axes, section, values, mapper):
    """Each cell that the plane cuts in the colour of its value [n], to its true shape."""
    colours = mapper.to_rgba(values)
    axes.add_collection(PolyCollection(section.polygons, facecolors=colours, edgecolors=colours, linewidths=0.2))


def draw_arrows(axes, section, view, colour="white"):
    """Directions of a velocity [n, 3] in the plane, at cells that are spread over it; the longest arrow spans from one to the next."""
    left, right, bottom, top = view
    apart = max(right - left, top - bottom) / ARROWS
    x, z = numpy.meshgrid(numpy.arange(left + apart / 2, right, apart), numpy.arange(bottom + apart / 2, top, apart))
    wanted = numpy.column_stack([x.ravel(), z.ravel()])
    inside = (section.middles >= (left, bottom)).all(axis=1) & (section.middles <= (right, top)).all(axis=1)
    cells = numpy.flatnonzero(inside)
    if not len(cells):
        return
    distance = ((wanted[:, None, :] - section.middles[cells][None, :, :]) ** 2).sum(axis=2)
    nearest = distance.argmin(axis=1)
    taken = numpy.unique(cells[nearest[distance.min(axis=1) < apart**2 / 2]])
    arrows = section.values[taken][:, (0, 2)]
    longest = numpy.linalg.norm(arrows, axis=1).max(initial=0.0)
    if longest > 0:
        axes.quiver(*section.middles[taken].T, *(arrows * apart / longest).T, angles="xy", scale_units="xy", scale=1, color=colour,
                    width=1.2, units="dots", headwidth=5, headlength=5, headaxislength=4, minlength=0.5)  # fmt: skip


def draw_walls(axes, lines):
    """`lines`: a list of wall_lines.Lines."""
    for each in lines:
        colour, width = STYLES[each.kind]
        above = 3 + list(STYLES).index(each.kind) / len(STYLES)
        axes.add_collection(LineCollection(each.segments, colors=colour, linewidths=width, capstyle="round", zorder=above))


def with_margin(view, closed):
    """The limits of a panel (left, right, bottom, top) for a `view`, whose top is a wall where `closed`."""
    left, right, bottom, top = view
    margin = MARGIN * max(right - left, top - bottom)
    return left - margin, right + margin, bottom - margin, top + (margin if closed else 0)


def frame(axes, limits, closed, with_walls):
    """Limits and axes of a panel. Where the walls are drawn, the frame that is no wall steps back."""
    axes.set(xlim=limits[:2], ylim=limits[2:], aspect="equal")
    for side, spine in axes.spines.items():
        spine.set_visible(not with_walls and (closed or side != "top"))
    axes.tick_params(length=2.5)


def kinds(lines):
    """The words on what lines mean, for those that are drawn."""
    there = {each.kind for each in lines}
    words = []
    if there & {"wall", "solid", "solid edge"}:
        words.append(("walls", STYLES["wall"]))
    if "open" in there:
        words.append(("gas passes", STYLES["open"]))
    if "passage" in there:
        words.append(("particles come or go", STYLES["passage"]))
    return words
