# SPDX-License-Identifier: GPL-3.0-or-later
"""What tools/envelope runs for a point of its map: the case, its settings, and when to measure. SI units.

Every run is short: some relaxation times where the gas step is short, some gas steps where it is long.
"""

import math
from dataclasses import dataclass, field

from interphase.uniform_suspension import Suspension

SCENES = ("closed", "fluidized", "packed", "fine")
METHODS = ("TDHS", "DEM", "CGHS", "CGPM", "MPPIC")
OF_PARCELS = ("CGHS", "CGPM", "MPPIC")
FRACTIONS = {"closed": (0.1, 0.3, 0.4, 0.5), "fluidized": (0.1, 0.3, 0.4, 0.5), "packed": (0.57,), "fine": (0.57,)}
RATIOS = (1e-3, 1e-2, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0)  # gas step over relaxation time
WEIGHT = 8
SEDIMENT = 0.62  # solid fraction of what settles, at most
ROWS = 400  # most snapshots of a run


@dataclass(frozen=True)
class Point:
    """Of the map: a scene, a method, the solid fraction `phi` and the gas step over the relaxation time, `ratio`."""

    scene: str
    method: str
    phi: float
    ratio: float

    def name(self):
        """Of its folder."""
        return f"{self.scene}-{self.method}-{self.phi:g}-{self.ratio:g}"


@dataclass
class Plan:
    """settings: of `parameters`; windows: name -> (from, to) [s] in which something is measured."""

    case: str
    suspension: Suspension
    step: float
    until: float
    settings: dict = field(default_factory=dict)
    windows: dict = field(default_factory=dict)
    weight: float = 1


class NotRun(Exception):
    """A point beyond the map; the message says why."""


def plan(point):
    """The `Plan` of a point; NotRun where a step would carry a particle past a cell, or would take too many steps."""
    return {"closed": _closed, "fluidized": _fluidized, "packed": _packed, "fine": _fine}[point.scene](point)


def water(phi):
    """Spheres of 1 mm and 2000 kg/m3 in water, at the solid fraction `phi`."""
    return Suspension(phi, 1e-3, 2000.0, 1000.0, 1e-3, "WenYu")


def _finished(made, point):
    """Steps and records that every scene has."""
    steps = made.until / made.step
    # an odd number of steps between records, or an alternation would go unseen
    every = 2 * math.ceil((steps / ROWS - 1) / 2) + 1 if steps > ROWS else 1
    made.settings.update(gasStep=f"{made.step:.9g}", recordInterval=f"{every * made.step:.9g}")
    made.until = math.ceil(steps - 1e-6) * made.step
    made.weight = made.weight if point.method in OF_PARCELS else 1
    return made


def _size(point, narrow):
    """(width, cell, scale) of a column in water: parcels stand in one as many of their diameters wide."""
    scale = 2.0 if point.method in OF_PARCELS else 1.0
    return 0.005 * scale if narrow else 0.01 * scale, 0.0025 * scale, scale


def _closed(point):
    s = water(point.phi)
    tau, speed = s.relaxation_time(), s.hindered_velocity()
    step = point.ratio * tau
    narrow = point.ratio < 0.03 or point.ratio > 2
    width, cell, scale = _size(point, narrow)
    if speed * step > cell:
        raise NotRun(f"a particle crosses {speed * step / cell:.2g} cells in a step")
    start = max(6 * tau, 2 * step)
    end = start + (3 * tau if point.ratio < 0.03 else max(10 * tau, 8 * step))
    front = max(speed, speed * point.phi / (SEDIMENT - point.phi))
    height = max(24 * cell, 3 * (front * end / 0.85))
    height = min(math.ceil(height / cell - 1e-6), 24 * 6) * cell
    end = min(end, 0.85 * height / 3 / front)
    if end < start + 2.5 * step:
        raise NotRun(f"fronts arrive after {end / step:.2g} steps")
    across = round(width / cell)
    return _finished(Plan(
        "suspension", s, step, end,
        {"mode": "closed", "solidFraction": point.phi, "width": width, "depth": width, "height": height,
         "cells": f"({across} {across} {round(height / cell)})"},
        {"settling": (start, end)}, WEIGHT), point)  # fmt: skip


def _fluidized(point):
    s = water(point.phi)
    tau = s.relaxation_time()
    step = point.ratio * tau
    # One cell across: where there are many, the bed finds channels as a steady state, and then stands 12 % lower
    width, cell, _ = _size(point, True)
    speed = s.carrying_velocity()
    bed = 16 * cell
    moves = point.ratio > 0.03  # long enough to see it find its height
    start = min(1.04 * point.phi, 0.56) if moves else point.phi
    # what is wrong at the bottom has gone through the bed after its height over the speed of a kinematic wave
    exponent = 3.65 - 1 + 2 * point.phi
    wave = bed / max(exponent * speed * point.phi / s.voidage, 1e-9)
    settle = max(2 * wave, 10 * tau, 6 * step) if moves else 6 * tau
    end = settle + (max(5 * tau, 10 * step) if moves else 3 * tau)
    return _finished(Plan(
        "suspension", s, step, end,
        {"mode": "fluidized", "solidFraction": point.phi, "startFraction": f"{start:.6g}", "bedHeight": bed,
         "width": width, "depth": width, "height": 24 * cell, "cells": "(1 1 24)"},
        {"bed": (settle, end)}, WEIGHT), point)  # fmt: skip


def _stream(point, s, lengths, low, high, weight):
    """A bed that settles in a weak stream, `low`, and then gets a strong one, `high` [m/s]; `settling`: of its fall [m/s]."""
    tau = s.relaxation_time()
    step = point.ratio * tau
    if point.ratio < 5e-3:
        raise NotRun(f"more than {90 * tau / step:.2g} steps, until the bed has settled and answered")
    cell = lengths["height"] / lengths["layers"]
    if 2 * high / s.voidage * step > 4 * cell:
        raise NotRun(f"the gas crosses {high / s.voidage * step / cell:.2g} cells in a step, particles more than one as the bed falls")
    # The bed comes to rest in the time that its height takes at a quarter of the stream that carries it
    falls = 0.5 * lengths["height"] / (4 * s.carrying_velocity())
    rest, ramp, hold = max(1.3 * falls, 10 * step), max(10 * tau, step), max(30 * tau, 10 * step)
    settings = {key: lengths[key] for key in lengths if key != "layers"}
    settings.update(lowVelocity=f"{low:.6g}", highVelocity=f"{high:.6g}", rampStart=f"{rest:.6g}", rampEnd=f"{rest + ramp:.6g}")
    end = rest + ramp + hold
    return _finished(Plan(
        "bed-at-rest", s, step, end, settings,
        {"rest": (rest - max(5 * tau, 4 * step), rest - 0.5 * step), "flow": (end - max(20 * tau, 7 * step), end)}, weight), point)  # fmt: skip


def _packed(point):
    s = Suspension(point.phi, 1e-3, 2000.0, 10.0, 1.5e-3, "Ergun")
    lengths = {"particleCount": 1600, "width": 0.01, "depth": 0.01, "height": 0.03, "layers": 24, "cells": "(4 4 24)",
               "tapLow": 0.0044, "tapHigh": 0.0294}
    if point.method in OF_PARCELS:
        lengths = {"particleCount": 12800, "width": 0.02, "depth": 0.02, "height": 0.06, "layers": 24, "cells": "(4 4 24)",
                   "tapLow": 0.0088, "tapHigh": 0.0588, "springConstant": 400}  # fmt: skip
    return _stream(point, s, lengths, 0.6 * s.carrying_velocity(), 0.020, WEIGHT)


def _fine(point):
    if point.method not in OF_PARCELS:
        raise NotRun("of parcels")
    s = Suspension(point.phi, 75e-6, 1500.0, 1.2, 1.8e-5, "Ergun")
    lengths = {"particleCount": 102400, "diameter": 75e-6, "particleDensity": 1500, "gasDensity": 1.2, "gasViscosity": 1.8e-5,
               "springConstant": 1, "width": 0.003, "depth": 0.003, "height": 0.009, "layers": 24, "cells": "(4 4 24)",
               "tapLow": 0.00132, "tapHigh": 0.00882}  # fmt: skip
    return _stream(point, s, lengths, 0.6 * s.carrying_velocity(), 2 * s.carrying_velocity(), 64)
