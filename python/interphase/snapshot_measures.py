# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of one snapshot of particles, whose time series two runs are compared by: means and quantiles of all particles,
profiles along the height, voidage, overlaps. SI units, z upwards."""

from dataclasses import dataclass

import numpy

from interphase import bed_statistics
from interphase.box_mesh import BoxMesh

QUANTILES = (0.05, 0.25, 0.5, 0.75, 0.95)
SOLID_QUANTILES = (0.1, 0.5, 0.9)
LAYERS = 5
CELL_IN_DIAMETERS = 4.0  # a cell of voidage holds some 40 close packed spheres: below that, it tells single spheres
MOST_CELLS = 10**6
# A tree finds pairs within one distance: beyond this ratio of sizes it finds a hundred that do not touch for one that does.
WIDEST_SIZES = 5.0


@dataclass(frozen=True)
class Place:
    """Where to measure, the same for both sides: layers between `heights` [LAYERS + 1, m] and the mesh of voidages
    (None: no diameters, or too many cells). `overlaps`: whether sizes allow to look for them."""

    heights: numpy.ndarray
    mesh: BoxMesh
    overlaps: bool


def place_of(sources, matching, start, end):
    """(`Place`, notes) from the box about all particles that the sources show within `start` to `end`; Place None: no positions.

    The mesh's cells are four mean diameters wide, of the side that has larger ones.
    """
    low, high, mean = numpy.full(3, numpy.inf), numpy.full(3, -numpy.inf), 0.0
    smallest, largest, sized = numpy.inf, 0.0, True
    for source in sources:
        for frame in source.frames():
            if not matching.within(frame, start, end):
                continue
            quantities = frame.load().quantities
            position = quantities.get("position")
            if position is None:
                return None, []
            if not len(position) or not numpy.isfinite(position).all():
                continue
            low, high = numpy.minimum(low, position.min(axis=0)), numpy.maximum(high, position.max(axis=0))
            diameter = quantities.get("diameter")
            if diameter is None or not (diameter > 0).all():
                sized = False
                continue
            smallest, largest = min(smallest, diameter.min()), max(largest, diameter.max())
            mean = max(mean, float(numpy.cbrt(numpy.mean(diameter**3))))
    if not (high > low).any():
        return None, []
    notes, mesh = [], None
    margin = largest / 2 if sized else 0.0
    low, high = low - margin, high + margin
    if sized:
        cells = numpy.maximum(1, numpy.round((high - low) / (CELL_IN_DIAMETERS * mean))).astype(int)
        if cells.prod(dtype=float) <= MOST_CELLS:
            mesh = BoxMesh(tuple(low), tuple(high), tuple(int(n) for n in cells))
        else:
            notes.append(f"voidage is not compared: the particles are spread over {cells.prod(dtype=float):.3g} cells of four diameters")
    overlaps = sized and largest <= WIDEST_SIZES * smallest
    if sized and not overlaps:
        notes.append(f"overlaps are not compared: diameters of {smallest:.3g} to {largest:.3g} m")
    if not sized:
        notes.append("voidage and overlaps are not compared: a side shows no diameters")
    return Place(numpy.linspace(low[2], high[2], LAYERS + 1), mesh, overlaps), notes


def snapshot_measures(state, weigh, place=None):
    """Scalars of one snapshot, by name.

    With `weigh`, averages over particles are weighted by volume, taken from the diameter, so that they are means
    over the solid; quantiles of velocity are over the tracked particles. Layers count what has its centre in them.
    """
    quantities = state.quantities
    if not len(state.ids):
        return {}
    weights = quantities["diameter"] ** 3 if weigh else None

    def average(values):
        return float(numpy.average(values, weights=weights))

    measures = {"particles/number": float(len(state.ids))}
    position, velocity = quantities.get("position"), quantities.get("velocity")
    if position is not None:
        measures["particles/mean_height [m]"] = average(position[:, 2])
    if velocity is not None:
        measures["particles/kinetic_energy_per_mass [J/kg]"] = average(0.5 * numpy.sum(velocity**2, axis=1))
        measures["particles/mean_vertical_velocity [m/s]"] = average(velocity[:, 2])
        if numpy.isfinite(velocity[:, 2]).all():
            for level, value in zip(QUANTILES, numpy.quantile(velocity[:, 2], QUANTILES)):
                measures[f"particles/vertical_velocity_quantile_{100 * level:g}% [m/s]"] = float(value)
    if "spin" in quantities:
        measures["particles/mean_square_spin [rad2/s2]"] = average(numpy.sum(quantities["spin"] ** 2, axis=1))
    if place is not None and position is not None and numpy.isfinite(position).all():
        measures.update(_profiles(position, velocity, weights, place.heights))
        if place.mesh is not None:
            measures.update(_voidages(position, quantities["diameter"], place.mesh))
        if place.overlaps:
            measures.update(_overlaps(position, quantities["diameter"]))
    return measures


def _profiles(position, velocity, weights, heights):
    """Of each layer: the share of all solids in it, and what it adds to their mean speed up and down.

    The upward part, sum of w max(v_z, 0) over all weights, is defined in an empty layer, too, where a mean velocity is not.
    """
    layer = numpy.clip(numpy.searchsorted(heights, position[:, 2], side="right") - 1, 0, LAYERS - 1)
    weights = numpy.ones(len(position)) if weights is None else weights
    share = weights / weights.sum()
    found = {}
    rows = [("share_of_solids", "1", share)]
    if velocity is not None:
        rows += [("moving_up", "m/s", share * numpy.maximum(velocity[:, 2], 0)),
                 ("moving_down", "m/s", share * numpy.maximum(-velocity[:, 2], 0))]
    for what, unit, values in rows:
        for at, value in enumerate(numpy.bincount(layer, values, minlength=LAYERS)):
            found[f"profile/{what}_z={heights[at]:.3g}..{heights[at + 1]:.3g} [{unit}]"] = float(value)
    return found


def _voidages(position, diameter, mesh):
    """Mean voidage that the solids have about them, and its quantiles over the solids' volume."""
    solid = bed_statistics.solid_fraction(position, diameter, mesh)[0].ravel()
    solid = numpy.sort(solid[solid > 0])[::-1]  # voidage ascends
    volume = solid.cumsum()
    found = {"voidage/mean_over_solids [1]": float(1 - (solid @ solid) / volume[-1])}
    for level in SOLID_QUANTILES:
        at = min(int(numpy.searchsorted(volume, level * volume[-1])), len(solid) - 1)
        found[f"voidage/quantile_{100 * level:g}%_of_solids [1]"] = float(1 - solid[at])
    return found


def _overlaps(position, diameter):
    """Overlapping pairs for each sphere; mean and 95 % quantile of their overlap over the diameter, 0 without pairs."""
    values = bed_statistics.overlaps(position, diameter)
    return {
        "overlap/pairs_per_sphere [1]": len(values) / len(diameter),
        "overlap/mean [d]": float(values.mean()) if len(values) else 0.0,
        "overlap/quantile_95% [d]": float(numpy.quantile(values, 0.95)) if len(values) else 0.0,
    }
