# SPDX-License-Identifier: GPL-3.0-or-later
"""The figure of tools/sweep: a panel per quantity against what is swept, a line per method."""

import math

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the back end is chosen first)
from matplotlib.transforms import offset_copy  # noqa: E402

from interphase.report_figure import INK, grid, marker, style  # noqa: E402

MISSING = "X: no run, open: runs missing"


def axis_of(rows):
    """(name, position of each row): the first that is swept in numbers, else the weight, else the first that is swept, else the method, in
    order; the name's position may be a text, then it is a category."""
    for name in rows[0].values:
        numbers = [_number(row.values[name]) for row in rows]
        if None not in numbers:
            return name, numbers
    if len({row.weight for row in rows}) > 1:
        return "weight", [row.weight for row in rows]
    for name in rows[0].values:
        return name, [row.values[name] for row in rows]
    return "method", [row.method for row in rows]


def _number(text):
    try:
        number = float(text)
    except ValueError:
        return None
    return number if math.isfinite(number) else None


def lines_of(rows):
    """(name of the axis, {label: [(position, row), ...]}): the rows that differ along the axis alone are a line."""
    name, positions = axis_of(rows)
    several = {"method": len({row.method for row in rows}) > 1, "weight": len({row.weight for row in rows}) > 1}
    lines = {}
    for position, row in zip(positions, rows):
        label = [row.method] if several["method"] and name != "method" else []
        label += [f"W = {row.weight:g}"] if several["weight"] and name != "weight" else []
        label += [f"{other.rpartition(':')[2]} = {text}" for other, text in row.values.items() if other != name]
        lines.setdefault(", ".join(label) or row.method, []).append((position, row))
    return name, lines


def draw(path, result, title):
    """`result`: a sweep_table.Result. Error bars are one standard error; a combination without a run is a cross at the foot."""
    name, lines = lines_of(result.rows)
    panels = list(result.quantities.items())
    if not panels:
        return
    missing = any(row.runs < row.asked for row in result.rows)
    labels = [*lines, *([MISSING] if missing else [])]
    across = min(len(panels), 3)
    above = 0.45 + 0.2 * math.ceil(len(labels) / across)
    figure, all_axes = grid(len(panels), 3.4, 2.6, above)
    high = figure.get_figheight()
    categories = [text for text in dict.fromkeys(x for line in lines.values() for x, _ in line) if isinstance(text, str)]
    for axes, (quantity, unit) in zip(all_axes, panels):
        for at, line in enumerate(lines.values()):
            _line(axes, at, len(lines), line, quantity, categories)
        axes.set_xlabel(name.rpartition(":")[2])
        axes.set_ylabel(f"{quantity.replace('_', ' ')} [{unit}]")
        axes.margins(x=0.08, y=0.15)
        if categories:
            axes.set_xticks(range(len(categories)), categories)
            axes.set_xlim(-0.5, len(categories) - 0.5)
    handles = [plt.Line2D([], [], **style(at), marker=marker(at), markersize=4) for at in range(len(lines))]
    handles += [plt.Line2D([], [], color=INK, marker="X", markersize=5, linestyle="none")] * missing
    figure.text(0.01, 1 - 0.06 / high, title, ha="left", va="top", fontsize=9)
    figure.legend(handles, labels, loc="upper left", bbox_to_anchor=(0, 1 - 0.25 / high), ncol=across, frameon=False, fontsize=8)
    figure.tight_layout(rect=(0, 0, 1, 1 - above / high))
    figure.savefig(path, dpi=160)
    plt.close(figure)


def _line(axes, at, count, line, quantity, categories):
    """Mean and standard error along one line, broken where there is no run."""
    def place(position):
        return categories.index(position) if categories else position
    aside = offset_copy(axes.transData, fig=axes.figure, x=3 * (at - (count - 1) / 2), units="points")  # bars do not hide each other
    xs, ys, colour = [], [], style(at)["color"]
    for position, row in sorted(line, key=lambda each: place(each[0])):
        cell, x = row.cells.get(quantity), place(position)
        there = cell is not None and not math.isnan(cell.mean)
        xs.append(x)
        ys.append(cell.mean if there else math.nan)
        if not there:
            axes.plot([x], [0.03 + 0.05 * at], "X", color=colour, markersize=5, transform=axes.get_xaxis_transform(), clip_on=False)
            continue
        error = None if math.isnan(cell.error) else cell.error
        axes.errorbar([x], [cell.mean], yerr=error, color=colour, marker=marker(at), markersize=4, linestyle="none", capsize=2,
                      transform=aside, elinewidth=0.9, markerfacecolor=colour if row.runs == row.asked else "white")  # fmt: skip
    axes.plot(xs, ys, color=colour, linewidth=0 if categories else 1.2, transform=aside)
