#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Up to which step each coupling scheme stays calm, by the replica of a column: run as a program, it prints tables of the largest
x = dt/tau, tau = m/k at the hindered velocity, over solid fractions and two fluids (half an hour)."""

import math
from dataclasses import dataclass, replace

import numpy as np
from interphase.column_replica import AIR, CELLS, GRAVITY, PACKED, PER_CELL, WATER, Column, Scheme, even_layers, hindered, relaxed_share


@dataclass
class Record:
    """What a run did. Velocities over the hindered one; `owed` over the cell's volume, its largest value in any step."""

    mean: float  # velocity of the middle third
    expected: float  # what drag and the solid fraction there say of it
    swing: float  # its standard deviation in time
    spread: float  # standard deviation of the layers' velocities about it, at the end
    fastest: float  # layer at the end
    owed: float
    alternation: float  # factor a step by which changes of v or of the pressure on the floor grow that flip sign; 0: none

    def calm(self, tolerance=0.02):
        """Whether it neither swings nor drifts from what is expected by more than `tolerance`."""
        return self.swing < 0.05 and self.alternation <= 1.1 and abs(self.mean - self.expected) < tolerance


BROKEN = Record(math.nan, math.nan, math.inf, math.inf, math.inf, math.inf, math.inf)


def alternation(series, scale):
    """Factor a step by which sign-flipping changes grow at the series' end; 0 where they do not flip or are below 3 % of `scale`."""
    change = np.diff(series)[-40:]
    flips = (change[1:] * change[:-1] < 0).mean()
    old, new = np.sqrt((change[:20] ** 2).mean()), np.sqrt((change[20:] ** 2).mean())
    return 0.0 if flips < 0.8 or new < 0.03 * scale else (new / max(old, 1e-300)) ** (1 / 20)


def watch(column, steps, speed, window=60):
    """Runs the column for `steps` steps and tells of the last `window`; `speed` is what velocities are compared with [m/s]."""
    third = slice(len(column.z) // 3, -len(column.z) // 3)
    means, floor, owed = [], [], 0.0
    with np.errstate(all="ignore"):
        for _ in range(steps):
            column.step()
            if not max(np.abs(column.v).max(), np.abs(column.u).max()) < 1e3 * speed:
                return BROKEN
            means.append(column.v[third].mean())
            floor.append(-column.gradient.sum() * column.dz)
            owed = max(owed, np.abs(column.owed()).max())
    seen, fluid = np.array(means[-window:]), column.fluid
    weight = column.a * len(column.z) * (fluid.particle_density - fluid.density) * GRAVITY
    grows = max(alternation(means, speed), alternation(floor, weight))
    spread, fastest = column.v[third].std(), np.abs(column.v).max()
    z = column.z[third]
    phi = min(column.a * (len(z) - 1) / (z[-1] - z[0]), PACKED)
    expected = 0.0 if column.inlet is not None else -float(hindered(phi, fluid)[0])
    return Record(seen.mean() / speed, expected / speed, seen.std() / speed, spread / speed, fastest / speed, owed, grows)


def settling(fluid, phi, x, scheme, noise=0.02, mode="random", window=60, reach=5.0, at_rest=True):
    """A suspension in a closed column, from rest or 1 % off its steady state.

    Cells are so high that fronts get `reach` cells far: not to the middle third.
    """
    speed, tau = map(float, hindered(phi, fluid))
    steps = 60 + window + math.ceil(10 / x)
    fronts = max(2.0, phi / (PACKED - phi), 5 * phi / (1 - phi) - 1)  # speed of shocks and waves, over the hindered velocity
    dz = speed * fronts * steps * x * tau / reach
    column = Column(fluid, scheme, x * tau, dz, *even_layers(phi, CELLS, dz, noise, mode))
    if not at_rest:
        column.v -= 1.01 * speed
        column.u += 1.01 * speed * phi / (1 - phi)
        column.gradient -= GRAVITY * phi * (fluid.particle_density - fluid.density)
    return watch(column, steps, speed, window), column


def fluidized(fluid, phi, x, scheme, courant=0.05, steps=300):
    """A bed in two thirds of a column at the flux that carries it; the hindered velocity crosses `courant` cells a step."""
    speed, tau = map(float, hindered(phi, fluid))
    dz = speed * x * tau / courant
    layers = even_layers(phi, 2 * CELLS // 3, dz, 0.02)
    column = Column(fluid, scheme, x * tau, dz, *layers, inlet=speed)
    return watch(column, steps, speed), column


def sediment(fluid, x, scheme, steps=200):
    """Touching layers at rest in the lower half of clear fluid, which has been knocked; tau is that of phi 0.6.

    Returns how far any of them got [cells], and the column.
    """
    tau = float(hindered(0.6, fluid)[1])
    count = PER_CELL * CELLS // 2
    dz = 3 * fluid.diameter
    a = 0.97 * PACKED * dz / PER_CELL  # the top is inside a cell
    start = (np.arange(count) + 0.5) * a / PACKED
    column = Column(fluid, scheme, x * tau, dz, start, a)
    column.u = column.u + float(hindered(0.6, fluid)[0])
    furthest = 0.0
    with np.errstate(all="ignore"):
        for _ in range(steps):
            column.step()
            furthest = max(furthest, np.abs(column.z - start).max() / dz)
    return furthest, column


def settled(fluid, phi, x, scheme, courant=0.2):
    """A suspension until all of it should lie on the floor: (height of the sediment over the expected, Record)."""
    speed, tau = map(float, hindered(phi, fluid))
    dz = speed * x * tau / courant
    column = Column(fluid, scheme, x * tau, dz, *even_layers(phi, CELLS, dz, 0.02))
    record = watch(column, int(2.5 * CELLS / courant), speed)
    return (column.z[-1] + 0.5 * column.a / PACKED) / (column.a * len(column.z) / PACKED), record


def recursion_limit(phi):
    """Largest x of 'now' for free particles by the linear recursion z^2 = -r w (2 z - 1): r w = 1/3, r = phi/eps [-]."""
    w = (1 - phi) / (3 * phi)
    return math.inf if w >= 1 else bisect(lambda x: 1 - float(relaxed_share(x)) < w)


def half_held_limit(phi):
    """Largest x of 'mixture' where free particles are taken for half held: 1 - e^-x = 2 eps^2.

    With the wrong share d = h w of what is assumed, y = (1 - h) w, r = phi/eps and without the fluid's inertia,
    (eps + y (r + phi)) z (z - 1) + (1 - e^-x) z/eps + (r + phi) d (z - 1) = 0 is the recursion of one mode; here z = -1.
    """
    return math.inf if 2 * (1 - phi) ** 2 >= 1 else -math.log(1 - 2 * (1 - phi) ** 2)


def bisect(holds, low=1e-3, high=1e6):
    """The x up to which `holds` does."""
    for _ in range(100):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low


def largest_calm(run, xs):
    """The largest of `xs` up to which run(x) stays calm (0: none), and the records; the mean counts up to x = 1."""
    last, records = 0.0, []
    for x in xs:
        records.append(run(x)[0])
        if not records[-1].calm(0.02 if x <= 1.0001 else 0.1):
            break
        last = x
    return last, records


AS_BUILT = Scheme(hold="coupler", wall="flux", forces="faces")
SCHEMES = {
    "now": Scheme("now"),
    "implicit": Scheme("implicit"),
    "mixture, half held in balance": Scheme(),
    "  prior 0": Scheme(prior=0.0),
    "  prior 1": Scheme(prior=1.0),
    "  hold of the coupler": Scheme(hold="coupler"),
    "  and gradient at walls": Scheme(hold="coupler", wall="flux"),
    "  and forces at faces: as built": AS_BUILT,
    "  that, wall extrapolated": replace(AS_BUILT, wall="extrapolated"),
    "  that, wall hydrostatic": replace(AS_BUILT, wall="hydrostatic"),
    "  that, prior 0.5": replace(AS_BUILT, hold="prior"),
    "  that, prior 0": replace(AS_BUILT, hold="prior", prior=0.0),
    "  that, owed 0.5": replace(AS_BUILT, owed=0.5),
    "  that, 'implicit'": replace(AS_BUILT, kind="implicit"),
}
FRACTIONS = (0.1, 0.2, 0.3, 0.4, 0.5, 0.57, 0.6)
SCAN = 10.0 ** np.arange(-2, 2.01, 0.25)


def table(title, run, schemes, fluids=(WATER, AIR)):
    """Prints the largest calm x per scheme and solid fraction; run(fluid, phi, x, scheme)."""
    print(f"\n{title}: largest calm x; largest owed volume of the calm runs, over the cell's")
    for fluid in fluids:
        print(f"{fluid.name:32s}" + "".join(f"   phi {phi:4.2f}      " for phi in FRACTIONS))
        for name, scheme in schemes.items():
            line = f"{name:32s}"
            for phi in FRACTIONS:
                last, records = largest_calm(lambda x, phi=phi: run(fluid, phi, x, scheme), SCAN)
                owed = max([r.owed for r in records if r.calm(0.1)], default=0)
                line += f"  {last:5.3g} ({owed:.0e})" + ("   " if records[-1].alternation <= 1.1 else " ~ ")
            print(line, flush=True)
    print("~: the run beyond it broke, or changes of v or of the floor's pressure flip their sign and grow")


def at_rest(schemes):
    """Prints what becomes of a sediment."""
    print("\nat x = 0.1, 1, 10, 100, sediment: how far a layer got [cells], largest |u| at the end [m/s] | settling of phi 0.3: height, speed")
    for fluid in (WATER, AIR):
        for name, scheme in schemes.items():
            line = f"{fluid.name[:6]} {name:32s}"
            for x in (0.1, 1, 10, 100):
                moved, column = sediment(fluid, x, scheme)
                line += f"  {moved:.0e} {np.abs(column.u).max():.0e}"
            for x in (0.1, 1, 10, 100):
                height, record = settled(fluid, 0.3, x, scheme)
                line += f" | {height:.3f} {record.fastest:.0e}"
            print(line, flush=True)


def main():
    print("linear recursions: now", *(f"{recursion_limit(phi):.3g}" for phi in FRACTIONS), end="; ")
    print("half held", *(f"{half_held_limit(phi):.3g}" for phi in FRACTIONS))
    some = {name: SCHEMES[name] for name in ("now", "implicit", "mixture, half held in balance", "  and gradient at walls", "  and forces at faces: as built")}
    at_rest(SCHEMES)
    table("suspension from rest, closed column", settling, SCHEMES)
    table("the same, two-cell noise", lambda *a: settling(*a, mode="two-cell"), some)
    table("fluidized", fluidized, some)


if __name__ == "__main__":
    main()
