# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves of a picture: what /series tells of a run over time, and paths of few particles. No legend covers them."""

from dataclasses import dataclass

import numpy
from matplotlib.ticker import MaxNLocator

from interphase import picture_law
from interphase.picture_panels import INK

COLOURS = ("#31688e", "#d1495b", "#2e933c", "#8a5aab", "#c98a12", "#17a2a2", "#9c5238", "#555555")
CHANGE = 0.01  # of the number of particles, from which on it is drawn


@dataclass(frozen=True)
class Curve:
    """A panel: `label` of its axis, name of the series, and by what its values are divided for that unit."""

    label: str
    series: str
    unit: float = 1.0


PRESSURE = Curve("pressure drop [kPa]", "pressure_drop", 1000.0)
PARTICLES = Curve("tracked particles", "particles")
ENERGY = Curve("kinetic energy [J]", "kinetic_energy")


def curves_of(scenes):
    """The `Curve`s, two at most, that tell most of the runs: the pressure drop where there is gas, how the particles' number changes where it
    does, else their kinetic energy where there is no gas."""
    there = [scene.series for scene in scenes]
    found = []
    if any("pressure_drop" in each and numpy.isfinite(each["pressure_drop"].values).any() and each["pressure_drop"].values.any() for each in there):
        found.append(PRESSURE)
    if any("particles" in each and _changes(each["particles"].values) for each in there) or not found:
        found.append(PARTICLES)
    if PRESSURE not in found:
        found.append(ENERGY)
    return [curve for curve in found if any(curve.series in each for each in there)]


def _changes(count):
    return numpy.ptp(count) > CHANGE * max(count.max(), 1)


def draw_curve(axes, curve, scenes, times):
    """`times` [s] of the snapshots shown are marked."""
    ends = []
    for number, scene in enumerate(scenes):
        series = scene.series
        if curve.series not in series:
            continue
        found = series[curve.series]
        values, colour = found.values / curve.unit, COLOURS[number % len(COLOURS)]
        axes.plot(found.time, values, color=colour, linewidth=1.0, label=scene.name if len(scenes) > 1 else curve.label.partition(" [")[0])
        ends += _room(values)
        weight = series["bed_weight_per_area"] if curve is PRESSURE and "bed_weight_per_area" in series else None
        if weight is not None and weight.values.max(initial=0.0) > 1e-3 * numpy.nanmax(numpy.abs(found.values)):
            axes.plot(weight.time, weight.values / curve.unit, color=INK if len(scenes) == 1 else colour, linestyle="--", linewidth=1.0,
                      label="bed weight per area" if number == 0 else None)  # fmt: skip
            ends += [weight.values.min() / curve.unit, weight.values.max() / curve.unit]
    for time in times:
        axes.axvline(time, color="0.75", linewidth=0.8, zorder=0)
    low, high = min(ends + [0.0]), max(ends + [0.0])
    room = 0.08 * (high - low) or 1.0
    axes.set_ylim(low - (room if low < 0 else 0), high + room)
    finish(axes, curve.label)


def _room(values):
    """Ends of the axis: start-up peaks are cut where they would flatten the rest."""
    finite = values[numpy.isfinite(values)]
    if not finite.size:
        return []
    return list(numpy.percentile(finite, (0.5, 99.5)) if finite.size > 50 else (finite.min(), finite.max()))


def finish(axes, label, x="t [s]"):
    axes.margins(x=0)
    axes.yaxis.set_major_locator(MaxNLocator(5))
    axes.ticklabel_format(axis="y", scilimits=(-2, 5))
    axes.set(xlabel=x, ylabel=label)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    if len(axes.get_legend_handles_labels()[0]) > 1:
        axes.legend(loc="lower left", bbox_to_anchor=(-0.01, 1.0), fontsize=7, ncol=4, frameon=False, borderaxespad=0.2, handlelength=1.6,
                    columnspacing=1.2)  # fmt: skip


def draw_profile(axes, height, pressure, law):
    """Pressure [Pa] of layers of cells over their height [m], and what the drag law makes of their voidage; with its fall in the middle."""
    middle = len(height) // 2

    def words(name, values):
        fall = -(values[middle + 1] - values[middle - 1]) / (height[middle + 1] - height[middle - 1]) if 0 < middle < len(height) - 1 else numpy.nan
        return f"{name}, {fall / 1000:.4g} kPa/m" if numpy.isfinite(fall) else name

    axes.plot(pressure / 1000, height, color=COLOURS[0], linewidth=1.6, label=words("the run", pressure))
    if law is not None:
        axes.plot(law / 1000, height, color=INK, linewidth=1.0, linestyle=(0, (4, 3)), label=words("drag law", law))
    axes.xaxis.set_major_locator(MaxNLocator(4))
    axes.tick_params(labelleft=False)
    axes.set(xlabel="p_rgh above the top's [kPa]")
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    axes.legend(loc="lower left", bbox_to_anchor=(-0.02, 1.0), fontsize=7, frameon=False, borderaxespad=0.2, handlelength=1.6)


def draw_paths(velocity, height, scene):
    """Vertical velocity and height over time of each particle that the first snapshot has, and the drag law's for the first."""
    first = scene.snapshots[0]
    time = scene.times
    table = {each: numpy.full((len(time), 2), numpy.nan) for each in first.ids}
    for row, snapshot in enumerate(scene.snapshots):
        for name, up, z in zip(snapshot.ids, snapshot.velocities[:, 2], snapshot.positions[:, 2]):
            if name in table:
                table[name][row] = up, z
    single = len(table) == 1
    for number, (name, values) in enumerate(table.items()):
        colour = COLOURS[number % len(COLOURS)]
        label = ("the run" if single else f"particle {name}") if number < 8 else None
        velocity.plot(time, values[:, 0], color=colour, linewidth=1.6, label=label)
        height.plot(time, values[:, 1], color=colour, linewidth=1.6)
    law = picture_law.fall(scene, 0)
    if law is not None:
        name, terminal, on_the_way = law
        if on_the_way is not None:
            velocity.plot(time, on_the_way, color=INK, linewidth=1.0, linestyle=(0, (4, 3)), label=f"equation of motion with {name}")
        velocity.axhline(terminal, color="0.55", linewidth=0.9, linestyle=":", label=f"terminal velocity of {name}: {terminal:.4g} m/s")
    velocity.margins(y=0.08)
    finish(velocity, "vertical velocity [m/s]")
    height.margins(y=0.08)
    finish(height, "height z [m]")
    velocity.set_xlabel("")
    velocity.tick_params(labelbottom=False)
