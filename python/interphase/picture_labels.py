# SPDX-License-Identifier: GPL-3.0-or-later
"""Words of a picture that do not run into each other: wrapped by their measured widths, tick labels thinned until none touch."""

from matplotlib.font_manager import FontProperties
from matplotlib.textpath import text_to_path
from matplotlib.ticker import FixedLocator

APART = 5.0  # pixels at least, between two labels


def width_of(text, size):
    """Of a line of text at `size` points, in inches."""
    return text_to_path.get_text_width_height_descent(text, FontProperties(size=size), False)[0] / 72


def wrapped(parts, size, width):
    """`parts` joined by dots into lines that are no wider than `width` inches, a part alone on a line where it is wider itself."""
    lines = []
    for part in parts:
        joined = f"{lines[-1]}  ·  {part}" if lines else part
        if lines and width_of(joined, size) <= width:
            lines[-1] = joined
        else:
            lines.append(part)
    return lines


def tick_labels(axes, which):
    """(place, box in pixels) of the labels of an axis, "x" or "y", that are seen."""
    axis = axes.xaxis if which == "x" else axes.yaxis
    low, high = sorted(axis.get_view_interval())
    room = 1e-6 * (high - low)
    labels = [(tick.get_loc(), tick.label1) for tick in axis.get_major_ticks()]
    return [(place, label.get_window_extent()) for place, label in labels
            if label.get_visible() and label.get_text() and low - room <= place <= high + room]  # fmt: skip


def touch(one, other):
    return (one.x0 < other.x1 + APART and other.x0 < one.x1 + APART and one.y0 < other.y1 + APART and other.y0 < one.y1 + APART)


def thin(figure):
    """Take away tick labels until none touches another one of the figure; ticks without a label go with it."""
    figure.draw_without_rendering()
    for axes in figure.axes:
        for which in "xy":
            axis = axes.xaxis if which == "x" else axes.yaxis
            while True:
                found = tick_labels(axes, which)
                if not any(touch(one[1], other[1]) for one, other in zip(found, found[1:])):
                    break
                axis.set_major_locator(FixedLocator([place for place, _ in found][::2]))
                figure.draw_without_rendering()
    # Of neighbours' labels that meet, the later ones go.
    kept = []
    for axes in figure.axes:
        for which in "xy":
            axis = axes.xaxis if which == "x" else axes.yaxis
            found = tick_labels(axes, which)
            free = [(place, box) for place, box in found if not any(touch(box, other) for other in kept)]
            if len(free) < len(found):
                axis.set_major_locator(FixedLocator([place for place, _ in free]))
            kept += [box for _, box in free]
