# SPDX-License-Identifier: GPL-3.0-or-later
"""Snapshots of several runs side by side at equal times, and a short film of them, for the page of tools/report."""

import io
import math
import os
import tempfile

import numpy

from interphase import film, page_html
from interphase.picture_quantities import PARTICLES, range_of
from interphase.report_figure import plt
from interphase.run import Run
from interphase.sphere_image import painted

TIMES = 4
ACROSS = 240  # pixels of a panel
FRAMES, LONGEST = 40, 3.0  # of a film: frames at most, simulated seconds
SLOWER = 0.5  # of the film's pace
LARGEST = 1_450_000  # bytes; a third more as text in the page
QUANTITY = PARTICLES["vertical_velocity"]


class Pictured:
    """The snapshots of a run between `start` and `end` [s]."""

    def __init__(self, folder, start, end):
        run = Run(folder)
        slack = 1e-9 * max(abs(end), 1)
        self.snapshots = [each for each in run.snapshots if start - slack <= each.time <= end + slack]
        self.times = numpy.array([each.time for each in self.snapshots])
        domain = run.meta.get("domain")
        self.domain = None if domain is None else numpy.asarray(domain, dtype=float).reshape(2, 3)

    def nearest(self, time):
        return self.snapshots[int(numpy.argmin(numpy.abs(self.times - time)))]


class Look:
    """What all panels have in common: the box seen and the colours, by snapshots at `times` [s] of the `runs` (Pictured)."""

    def __init__(self, runs, times):
        some = [run.nearest(time) for run in runs for time in times]
        state = [(each.positions.reshape(-1, 3), each.diameters, each.velocities.reshape(-1, 3)[:, 2]) for each in some]
        walls = [run.domain for run in runs if run.domain is not None]
        low = numpy.min([p.min(axis=0) for p, _, _ in state if len(p)] + [each[0] for each in walls], axis=0)
        high = numpy.max([(p + d[:, None] / 2).max(axis=0) for p, d, _ in state if len(p)], axis=0)
        right, back = (max([high[axis]] + [each[1][axis] for each in walls]) for axis in (0, 1))
        top = low[2] + max(1.05 * (high[2] - low[2]), 0.5 * (right - low[0]))
        self.box, self.depth = (low[0], right, low[2], top), (low[1], back)
        self.ends = range_of(QUANTITY, [values for _, _, values in state])
        self.mapper = plt.cm.ScalarMappable(plt.Normalize(*self.ends), QUANTITY.map)

    def panel(self, snapshot, width=ACROSS):
        """Its image."""
        colours = self.mapper.to_rgba(snapshot.velocities.reshape(-1, 3)[:, 2])
        return painted(snapshot.positions.reshape(-1, 3).astype(float), snapshot.diameters.astype(float), colours, self.box, self.depth, width)

    @property
    def aspect(self):
        """Height over width."""
        return (self.box[3] - self.box[2]) / (self.box[1] - self.box[0])


def _show(axes, image, look):
    shown = axes.imshow(image, extent=look.box, interpolation="none", aspect="equal")
    axes.tick_params(labelbottom=False, labelleft=False, length=0)
    axes.spines[:].set_visible(True)
    return shown


def strip(look, run, times, name):
    """A figure of the page: one run at `times` [s]."""
    figure, axes = plt.subplots(1, len(times), figsize=(1.45 * len(times) + 0.7, 1.35 * look.aspect + 0.45), squeeze=False)
    for each, time in zip(axes[0], times):
        snapshot = run.nearest(time)
        _show(each, look.panel(snapshot), look)
        each.set_title(f"{snapshot.time:.4g} s", fontsize=8, pad=2)
    figure.subplots_adjust(left=0.01, right=0.88, bottom=0.02, top=1 - 0.25 / figure.get_figheight(), wspace=0.04)
    bar = figure.colorbar(look.mapper, cax=figure.add_axes((0.895, 0.08, 0.016, 0.78)), extend="both")
    bar.set_label(QUANTITY.label, fontsize=7)
    bar.ax.tick_params(labelsize=7)
    return _as_image(figure, f"the particles of {name} at {', '.join(f'{time:.3g}' for time in times)} s", name)


def _as_image(figure, words, caption):
    stream = io.BytesIO()
    # WebP is a fifth of PNG for spheres; every browser of today shows it.
    figure.savefig(stream, format="webp", dpi=160, pil_kwargs={"quality": 70})
    plt.close(figure)
    return page_html.image("image/webp", stream.getvalue(), words, caption)


def side_by_side(runs, names, start, end):
    """HTML of the runs (Pictured) that have snapshots, a strip each at equal times from `start` to `end` [s]."""
    there = [(run, name) for run, name in zip(runs, names) if len(run.times)]
    if not there:
        return ""
    times = _equal_times([run for run, _ in there], start, end)
    look = Look([run for run, _ in there], times)
    strips = "".join(strip(look, run, times, page_html.text(name)) for run, name in there)
    return f'<div class="figures">{strips}</div>'


def _equal_times(runs, start, end):
    first, last = max(run.times[0] for run in runs), min(run.times[-1] for run in runs)
    if first > last:
        first, last = start, end
    count = min(TIMES, min(len(run.times) for run in runs))
    return [last] if count == 1 else list(numpy.linspace(first, last, count))


def moving(runs, names):
    """(HTML of a film of the runs side by side, "") or ("", why there is none)."""
    there = [(run, name) for run, name in zip(runs, names) if len(run.times) > 2]
    if not there:
        return "", "no film: fewer than three snapshots of each run"
    last = min(run.times[-1] for run, _ in there)
    lead = next((run for run, _ in there if run.times[-1] == last))
    times = [time for time in lead.times if last - LONGEST <= time <= last][-FRAMES:]
    if len(times) < 3:
        return "", "no film: fewer than three snapshots of each run"
    look = Look([run for run, _ in there], times[:: max(1, len(times) // TIMES)])
    try:
        film.program()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "film.mp4")
            for step in (1, 2, 4, 8):
                chosen = times[::step]
                pace = SLOWER * (len(chosen) - 1) / (chosen[-1] - chosen[0])
                film.write(path, _frames(look, there, chosen), pace)
                if os.path.getsize(path) <= LARGEST:
                    break
            else:
                return "", f"no film: more than {LARGEST / 1e6:g} MB"
            with open(path, "rb") as stream:
                content = stream.read()
    except film.InputError as error:
        return "", f"no film: {error}"
    caption = f"{times[0]:.4g} to {times[-1]:.4g} s, at {SLOWER:g} of their pace; colours as above."
    return page_html.film("video/mp4", content, f"film of {', '.join(name for _, name in there)}", caption), ""


def _frames(look, there, times):
    lines = math.ceil(len(there) / 4)
    across = math.ceil(len(there) / lines)
    figure, axes = plt.subplots(lines, across, figsize=(1.6 * across, lines * (1.5 * look.aspect + 0.25) + 0.2), squeeze=False)
    figure.subplots_adjust(left=0.01, right=0.99, bottom=0.01, top=1 - 0.42 / figure.get_figheight(), wspace=0.03, hspace=0.12)
    for each in axes.flat[len(there):]:
        each.set_visible(False)
    shown = []
    for each, (run, name) in zip(axes.flat, there):
        shown.append(_show(each, look.panel(run.nearest(times[0]), ACROSS * 2 // 3), look))
        each.set_title(name, fontsize=7, pad=2)
    words = figure.text(0.01, 1 - 0.03 / figure.get_figheight(), "", fontsize=8, va="top")
    for time in times:
        words.set_text(f"t = {time:.3f} s")
        for each, (run, _) in zip(shown, there):
            each.set_data(look.panel(run.nearest(time), ACROSS * 2 // 3))
        yield film.pixels(figure, 110)
    plt.close(figure)
