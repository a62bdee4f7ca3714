# SPDX-License-Identifier: GPL-3.0-or-later
"""What is measured of a run of tools/envelope: its particles.h5 and results.h5 against the drag law."""

import dataclasses

import numpy

from interphase.envelope_verdict import Measures, alternation, deviation
from interphase.run_records import find_run
from interphase.series import Table

BOOKS = ("momentum_residual", "volume_residual", "gas_volume_residual")


def measure(folder, point, plan):
    """`Measures` of the run in `folder`; None where it holds no records of the windows."""
    run = find_run(folder)
    if run is None or run.particles is None or run.results is None:
        return None
    found = {"closed": _settling, "fluidized": _bed, "packed": _drops, "fine": _drops}[point.scene](run, plan)
    return found and dataclasses.replace(found, closed=_books(run.results))


def _books(path):
    """The largest residual of the books over the run."""
    ledger = Table(path, "ledger")
    return float(max((abs(ledger[name].values).max(initial=0.0) for name in BOOKS if name in ledger), default=0.0))


def _within(window, plan):
    return window[0] - 0.25 * plan.step, window[1] + 0.25 * plan.step


def _series(run, plan, name, window):
    """The rows of a series inside a window."""
    recorded = run.series()
    if recorded is None or name not in recorded[1]:
        return numpy.empty(0)
    low, high = _within(plan.windows[window], plan)
    return recorded[1][name][(recorded[0] >= low) & (recorded[0] <= high)]


def _frames(run, plan, window):
    """(position, velocity) [n, 3] of the snapshots inside a window."""
    low, high = _within(plan.windows[window], plan)
    for frame in run.frames(only=("position", "velocity")):
        if low <= frame.time <= high:
            state = frame.load().quantities
            yield state["position"], state["velocity"]


def _settling(run, plan):
    """Closed box: vertical velocity of the particles in the middle third against the hindered one."""
    height, speed = plan.settings["height"], plan.suspension.hindered_velocity()
    falling = []
    for position, velocity in _frames(run, plan, "settling"):
        middle = (position[:, 2] > height / 3) & (position[:, 2] < 2 * height / 3)
        falling.append(-velocity[middle, 2].mean() / speed if middle.any() else numpy.nan)
    if not falling:
        return None
    return Measures({"velocity": float(numpy.mean(falling)) - 1}, deviation(falling), alternation(falling), len(falling))


def _bed(run, plan):
    """Fluidized: solid fraction inside the bed and its height against the law's equilibrium; nothing moves."""
    bed, s = plan.settings["bedHeight"], plan.suspension
    area = plan.settings["width"] ** 2
    volume = numpy.pi / 6 * s.diameter**3 * plan.weight
    inside, heights = [], []
    low, high = 0.25 * bed, 0.65 * bed
    for position, _ in _frames(run, plan, "bed"):
        z = position[:, 2]
        inside.append(((z > low) & (z < high)).sum() * volume / (area * (high - low) * s.phi))
        heights.append(2 * z.mean() / bed)
    if not inside:
        return None
    moves = _series(run, plan, "vertical_velocity", "bed") / s.carrying_velocity()
    weight = s.weight_gradient() * bed
    drop = _series(run, plan, "pressure_drop", "bed") / weight
    errors = {"height": float(numpy.mean(heights)) - 1, "solid fraction": float(numpy.mean(inside)) - 1}
    # the better of the two: the height holds the ends of the bed, which the kernel smears; the fraction the noise of waves
    best = min(errors, key=lambda name: abs(errors[name]))
    return Measures({best: errors[best]}, max(deviation(moves), deviation(drop)), max(alternation(moves), alternation(drop)), len(inside))


class Column:
    """A bed as its gas sees it: particles at heights `z` [n] spread over layers by the coupler's kernel, a hat of at least two diameters."""

    def __init__(self, z, volume, area, height, layers, reach):
        """`volume`: of a particle; `reach`: half width of the hat [m]."""
        self.cell, self.layers = height / layers, layers
        middle = (numpy.arange(layers) + 0.5) * self.cell
        hat = numpy.maximum(1 - abs(z[:, None] - middle) / max(reach, self.cell), 0)
        self.share = hat / hat.sum(axis=1, keepdims=True)
        self.solid = volume / (area * self.cell)
        self.voidage = 1 - self.share.sum(axis=0) * self.solid

    def above(self, tap, of_layer):
        """Sum of `of_layer` [layers] times thickness from the middle of the layer that holds the height `tap` to the top."""
        first = int(tap / self.cell)
        return float((of_layer[first:].sum() - 0.5 * of_layer[first]) * self.cell)

    def weight(self, tap, s):
        """Of the particles above, less buoyancy [Pa]."""
        return self.above(tap, (1 - self.voidage) * (s.particle_density - s.density) * s.gravity)

    def drop(self, tap, s, superficial):
        """By the drag law, particles at rest in a stream [Pa]: eps dp/dz = drag, voidage and slip taken where each particle is."""
        there = self.share @ self.voidage
        slip = self.share @ (superficial / self.voidage)
        drag = numpy.array([dataclasses.replace(s, phi=1 - eps).rate(u) * u for eps, u in zip(there, slip)])
        return self.above(tap, self.share.T @ drag * self.solid / self.voidage)


def _drops(run, plan):
    """Bed at rest: the drop from a tap inside it to the free gas is the law's below minimum fluidization, the weight above."""
    settings, s = plan.settings, plan.suspension
    layers, height, tap = int(settings["cells"].strip("()").split()[2]), settings["height"], settings["tapLow"]
    volume, area = numpy.pi / 6 * s.diameter**3 * plan.weight, settings["width"] * settings["depth"]
    reach = 2 * s.diameter * plan.weight ** (1 / 3)
    fluid = s.density * s.gravity * (int(settings["tapHigh"] / height * layers) - int(tap / height * layers)) * height / layers
    expected = {}
    for window, of_column in (
        ("rest", lambda column: column.drop(tap, s, float(settings["lowVelocity"]))),
        ("flow", lambda column: column.weight(tap, s)),
    ):
        columns = [Column(z[:, 2], volume, area, height, layers, reach) for z, _ in _frames(run, plan, window)]
        if not columns:
            return None
        expected[window] = float(numpy.mean([of_column(column) for column in columns]))
    rest, flow = (_series(run, plan, "pressure_drop", window) - fluid for window in ("rest", "flow"))
    if not len(rest) or not len(flow):
        return None
    errors = {"drop at rest": rest.mean() / expected["rest"] - 1, "drop over weight": flow.mean() / expected["flow"] - 1}
    swings = [values / expected["flow"] for values in (rest, flow)]
    # waves that pass the tap are the bed's own: rms counts at rest
    return Measures(errors, deviation(swings[0]), max(map(alternation, swings)), min(len(rest), len(flow)))
