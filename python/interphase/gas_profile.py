# SPDX-License-Identifier: GPL-3.0-or-later
"""Mean pressure of the gas over the height, of the fields that a run has written."""

import math
import os

import numpy

from interphase import gas_fields, gas_mesh, parts
from interphase.input_error import InputError
from interphase.time_statistics import error_by_scatter, mean_with_error

FIELD = "p_rgh"
LAYERS = 100  # at most


def pressure_profile(folder, start, end):
    """((height [n] m, mean pressure [n] Pa above that of the top layer, standard error [n]), "") of the run in `folder` from `start` to `end` [s], or (None, why
    there is none). The gas's own weight is left out. A layer's pressure is the mean of its cells', each counted alike."""
    slack = 1e-9 * max(abs(end), 1)
    times = sorted(time for time in parts.times(folder).values() if start - slack <= time <= end + slack and time > 0)
    if not times:
        there = "in the pieces of its ranks" if os.path.isdir(os.path.join(folder, "processor0")) else "not written"
        return None, f"no pressure profile: the gas's fields from {start:.4g} to {end:.4g} s are {there}"
    try:
        mesh = gas_mesh.read(folder)
        height = _heights(mesh)
        edges = _layers(height)
        layer = numpy.clip(numpy.searchsorted(edges, height, side="right") - 1, 0, len(edges) - 2)
        count = numpy.bincount(layer, minlength=len(edges) - 1)
        rows = []
        for time in times:
            values = gas_fields.read(folder, FIELD, time).values
            values = numpy.broadcast_to(values, height.shape)
            mean = numpy.bincount(layer, values, minlength=len(count)) / numpy.maximum(count, 1)
            rows.append(mean - mean[numpy.flatnonzero(count)[-1]])
    except InputError as error:
        return None, f"no pressure profile: {error}"
    filled = count > 0
    rows = numpy.array(rows)[:, filled]
    errors = [mean_with_error(column).error if len(column) > 1 else math.nan for column in rows.T]
    middles = ((edges[1:] + edges[:-1]) / 2)[filled]
    return (middles, rows.mean(axis=0), numpy.array(errors)), ""


def of_replicates(profiles):
    """The mean of profiles (`pressure_profile`) of runs that differ in where they begin, its error by their scatter where there are several; None where one is None or has other
    heights."""
    first = profiles[0]
    if len(profiles) == 1:
        return first
    if any(each is None or len(each[0]) != len(first[0]) or not numpy.allclose(each[0], first[0]) for each in profiles):
        return None
    pressures = numpy.array([pressure for _, pressure, _ in profiles])
    return first[0], pressures.mean(axis=0), error_by_scatter(pressures)


def _heights(mesh):
    """z of the cells' middles [cells], m: the mean over their faces of the mean of their corners."""
    size = numpy.diff(mesh.first)
    face = numpy.add.reduceat(mesh.points[mesh.corners, 2], mesh.first[:-1]) / size
    inner = len(mesh.neighbour)
    total = numpy.bincount(mesh.owner, face, minlength=mesh.cells) + numpy.bincount(mesh.neighbour, face[:inner], minlength=mesh.cells)
    number = numpy.bincount(mesh.owner, minlength=mesh.cells) + numpy.bincount(mesh.neighbour, minlength=mesh.cells)
    return total / number


def _layers(height):
    """Edges of layers of even height: those of the mesh where it has them."""
    levels = numpy.unique(numpy.round(height, 9))
    if len(levels) <= LAYERS:
        return numpy.concatenate([[levels[0] - 1e-9], (levels[1:] + levels[:-1]) / 2, [levels[-1] + 1e-9]])
    return numpy.linspace(height.min() - 1e-9, height.max() + 1e-9, LAYERS + 1)
