# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of the page of tools/report: each as wide as a phone, with its own legend."""

import math

import numpy

from interphase import page_html, report_figure
from interphase.report_figure import INK, MARKERS, handles, plt, style

WIDE, DEEP = 5.0, 3.3  # inches
WHOLE = "0.8"  # of a cost whose phases are not known
PARTS = {"solids": "#1b6ca8", "gas": "#d1495b", "coupling": "#c98a12", "other": "#9a9a9a"}


def _axes(names, deep=DEEP, legend=True):
    """(figure, axes) with a legend of the runs above them."""
    figure, (axes,) = report_figure.grid(1, WIDE, deep, 0)
    figure.set_size_inches(WIDE, deep + (0.2 * math.ceil(len(names) / 2) if legend else 0))
    if legend:
        figure.legend(handles(len(names)), names, loc="upper left", ncol=2, frameon=False, fontsize=8)
    return figure, axes


def _laid_out(figure, names, deep=DEEP, legend=True):
    above = 0.2 * math.ceil(len(names) / 2) if legend else 0
    figure.tight_layout(rect=(0, 0, 1, deep / (deep + above)))
    return figure


def panel(make, names, words, caption=""):
    """One that tools/report draws, too: `make` draws on axes."""
    figure, axes = _axes(names)
    make(axes)
    return page_html.drawn(_laid_out(figure, names), words, caption)


def pressure_profile(profiles, names):
    """Mean gauge pressure over the height; `profiles`: of each run (height [n], pressure [n], error [n]) or None."""
    figure, axes = _axes(names, 4.0)
    for at, found in enumerate(profiles):
        if found is not None:
            height, pressure, error = found
            axes.plot(pressure, height, **style(at))
            if numpy.isfinite(error).any():
                axes.fill_betweenx(height, pressure - error, pressure + error, color=style(at)["color"], alpha=0.2, linewidth=0)
    axes.set(xlabel="pressure above that at the top [Pa]", ylabel="height [m]")
    return page_html.drawn(_laid_out(figure, names, 4.0), "mean pressure over the height of each run",
                           "Mean of the gas's fields; bands: one standard error.")  # fmt: skip


def cost_split(costs, names):
    """Bars of seconds per simulated second, a run each, by phase; `costs`: of each run or None."""
    deep = 0.8 + 0.42 * len(names)
    figure, (axes,) = report_figure.grid(1, WIDE, deep, 0)
    figure.set_size_inches(WIDE, deep + 0.3)
    for at, cost in enumerate(costs):
        if cost is None:
            continue
        left = 0.0
        for part, seconds in (cost.split or {"": cost.value}).items():
            axes.barh(at, seconds, left=left, color=PARTS.get(part, WHOLE), height=0.6)
            left += seconds
        if math.isfinite(cost.error):
            axes.errorbar([cost.value], [at], xerr=[cost.error], color=INK, capsize=2, linewidth=0.9)
    axes.set_yticks(range(len(names)), names)
    axes.set_ylim(len(names) - 0.5, -0.5)
    axes.set_xlabel("seconds per simulated second")
    figure.legend([plt.Rectangle((0, 0), 1, 1, color=colour) for colour in PARTS.values()], list(PARTS), loc="upper left", ncol=4, frameon=False,
                  fontsize=8)  # fmt: skip
    figure.tight_layout(rect=(0, 0, 1, deep / (deep + 0.3)))
    return page_html.drawn(figure, "seconds of each phase per simulated second of each run",
                           "Light grey: a run that has not told its phases." if any(cost and not cost.split for cost in costs) else "")


def trade(points, names, title=""):
    """Cost against distance of `trade.Point`s, one a run, with standard errors; grey: what noise alone makes of no difference."""
    figure, axes = _axes(names)
    noise = [each.distance.noise for each in points if each.distance is not None and math.isfinite(each.distance.noise)]
    if noise:
        axes.axhspan(0, max(noise), color="0.92", linewidth=0, zorder=0)
    for at, each in enumerate(points):
        if each.cost is None or not math.isfinite(each.cost.value):
            continue
        far = each.distance
        if far is not None and not math.isfinite(far.square):
            continue
        y = 0.0 if far is None else far.value
        known = far is not None and math.isfinite(far.square_error)
        bars = [[y - far.low], [far.high - y]] if known else None
        width = each.cost.error if math.isfinite(each.cost.error) else None
        axes.errorbar([each.cost.value], [y], yerr=bars, xerr=width, color=style(at)["color"], marker=MARKERS[at % len(MARKERS)], markersize=6,
                      capsize=2, linestyle="none", markerfacecolor="white" if far is None else style(at)["color"], clip_on=False)  # fmt: skip
    axes.set_xscale("log")
    axes.set_ylim(bottom=0)
    axes.margins(x=0.15)
    axes.set(xlabel="cost: seconds per simulated second", ylabel="distance to the reference")
    if title:
        axes.set_title(title, fontsize=8)
    axes.xaxis.set_minor_formatter(plt.NullFormatter())
    return page_html.drawn(_laid_out(figure, names), f"cost against distance to the reference, {title or 'overall'}")




def convergence(family, means, at_limit, reference, label):
    """A mean over parcel diameter or step (`convergence.Family`), what it is extrapolated to (hollow) and the reference's (band), one standard error each."""
    figure, axes = _axes((), legend=False)
    if reference is not None and math.isfinite(reference.error):
        axes.axhspan(reference.value - reference.error, reference.value + reference.error, color="0.85", linewidth=0, zorder=0)
        axes.axhline(reference.value, color="0.6", linewidth=0.8, zorder=0)
    for x, mean, fitted in zip(family.values, means, family.fitted):
        if mean is not None:
            axes.errorbar([x], [mean.value], yerr=[mean.error] if math.isfinite(mean.error) else None, color=style(0)["color"], marker="o" if fitted else "s",
                          capsize=2, linestyle="none")  # fmt: skip
    if at_limit is not None and math.isfinite(at_limit.error):
        axes.errorbar([family.limit], [at_limit.value], yerr=[at_limit.error], color=style(1)["color"], marker="D", markerfacecolor="white", capsize=2,
                      linestyle="none", clip_on=False)  # fmt: skip
    axes.set(xlabel=f"{family.by}{f' [{family.unit}]' if family.unit else ' over that of a real sphere'}", ylabel=label.replace(", ", ",\n"))
    axes.set_xlim(left=0)
    return page_html.drawn(_laid_out(figure, (), legend=False), f"{label} over {family.by}")
