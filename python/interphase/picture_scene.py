# SPDX-License-Identifier: GPL-3.0-or-later
"""A run as a picture shows it: what it is called, its walls, its snapshots and the gas at their times."""

import os
import re
from dataclasses import dataclass
from functools import cached_property

import numpy

from interphase import gas_mesh, parameters, script_walls
from interphase.gas_section import GasSections
from interphase.input_error import InputError
from interphase.picture_quantities import GAS, check
from interphase.run import Run
from interphase.same_time import same_time
from interphase.wall_lines import Walls

FEW = 20  # particles whose paths are drawn, since a picture of the vessel shows little of them


@dataclass
class Shown:
    """The tracked spheres at one `time` [s]: position [n, 3] and diameter [n] in m, `values` [n] of their colours; `gas`: a Section or None."""

    time: float
    position: numpy.ndarray
    diameter: numpy.ndarray
    values: numpy.ndarray
    gas: object = None


class Scene:
    """The run in the folder `path`; InputError where it has no snapshots."""

    def __init__(self, path):
        if not os.path.isdir(path):
            raise InputError(f"{path}: no such folder; give a run's folder, such as runs/sscp1-CGPM-w8")
        if not os.path.isfile(os.path.join(path, "particles.h5")):
            raise InputError(f"{path} holds no particles.h5: no run of interphase has written particles there")
        self.run = Run(path)
        self.name = os.path.basename(self.run.path)
        self.meta = self.run.meta
        self.snapshots = list(self.run.snapshots)
        if not self.snapshots:
            raise InputError(f"{path}/particles.h5 holds no snapshots yet")
        self.times = numpy.array([each.time for each in self.snapshots])
        self.domain = numpy.asarray(self.meta["domain"], dtype=float).reshape(2, 3) if "domain" in self.meta else None
        meshes = [gas_mesh.read(each) for each in gas_mesh.pieces(path)] if self.domain is not None else []
        self.walls = Walls(script_walls.read(path), meshes, self.depth, gas_mesh.closed_patches(path))
        self.gas = GasSections(path, self.walls.y)

    @cached_property
    def depth(self):
        """(front, back) of the vessel in y, m."""
        if self.domain is not None:
            return tuple(self.domain[:, 1])
        walls = Walls(script_walls.read(self.run.path), [], (0.0, 0.0)).bounds()
        if numpy.isfinite([walls[0][1], walls[1][1]]).all() and walls[1][1] > walls[0][1]:
            return walls[0][1], walls[1][1]
        boxes = [self.box(self.snapshots[at]) for at in {0, len(self.snapshots) - 1}]
        ends = [(low[1], high[1]) for low, high in boxes if low is not None]
        return (min(each[0] for each in ends), max(each[1] for each in ends)) if ends else (0.0, 1.0)

    @staticmethod
    def box(snapshot):
        """(low, high) corners [3] of the box about its spheres; (None, None) where it has none."""
        position, radius = snapshot.positions.reshape(-1, 3), snapshot.diameters[:, None] / 2
        return ((position - radius).min(axis=0), (position + radius).max(axis=0)) if len(radius) else (None, None)

    def shown(self, snapshot, quantity, gas=None):
        """The `Shown` of a snapshot; `gas`: a name of GAS, read at the time that is nearest."""
        section = self.gas.nearest(GAS[gas][0], snapshot.time) if gas else None
        values = numpy.asarray(quantity.of(snapshot, self.snapshots[0]), dtype=float)
        return Shown(snapshot.time, snapshot.positions.astype(float).reshape(-1, 3), snapshot.diameters.astype(float), values, section)

    def check(self, name, quantity):
        """InputError where its snapshots do not hold what the colours are of."""
        check(name, quantity, self.snapshots[-1])

    def has_gas_at(self, time, field):
        """Whether `field` was written at `time` [s]."""
        times = numpy.array(list(self.gas.times(field)))
        return bool(len(times)) and same_time(time, times[numpy.argmin(numpy.abs(times - time))])

    def chosen(self, count, gas, until=numpy.inf):
        """Up to `count` snapshots at evenly spaced times, the last one before `until` [s] included; of those with fields of the gas where `gas` asks
        for it and there are two."""
        early = [n for n, time in enumerate(self.times) if time <= until or same_time(time, until)] or [0]
        there = [n for n in early if gas and self.has_gas_at(self.times[n], GAS[gas][0])]
        usable = there if len(there) > 1 else early
        return [self.snapshots[usable[at]] for at in evenly_spaced(self.times[usable], count)]

    @property
    def series(self):
        """{name: Series} of /series; {} before there are two rows."""
        found = self.run.series if os.path.isfile(os.path.join(self.run.path, "results.h5")) else {}
        return found if any(len(found[name].time) > 1 for name in list(found)[:1]) else {}

    @property
    def title(self):
        """Its parts: case, method, weight."""
        words = [str(self.run.record.get("case") or self.meta.get("case", self.name))]
        words += [str(self.meta["method"])] if "method" in self.meta else []
        return words + (["W = " + weights(self.meta)] if "weight" in self.meta else [])

    @property
    def operating_point(self):
        """What it was run with, in parts: particles, velocities of the case's `parameters`, drag law, gas step."""
        words = []
        if "real_particles" in self.meta:
            real, tracked = (float(self.meta[name]) for name in ("real_particles", "particles"))
            most = float(self.series["particles"].values.max(initial=0.0)) if "particles" in self.series else tracked
            if most > tracked or float(self.meta.get("particles_at_start", tracked)) != tracked:
                words.append(f"up to {most:,.0f} tracked particles")  # they come and go
            else:
                words.append(f"{real:,.0f} particle" + ("s" if real != 1 else "") + (f" as {tracked:,.0f} parcels" if tracked != real else ""))
        if self.domain is None:
            return words
        words += [f"{name} {value:g} m/s" for name, value in self.velocities.items()]
        words += [f"drag {self.meta['drag_law']}"] if self.meta.get("drag_law", "none") != "none" else []
        return words + ([f"gas step {self.meta['gas_step'] * 1000:.3g} ms"] if "gas_step" in self.meta else [])

    @cached_property
    def parameters(self):
        """{name: text} of the case's `parameters`, {} where it has none that can be read."""
        path = os.path.join(self.run.path, parameters.PARAMETERS)
        try:
            return parameters.read(path) if os.path.isfile(path) else {}
        except InputError:
            return {}

    def number(self, name):
        """Of `parameters`; None where it is not there, or no number."""
        value = self.parameters.get(name)
        value = parameters.numbers(value) if isinstance(value, str) else None
        return value if isinstance(value, float) else None

    @property
    def velocities(self):
        """{words: m/s} of the case's `parameters` whose names end in Velocity: "inlet velocity"."""
        names = [name for name in self.parameters if re.search("[vV]elocity$", name) and self.number(name) is not None]
        return {re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name).lower(): self.number(name) for name in names}

    @property
    def few(self):
        """Whether paths tell more than the vessel."""
        return max(len(each.ids) for each in (self.snapshots[0], self.snapshots[-1])) <= FEW and len(self.snapshots) > 2

    @property
    def held(self):
        """Whether nothing moves at all, as in a packing that is held."""
        return all(len(each.ids) and not each.velocities.any() for each in (self.snapshots[0], self.snapshots[-1]))


def weights(meta):
    """Real particles per tracked one: "8", or "1 to 27" where they differ."""
    low, high = (float(numpy.ravel(meta.get(name, meta["weight"]))[0]) for name in ("lowest_weight", "highest_weight"))
    return f"{low:g}" if low == high else f"{low:g} to {high:g}"


def evenly_spaced(times, count):
    """Indices of up to `count` snapshots at evenly spaced times, the last one included.

    The start is left out where there are enough others: a bed at rest tells nothing.
    """
    if len(times) <= count:
        return list(range(len(times)))
    wanted = times[0] + (times[-1] - times[0]) * numpy.arange(1, count + 1) / count
    return sorted({int(numpy.argmin(numpy.abs(numpy.asarray(times) - w))) for w in wanted})


def view(scenes, shown):
    """(left, right, bottom, top) in m, and whether the top is the vessel's.

    The vessel where it is known, but no more of its empty upper part than the bed needs.
    """
    boxes = [(each.position - each.diameter[:, None] / 2, each.position + each.diameter[:, None] / 2) for each in shown if len(each.diameter)]
    walls = [scene.walls.bounds() for scene in scenes] + [tuple(scene.domain) for scene in scenes if scene.domain is not None]
    low = numpy.nanmin([each[0] for each in walls] + [numpy.full(3, numpy.inf)], axis=0)
    high = numpy.nanmax([each[1] for each in walls] + [numpy.full(3, -numpy.inf)], axis=0)
    if not boxes and not (numpy.isfinite(low).all() and numpy.isfinite(high).all()):
        raise InputError("the snapshots hold no particles")
    if boxes:
        bed_low, bed_high = numpy.min([b[0].min(axis=0) for b in boxes], axis=0), numpy.max([b[1].max(axis=0) for b in boxes], axis=0)
    else:
        bed_low, bed_high = low, high
    left, right = min(low[0], bed_low[0]), max(high[0], bed_high[0])
    bottom, top = min(low[2], bed_low[2]), max(high[2], bed_high[2])
    needed = bottom + max(1.12 * (bed_high[2] - bottom), 0.6 * (right - left))
    cropped = needed < 0.85 * top + 0.15 * bottom
    return (left, right, bottom, needed if cropped else top), not cropped
