# SPDX-License-Identifier: GPL-3.0-or-later
"""A plan as lines of text: the scene's numbers, each method's steps, and what it will cost."""

import math

from interphase import tables
from interphase.durations import told
from interphase.fluidization import LOOSE_VOIDAGE

GB = 1e9


def scene_lines(scene):
    """What the particles and the gas of a `PlannedScene` are to each other."""
    d = scene.sauter
    sizes = f"{1e3 * d:.4g} mm" if scene.smallest == scene.largest else (f"{1e3 * scene.smallest:.4g} to {1e3 * scene.largest:.4g} mm, Sauter mean {1e3 * d:.4g} mm")
    rows = [("particles", f"{scene.real:,.0f} of {sizes}, {scene.density:.4g} kg/m3")]
    if scene.mean_cell:
        rows.append(("d/cell", f"{d / scene.mean_cell:.3g} of the mean cell, {d / scene.smallest_cell:.3g} of the smallest"))
    if scene.grain is None:
        return _pairs([*rows, ("gas", "none, or one whose density or viscosity vary: no numbers of fluidization")])
    grain = scene.grain
    rows.append(("Archimedes number", f"{grain.archimedes:.4g}"))
    terminal = grain.terminal_velocity(scene.drag) if scene.drag else None
    speeds = [("U", scene.velocity)] + [("the velocity of fall alone", terminal)] * (terminal is not None)
    for label, number in (("Reynolds number", grain.reynolds), ("Stokes number of impacts", grain.stokes)):
        said = [f"{number(speed):.3g} at {name} = {speed:.3g} m/s" for name, speed in speeds if speed is not None]
        rows.append((label, ", ".join(said) or "no velocity was written"))
    own = (f"{scene.law} at a voidage of {LOOSE_VOIDAGE:g}" if scene.drag else f"{scene.law} is not written down in python/interphase/drag_laws.py: Wen and Yu's")
    if scene.minimum_fluidization:
        rows.append(("U_mf", f"{scene.minimum_fluidization:.4g} m/s ({own}); {grain.minimum_fluidization_by_wen_yu:.4g} by Wen and Yu (1966)"))
        if scene.velocity is not None:
            rows.append(("U/U_mf", f"{scene.velocity / scene.minimum_fluidization:.3g}"))
    group = grain.geldart_group
    rows.append(("Geldart group", group or "none: they are of beds that gases fluidize"))
    if scene.relaxation_time:
        rows.append(("relaxation time m/k", f"{1e3 * scene.relaxation_time:.3g} ms in the bed; by Stokes (eq. 29) {1e3 * grain.viscous_relaxation_time:.3g} ms"))
    return _pairs(rows)


def _pairs(rows):
    return tables.columns(rows, indent=2)


def steps_rows(planned, scene):
    """Rows of (method, tracked, parcel/cell, parcel/depth, t_c, solid step, solid steps in a gas step)."""
    rows = [("method", "tracked", "parcel/cell", "parcel/depth", "t_c [ms]", "solid step [ms]", "in a gas step", "of")]
    for each in planned:
        meta = each.calibration.run.meta
        contact, step, gas = meta.get("contact_duration"), float(meta["solid_step"]), each.calibration.gas_step
        parcel = each.numbers
        rows.append((each.name, f"{float(meta['particles_at_start']):,.0f}", _number(parcel["parcel_over_cell"]), _number(parcel["parcel_over_depth"]),
                     f"{1e3 * contact:.4g}" if contact else "", f"{1e3 * step:.4g}" + (f" = t_c/{contact / step:.3g}" if contact else ""),
                     f"{gas / step:.4g}", f"{1e3 * gas:.4g} ms"))  # fmt: skip
    return rows


def limits_of_mp_pic(scene, gas_step):
    """The steps that eqs. 28 and 29 of the paper allow, in words; the fix has factors 1."""
    if scene.mean_cell is None or scene.velocity is None:
        return ""
    crossing = scene.smallest_cell / scene.velocity if scene.velocity > 0 else math.inf
    own = f", m/k {1e3 * scene.relaxation_time:.3g} ms" if scene.relaxation_time else ""
    return f"MP-PIC's limits (eq. 28): a cell crossed at U {1e3 * crossing:.3g} ms, gas step {1e3 * gas_step:.3g} ms{own}"


def _number(value):
    return "" if value is None else f"{value:.3g}"


def cost_rows(planned, until, ranks):
    """Rows of CPU seconds by phase, the whole with its error, seconds by the clock, memory and disk."""
    rows = [("method", "solids", "gas", "mapping, exchange", "output", "CPU s", "", "by the clock", "memory", "disk", "measured on")]
    for each in planned:
        cost, run = each.calibration.cost(until), each.calibration.run
        part = cost.seconds
        rows.append((each.name, *(f"{value:.3g}" for value in (part["solids"], part["gas"], part["mapping"] + part["exchange"] + part["waiting"], part["output"])),
                     f"{cost.total:.3g}", f"+- {cost.error:.2g}", told(cost.wall(ranks)), f"{float(run.meta['peak_memory']) / GB:.2g} GB",
                     f"{each.calibration.bytes(until) / GB:.2g} GB", each.calibration.whence))  # fmt: skip
    return rows


def check_rows(checked):
    """Rows of what was foretold and what was then measured; `checked`: (name, foretold Cost, measured Cost)."""
    rows = [("method", "phase", "foretold [CPU s]", "measured", "foretold/measured")]
    for name, foretold, measured in checked:
        for phase in ("solids", "gas", "mapping", "exchange"):
            if max(foretold.seconds[phase], measured.seconds[phase]) > 0.02 * measured.total:
                rows.append(_check(name, phase, foretold.seconds[phase], measured.seconds[phase]))
        rows.append(_check(name, "all", foretold.total, measured.total))
    return rows


def _check(name, phase, foretold, measured):
    return name, phase, f"{foretold:.3g}", f"{measured:.3g}", f"{foretold / measured:.3f}" if measured > 0 else ""
