# SPDX-License-Identifier: GPL-3.0-or-later
"""Which step does the coupling scheme bear? A replica of it for a column along z: cells, particles, contacts, waves.

Particles are layers: sheets of the solid volume `a` [m3 per m2 of cross-section], several to a cell, that keep their order and the
distance a/PACKED. Drag is Wen and Yu's. The gas has neither convection nor viscosity. All SI, per unit cross-section; z and all
velocities point up. In one dimension continuity alone gives the flux of the mixture at each face, so that the pressure
equation needs no matrix: each face's gradient follows from its flux.

    column = Column(WATER, Scheme(), dt, dz, *even_layers(0.3, 24, dz))
    for _ in range(100):
        column.step()

column_limits scans it.
What the schemes are called: 'mixture', pressure force and flux of the solids in the gas solve; 'implicit', the force alone; 'now', neither.
"""

from dataclasses import dataclass

import numpy as np

GRAVITY = 9.81
PACKED = 0.62  # solid fraction of touching layers
CELLS, PER_CELL = 24, 6


@dataclass(frozen=True)
class Fluid:
    """A fluid [kg/m3, Pa s] and the particles in it [kg/m3, m]."""

    name: str
    particle_density: float
    density: float
    viscosity: float
    diameter: float


WATER = Fluid("1 mm, 2000 kg/m3, water", 2000, 1000, 1e-3, 1e-3)
AIR = Fluid("120 um, 1000 kg/m3, air", 1000, 1.2, 1.8e-5, 1.2e-4)


@dataclass(frozen=True)
class Scheme:
    """The coupling and its variants.

    `hold`: 'prior', h = (-S_c S_f + h0 f2)/(S_f2 + f2), f = `doubt` times what gravity alone gives; 'coupler', as
    coupler/momentum/drag_response.cpp; or a number, the same everywhere. `wall`, the pressure gradient at walls:
    'hydrostatic', that of the fluid at rest (p_rgh without gradient, as in the program); 'flux', which stops the fluid;
    'extrapolated', the next face's. `face`: S and A of the continuity at faces, 'linear' or 'upwind' (from where the
    solids come). `memory`: the face keeps its flux of the last step (OpenFOAM's ddtCorr). `owed`: share of the owed
    volume that a step delivers. `forces`: on 'cells', or on 'faces', whose mean is the cell's: a force that alternates from cell to
    cell, which no face sees, then moves nothing (OpenFOAM's reconstruct).
    """

    kind: str = "mixture"  # or 'implicit', 'now'
    hold: object = "prior"
    prior: float = 0.5
    doubt: float = 0.05
    owed: float = 1.0
    wall: str = "hydrostatic"
    face: str = "linear"
    memory: bool = False
    forces: str = "cells"  # or 'faces'
    substeps: int = 10

    @staticmethod
    def judge(by_contacts, without, weight, steps):
        """As Hold::judge of coupler/momentum/drag_response.cpp."""
        enough, expected = 10, np.abs(without)
        known = np.where(weight > 0, np.clip((expected / np.where(weight > 0, weight, 1) - 0.02) / 0.08, 0, 1), 1)
        rests = np.abs(by_contacts + without) <= 1e-3 * np.maximum(expected, 0.1 * weight)
        more = np.where(steps < 0, enough, np.minimum(steps + 1, enough))
        steps[:] = np.maximum(np.where(~rests, 0, np.where(known >= 1, more, steps)), 0)
        touched = np.clip((np.abs(by_contacts) / np.where(expected > 0, expected, 1) - 0.1) / 0.2, 0, 1)
        held = np.where(expected > 0, steps / enough, 1.0)
        return held, np.where(expected > 0, (1 - held) * (1 - known * (1 - touched)), 0.0)


def drag_rate(phi, slip, fluid):
    """Wen and Yu: drag per volume of particle and slip [kg/(m3 s)]; phi and slip [m/s] are arrays."""
    eps, d = 1 - phi, fluid.diameter
    re = np.maximum(eps * fluid.density * slip * d / fluid.viscosity, 1e-12)
    factor = np.where(re < 1000, 1 + 0.15 * re**0.687, 0.44 * re / 24) * eps**-3.65
    return 18 * fluid.viscosity * eps * factor / d**2


def hindered(phi, fluid):
    """Velocity [m/s] at which particles settle in a closed column, a magnitude, and their tau = m/k there [s]."""
    eps = 1 - np.asarray(phi, float)
    weight = eps * (fluid.particle_density - fluid.density) * GRAVITY
    low, high = np.full_like(eps, 1e-9), np.full_like(eps, 10.0)
    for _ in range(60):
        slip = np.sqrt(low * high)
        slow = drag_rate(1 - eps, slip, fluid) * slip < weight
        low, high = np.where(slow, slip, low), np.where(slow, high, slip)
    return eps * slip, fluid.particle_density / drag_rate(1 - eps, slip, fluid)


def relaxed_share(x):
    """(1 - e^-x)/x."""
    return np.where(x > 1e-8, -np.expm1(-x) / np.maximum(x, 1e-300), 1 - x / 2)


class Weights:
    """Hats on the centres of the `cells` cells of height dz [m], for layers at z [m]; normalised where a wall cuts them."""

    def __init__(self, z, dz, cells):
        position = np.clip(z / dz - 0.5, 0, cells - 1)
        self.low = np.minimum(position.astype(int), cells - 2)
        self.up = position - self.low
        self.cells = cells

    def to_cells(self, values):
        """Sums over the layers."""
        below = np.bincount(self.low, (1 - self.up) * values, self.cells)
        return below + np.bincount(self.low + 1, self.up * values, self.cells)

    def to_layers(self, values):
        """Means over the cells: the transpose."""
        return (1 - self.up) * values[self.low] + self.up * values[self.low + 1]


def rising(values, weights, low, high):
    """The rising series between `low` and `high` nearest to `values` in the weighted square: pool adjacent violators."""
    means, sums, counts = [], [], []
    for value, weight in zip(values.tolist(), weights.tolist()):
        mean, total, count = value, weight, 1
        while means and means[-1] > mean:
            mean = (mean * total + means[-1] * sums[-1]) / (total + sums[-1])
            total += sums.pop()
            count += counts.pop()
            means.pop()
        means.append(mean)
        sums.append(total)
        counts.append(count)
    return np.clip(np.repeat(means, counts), low, high)


def held_by_contacts(by_contacts, without, weight, scheme, steps):
    """Per cell: how far contacts hold [0, 1], and how far that is a guess; arguments [kg/(m s)], sums over the cell, and how many
    steps on end they held it (below 0: nothing seen yet), renewed in place."""
    if not isinstance(scheme.hold, str):
        return np.full_like(weight, scheme.hold), np.zeros_like(weight)
    if scheme.hold == "prior":
        f2, known = (scheme.doubt * weight) ** 2, without**2
        sure = known + f2 > 0
        held = (scheme.prior * f2 - by_contacts * without) / np.where(sure, known + f2, 1)
        return np.where(sure, np.clip(held, 0, 1), scheme.prior), np.zeros_like(weight)
    return scheme.judge(by_contacts, without, weight, steps)


class Demand:
    """What the layers ask of the gas in a step: per layer (k, s, y, ...) and, from `cells`, per cell."""

    def __init__(self, column, weights, phi):
        fluid, scheme, dt, a = column.fluid, column.scheme, column.dt, column.a
        self.weights, self.u_before = weights, weights.to_layers(column.u)
        self.k = a * drag_rate(weights.to_layers(phi), np.abs(self.u_before - column.v), fluid)  # [kg/(m2 s)]
        self.m = a * fluid.particle_density
        self.s = relaxed_share(self.k * dt / self.m)
        sums = [weights.to_cells(values) for values in column.changes]
        held, doubt = held_by_contacts(*sums, scheme, column.hold_steps)
        self.held = weights.to_layers(held)
        self.y = (1 - self.held) * (1 - self.s)
        self.stiff = 0.5 * weights.to_layers(doubt) * (1 - self.s) * self.k
        known = weights.to_layers(column.gradient) * -a if scheme.kind == "now" else 0.0
        self.carried = self.y * (known - self.m * GRAVITY)  # [Pa]

    def cells(self, column):
        """Per cell: rate K [kg/(m3 s)], source [N/m3], following Y [-], mobility C [m3 s/kg], flux A [m/s]."""
        k, m, a, v, y = self.k, self.m, column.a, column.v, self.y
        source = (k * (1 - y)) * v + self.stiff * self.u_before + self.carried - column.pending / column.dt
        wanted = (k * (1 - y) + self.stiff, source, y * a, y * a * a / k, a * ((1 - y) * v - y * m * GRAVITY / k))
        return [self.weights.to_cells(values) / column.dz for values in wanted]

    def impulse(self, column, u, gradient):
        """That the gas solve assumed the fluid to give each layer [Pa s], without what was pending."""
        force = -column.a * gradient * (1.0 if column.scheme.kind == "now" else 1 - self.y)
        drag = self.k * (1 - self.y) * (u - column.v) + self.stiff * (u - self.u_before)
        return column.dt * (drag + force - self.carried)


class Column:
    """Closed at both ends, or with the superficial velocity `inlet` [m/s] from below.

    Layers at z with velocities v [m, m/s], the fluid at u in the cells, `gas` its volume in each by its own books [m].
    """

    def __init__(self, fluid, scheme, dt, dz, z, a, cells=CELLS, inlet=None):
        self.fluid, self.scheme, self.dt, self.dz, self.cells = fluid, scheme, dt, dz, cells
        self.z, self.a, self.inlet = np.array(z, float), a, inlet
        self.v, self.pending = np.zeros_like(self.z), np.zeros_like(self.z)
        self.changes = [np.zeros_like(self.z) for _ in range(3)]  # by contacts, without them, by gravity [Pa s]
        self.hold_steps = np.full(cells, -1)
        voidage = 1 - self.solid_fraction()
        self.gas = dz * voidage
        self.u = (inlet or 0.0) / voidage
        self.face_u = np.interp(np.arange(cells + 1), np.arange(cells) + 0.5, self.u)
        self.gradient = np.full(cells, -GRAVITY * fluid.density)
        self.given = self.taken = self.pushed = self.exchanged = 0.0  # impulses [Pa s]; pushed: by floor and ceiling
        self.entered = 0.0  # volume of gas [m]

    def solid_fraction(self):
        """Of the cells [cells]."""
        return Weights(self.z, self.dz, self.cells).to_cells(np.full_like(self.z, self.a)) / self.dz

    def owed(self):
        """Volume of gas in each cell beyond what fits [-]: the error of the last prediction of the solids' flux."""
        return self.gas / self.dz - 1 + self.solid_fraction()

    def step(self):
        """One gas step of `dt` [s]."""
        weights = Weights(self.z, self.dz, self.cells)
        demand = Demand(self, weights, self.solid_fraction())
        u, gradient = self.solve_gas(*demand.cells(self))
        self.move_layers(demand, weights.to_layers(u), weights.to_layers(gradient))
        self.u, self.gradient = u, gradient

    def solve_gas(self, rate, source, following, mobility, flux):
        """Fluid velocity and pressure gradient of the cells at the end of the step; books what the gas does."""
        rho, dt, dz, kind = self.fluid.density, self.dt, self.dz, self.scheme.kind
        phi = self.solid_fraction()
        eps, none = 1 - phi, np.zeros_like(phi)
        pressed = eps if kind == "now" else eps + following
        response = 1 / (rho * eps / dt + rate)
        resting = response * (rho * eps * (self.u / dt - GRAVITY) + source)
        if kind != "mixture":
            following, mobility, flux = none, none, none
        surplus = self.scheme.owed * (self.gas / dz - eps) / dt
        through = (self.inlet or 0.0) + dz * np.concatenate(([0.0], np.cumsum(surplus)))
        share, flux = self.to_faces(eps + following), self.to_faces(flux, flux)
        resting_f = inner(resting) + self.kept(inner(eps * response) * rho / dt)
        answer = inner(response * pressed)
        slope = (share * resting_f + flux - through[1:-1]) / (share * answer + inner(mobility))
        ends = through[[0, -1]] / eps[[0, -1]] if self.inlet is not None else np.zeros(2)
        slopes = self.with_ends(slope, (resting[[0, -1]] - ends) / (response * pressed)[[0, -1]])
        gradient = 0.5 * (slopes[1:] + slopes[:-1])
        u = resting - response * pressed * gradient
        if self.scheme.forces == "faces":
            u = self.from_faces(response * (source - rho * eps * GRAVITY), response * pressed, slopes)
            u += response * rho * eps * self.u / dt
        self.face_u = np.concatenate((ends[:1], resting_f - answer * slope, ends[1:]))
        self.book_gas(np.concatenate((eps[:1], inner(eps), eps[-1:])) * self.face_u)
        drag = rate * u - source - (1 - pressed) * gradient
        self.given += dt * dz * drag.sum()
        return u, gradient

    def to_faces(self, values, flow=None):
        """At the inner faces; 'upwind' takes what comes along with `flow`, else with the last step's solids (down)."""
        if self.scheme.face == "linear":
            return inner(values)
        upward = inner(flow) > 0 if flow is not None else np.zeros(len(values) - 1, bool)
        return np.where(upward, values[:-1], values[1:])

    def kept(self, factor):
        """Of the last step's face flux, less what interpolation makes of it [m/s]; OpenFOAM's limiter."""
        if not self.scheme.memory:
            return 0.0
        beyond = self.face_u[1:-1] - inner(self.u)
        share = 1 - np.minimum(np.abs(beyond) / (np.abs(self.face_u[1:-1]) + 1e-300), 1)
        return factor * share * beyond

    def from_faces(self, push, answer, slopes):
        """Velocity that forces give the cells [m/s], as the mean of what they give the faces (OpenFOAM's reconstruct)."""
        at_faces = [np.concatenate((values[:1], inner(values), values[-1:])) for values in (push, answer)]
        given = at_faces[0] - at_faces[1] * slopes
        return 0.5 * (given[1:] + given[:-1])

    def with_ends(self, slope, stopping):
        """Pressure gradient at all faces [Pa/m]: `slope` at the inner ones, `stopping` what holds the fluid to the ends' flux."""
        low, high = stopping
        if self.scheme.wall == "hydrostatic":
            low = -GRAVITY * self.fluid.density
        elif self.scheme.wall == "extrapolated":
            low = slope[0]
        if self.inlet is None:  # a wall, else an outlet, where the pressure is given
            high = {"hydrostatic": -GRAVITY * self.fluid.density, "extrapolated": slope[-1]}.get(self.scheme.wall, high)
        return np.concatenate(([low], slope, [high]))

    def book_gas(self, flow):
        """Volume by what flows through the faces [m/s]."""
        self.gas = self.gas - self.dt * np.diff(flow)
        self.entered += self.dt * (flow[0] - flow[-1])

    def move_layers(self, demand, u, gradient):
        """The substeps, and what the layers took from the fluid, and how far contacts changed it."""
        m, h = demand.m, self.dt / self.scheme.substeps
        start, force = self.v, -self.a * gradient
        share = relaxed_share(demand.k * h / m)
        assumed = demand.impulse(self, u, gradient)
        taken = np.zeros_like(start)
        for _ in range(self.scheme.substeps):
            free = self.v + share * h * ((demand.k * (u - self.v) + force) / m - GRAVITY)
            new = self.without_overlap(free, m / share, h)
            push = m / share * (new - free)
            taken += m * (new - self.v) + m * GRAVITY * h - push
            self.pushed += push.sum()
            self.v = new
            self.z = self.z + h * new
        expected = demand.s * self.dt * ((demand.k * (u - start) + force) / m - GRAVITY)
        self.changes = [m * (self.v - start - expected), m * expected, m * demand.s * self.dt * GRAVITY]
        self.pending = taken - assumed
        self.taken += taken.sum()
        self.exchanged += np.abs(taken).sum()

    def without_overlap(self, free, weights, h):
        """Velocities [m/s] next to `free` with which no layers overlap after h [s]: plastic contacts."""
        room = self.a / PACKED
        below = room * (np.arange(len(self.z)) + 0.5)
        gaps = self.z + h * free - below
        top = self.cells * self.dz - room * len(self.z)
        if gaps[0] >= 0 and gaps[-1] <= top and (np.diff(gaps) >= 0).all():
            return free
        return (rising(gaps, weights, 0, top) + below - self.z) / h


def inner(values):
    """At the faces between the cells, linear."""
    return 0.5 * (values[1:] + values[:-1])


def even_layers(phi, cells, dz, noise=0.0, mode="random", seed=1):
    """z [m] and the volume [m] of layers of solid fraction phi, off by the share `noise` cell by cell: 'random', 'two-cell'."""
    pattern = np.random.default_rng(seed).uniform(-1, 1, cells) if mode == "random" else (-1.0) ** np.arange(cells)
    local = phi * (1 + noise * (pattern - pattern.mean()))
    filled = np.concatenate(([0.0], np.cumsum(local * dz)))
    count = PER_CELL * cells
    a = filled[-1] / count
    return np.interp((np.arange(count) + 0.5) * a, filled, dz * np.arange(cells + 1)), a
