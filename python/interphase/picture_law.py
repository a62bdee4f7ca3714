# SPDX-License-Identifier: GPL-3.0-or-later
"""What the drag law of a run says of it, by the numbers of its case: the fall of one sphere, the pressure in a packing that is held."""

import os

import numpy
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from interphase import foam_field, parameters
from interphase.drag_laws import LAWS
from interphase.input_error import InputError

NUMBERS = ("gasDensity", "gasViscosity", "gravity")


def fall(scene, at):
    """(name of the law, terminal velocity [m/s], velocity [n] at the snapshots' times or None) of particle `at` of the first snapshot: by its weight,
    buoyancy and the drag law, alone in the gas. None where law or numbers are not known.

    The velocity on the way is known where the gas is held uniform and drag is the only term.
    """
    law, first = scene.meta.get("drag_law"), scene.snapshots[0]
    numbers = [scene.number(name) for name in NUMBERS]
    if law not in LAWS or None in numbers or "density" not in first.names:
        return None
    density, viscosity, gravity = numbers
    diameter = float(first.diameters[at]) / float(scene.meta.get("weight", 1.0)) ** (1 / 3)  # the law is of real particles
    own = float(first.densities[at])
    gas = _held_velocity(scene)

    def rate(velocity, of_gas):
        slip = abs(velocity - of_gas)
        drag = 18 * viscosity * LAWS[law](1.0, density * slip * diameter / viscosity) * (of_gas - velocity) / (diameter**2 * own)
        return drag - (1 - density / own) * gravity

    pull = -1 if own > density else 1
    end = 1.0
    while rate(pull * end, 0.0) * pull > 0 and end < 1e6:
        end *= 2
    terminal = brentq(lambda speed: rate(pull * speed, 0.0), 0.0, end) * pull + (gas or 0.0)
    on_the_way = None
    if gas is not None and _only_drag(scene):
        start = float(first.velocities[at, 2])
        on_the_way = solve_ivp(lambda _, v: [rate(v[0], gas)], (scene.times[0], scene.times[-1]), [start], method="LSODA",
                               t_eval=scene.times, rtol=1e-8, atol=1e-10).y[0]  # fmt: skip
    return law if gas is not None else f"{law} in gas at rest", terminal, on_the_way


def _settings(scene):
    try:
        return parameters.read(os.path.join(scene.run.path, "system", "couplingDict"))
    except InputError:
        return {}


def _only_drag(scene):
    return _settings(scene).get("forces", "()").replace(" ", "") == "()"


def _held_velocity(scene):
    """Upwards [m/s], of a gas that is held and uniform; None of others."""
    path = foam_field.path_of(os.path.join(scene.run.path, "0"), "U")
    gas = _settings(scene).get("gas", {})
    if path is None or not isinstance(gas, dict) or gas.get("model") != "frozen":
        return None
    try:
        field = foam_field.internal_field(path)
    except (InputError, ValueError):
        return None
    return float(field.values[0, 2]) if field.uniform and field.values.shape[1] == 3 else None


def profile(scene, voidage, pressure, velocity):
    """(height [n] of layers of cells, m, their mean pressure [n], the law's [n] or None, both above the uppermost's, Pa) of three `Section`s of
    the same time.

    The law's is of steady flow through particles at rest, eps dp/dz = -18 mu (1 - eps) F U/d^2 with the voidage of each layer and its superficial
    velocity U, the mean of eps u_z. It is the run's in the middle layer: at the ends of a packing, where the voidage changes within a cell, a
    layer's mean is not what drag is made of.
    """
    layers, which, count = numpy.unique(numpy.round(voidage.middles[:, 1], 9), return_inverse=True, return_counts=True)

    def mean(values):
        return numpy.bincount(which, values) / count

    by_run = mean(pressure.values)
    by_run -= by_run[-1]
    law = LAWS.get(scene.meta.get("drag_law"))
    density, viscosity, diameter = (scene.number(name) for name in ("gasDensity", "gasViscosity", "diameter"))
    if law is None or None in (density, viscosity, diameter):
        return layers, by_run, None
    slope = numpy.zeros(len(layers))
    for n, (eps, superficial) in enumerate(zip(mean(voidage.values), mean(voidage.values * velocity.values[:, 2]))):
        if eps < 1 - 1e-6:
            reynolds = density * abs(superficial) * diameter / viscosity
            slope[n] = -18 * viscosity * (1 - eps) * law(eps, reynolds) * superficial / (eps * diameter**2)
    by_law = numpy.concatenate([[0.0], numpy.cumsum(numpy.diff(layers) * (slope[1:] + slope[:-1]) / 2)])
    middle = len(layers) // 2
    return layers, by_run, by_law - by_law[middle] + by_run[middle]
