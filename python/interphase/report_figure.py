# SPDX-License-Identifier: GPL-3.0-or-later
"""The figure of tools/report: one panel per distribution or profile, one colour per run."""

import math

import matplotlib
import numpy

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the back end is chosen first)

COLOURS = ("#1b6ca8", "#d1495b", "#2e933c", "#8a5aab", "#c98a12", "#3a3a3a", "#17a2a2", "#9c5238")
MARKERS = "osD^vPX*"
INK = "0.2"


def panels(reports, depth, scene):
    """{name: function that draws on axes} of what these reports have anything for, in the order of the figure."""
    def there(parts):
        return any(getattr(report, part) is not None for report in reports for part in parts.split())

    return {name: make for name, parts, make in (
        ("vertical velocity", "windows", lambda axes: _velocity(axes, reports, depth, "vertical", scene)),
        ("horizontal velocity", "windows", lambda axes: _velocity(axes, reports, depth, "horizontal", scene)),
        ("granular temperature", "windows", lambda axes: _temperature(axes, reports, depth)),
        ("overlaps", "overlap", lambda axes: _overlap(axes, reports)),
        ("voidage", "voidage", lambda axes: _voidage(axes, reports)),
        ("pressure", "pressure spectrum", lambda axes: _pressure(axes, reports)),  # what is stored has one of them
    ) if there(parts)}


def draw(path, names, reports, depth, scene):
    """`names`: one per report. Panels that no run has anything for are left out."""
    makes = panels(reports, depth, scene).values()
    high = 0.35 * math.ceil(len(names) / 4)
    figure, all_axes = grid(len(makes), 3.5, 2.9, 0.5)
    for axes, make in zip(all_axes, makes):
        make(axes)
    figure.legend(handles(len(names)), names, loc="upper left", ncol=min(len(names), 4), frameon=False, fontsize=9)
    figure.tight_layout(rect=(0, 0, 1, 1 - high / figure.get_figheight()))
    figure.savefig(path, dpi=160)
    plt.close(figure)


def handles(count):
    """For a legend of the runs number 0 to `count` - 1."""
    return [plt.Line2D([], [], **style(at), marker=marker(at), markersize=4) for at in range(count)]


def grid(count, wide, deep, above):
    """(figure, `count` axes), three in a line at most, each `wide` by `deep` inches, and `above` inches over them."""
    plt.rcParams.update({"font.size": 8, "axes.edgecolor": INK, "axes.linewidth": 0.8, "axes.labelcolor": INK,
                         "xtick.color": INK, "ytick.color": INK, "text.color": INK})  # fmt: skip
    columns = min(count, 3) or 1
    lines = math.ceil(count / columns) or 1
    figure, axes = plt.subplots(lines, columns, figsize=(max(wide * columns, 4.2), deep * lines + above), squeeze=False)
    for each in axes.flat:
        each.spines[["top", "right"]].set_visible(False)
    for each in axes.flat[count:]:
        each.set_visible(False)
    return figure, axes.flat[:count]


def style(at):
    """Colour and width of the line of the run number `at`."""
    return {"color": COLOURS[at % len(COLOURS)], "linewidth": 1.3}


def marker(at):
    """The mark of the run number `at`."""
    return MARKERS[at % len(MARKERS)]


def _profile(axes, reports, means_of):
    """Mean and standard error over the windows; what no error is known of has no bar."""
    drawn = 0
    for at, report in enumerate(reports):
        if report.windows is None:
            continue
        means = means_of(report)
        if all(mean is None for mean in means):
            continue
        drawn += 1
        values = [math.nan if mean is None else mean.value for mean in means]
        errors = [0.0 if mean is None or math.isnan(mean.error) else mean.error for mean in means]
        axes.errorbar(report.windows, values, errors, marker=marker(at), markersize=4, capsize=2, **style(at))
    if not drawn:
        axes.text(0.5, 0.5, "no sphere's centre lies here", ha="center", transform=axes.transAxes)
    axes.set_xlabel("x [m]")


def _velocity(axes, reports, depth, component, scene):
    _profile(axes, reports, lambda report: report.profiles[depth].velocity[component])
    axes.axhline(0, color="0.75", linewidth=0.8, zorder=0)
    axes.set_ylabel(f"{component} velocity [m/s]")
    axes.set_title(f"z = {scene.windows.centre:g} m, {depth.replace('_', ' ')}", fontsize=8)


def _temperature(axes, reports, depth):
    _profile(axes, reports, lambda report: report.profiles[depth].temperature)
    axes.set_ylim(bottom=0)
    axes.set_ylabel("granular temperature [m²/s²]")


def _overlap(axes, reports):
    for at, report in enumerate(reports):
        if report.overlap is not None:
            cumulative = numpy.concatenate([[0.0], report.overlap.share.cumsum()])
            axes.plot(100 * report.overlap.edges, 100 * cumulative, **style(at))
    axes.set_xscale("log")
    low = min(_first_percent(report.overlap) for report in reports if report.overlap is not None)
    axes.set_xlim(left=100 * low)
    axes.set(ylim=(0, 101), xlabel="overlap [% of d]", ylabel="overlaps below [%]")


def _first_percent(histogram):
    """The overlap below which 0.2 % lie: lower ones would stretch the axis."""
    return histogram.edges[int(numpy.searchsorted(histogram.share.cumsum(), 0.002))]


def _voidage(axes, reports):
    top = 0.0
    for at, report in enumerate(reports):
        if report.voidage is None:
            continue
        share = 100 * report.voidage.share
        axes.stairs(share, report.voidage.edges, **style(at))
        # The freeboard's peak at 1 is cut.
        dense = share[report.voidage.edges[1:] < 0.95]
        top = max(top, dense.max(initial=0.0))
    axes.set_ylim(0, 1.25 * top or None)
    kinds = dict.fromkeys(report.kind_of_voidage for report in reports if report.voidage is not None)
    axes.set(xlabel=", or ".join(kinds), ylabel="cells [%]")
    axes.set_title("the empty vessel's peak at 1 is cut off", fontsize=7, color="0.45")


def _pressure(axes, reports):
    """Spectra with their 95 % bands where all records are long enough, or nothing else is there, else the series."""
    series = [(at, report) for at, report in enumerate(reports) if report.pressure is not None]
    spectra = [(at, report) for at, report in enumerate(reports) if report.spectrum is not None]
    if all(report.spectrum is not None for _, report in series):
        for at, report in spectra:
            found = report.spectrum
            axes.loglog(found.frequency, found.power, **style(at))
            axes.fill_between(found.frequency, found.low, found.high, color=style(at)["color"], alpha=0.15, linewidth=0)
        axes.set(xlabel="frequency [Hz]", ylabel="pressure drop, power [Pa²/Hz]")
        return
    for at, report in series:
        axes.plot(report.pressure[0], report.pressure[1] / 1000, **style(at))
    axes.set(xlabel="t [s]", ylabel="pressure drop [kPa]")
