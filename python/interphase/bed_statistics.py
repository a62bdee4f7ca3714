# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity, granular temperature, overlaps and voidage of one snapshot of spheres. SI units; x across, z up."""

import functools

import numpy
from scipy.spatial import cKDTree

SPLIT = 64  # points that stand for a sphere's volume
# Bins of overlaps over the diameter; overlaps below the first count in the first, above the last in the last.
OVERLAP_EDGES = numpy.logspace(-7, 0.5, 751)


def window_edges(windows):
    """x of the edges of the `Windows` [count + 1], m."""
    return numpy.linspace(windows.left, windows.right, windows.count + 1)


def window_of(position, windows, front_only):
    """Index of the window that holds each centre [n], -1: none. A centre on an edge belongs to the right one."""
    index = numpy.searchsorted(window_edges(windows), position[:, 0], side="right") - 1
    index[index == windows.count] = -1
    low = windows.centre - windows.height / 2
    inside = (position[:, 2] >= low) & (position[:, 2] < low + windows.height)
    if front_only:
        inside &= (position[:, 1] >= windows.front) & (position[:, 1] <= windows.front + windows.front_depth)
    return numpy.where(inside, index, -1)


def window_moments(position, velocity, weight, windows, front_only):
    """Per window: number of centres [w], of real particles [w], their sums of horizontal and vertical velocity [w, 2] and
    granular temperatures [w, 2].

    `weight`: real particles in each sphere [n]. Theta_x = 1/N sum (v_x - mean)^2 over the N real particles, and the same
    for z (eqs. 21, 22), NaN where fewer than two spheres are: one has no deviation.
    """
    index = window_of(position, windows, front_only)
    chosen = index >= 0
    index, components, weight = index[chosen], velocity[chosen][:, (0, 2)], weight[chosen]
    number = numpy.bincount(index, minlength=windows.count)
    real = numpy.bincount(index, weight, minlength=windows.count)
    sums = numpy.empty((windows.count, 2))
    temperatures = numpy.full((windows.count, 2), numpy.nan)
    for axis in range(2):
        sums[:, axis] = numpy.bincount(index, weight * components[:, axis], minlength=windows.count)
        mean = sums[:, axis] / numpy.maximum(real, 1)  # a sphere stands for one at least
        squares = numpy.bincount(index, weight * (components[:, axis] - mean[index]) ** 2, minlength=windows.count)
        enough = number >= 2
        temperatures[enough, axis] = squares[enough] / real[enough]
    return number, real, sums, temperatures


def overlaps(position, diameter, box=None):
    """Overlap of each pair that overlaps, over the smaller diameter of the two [pairs]; across the sides of `box` that repeat, too (particle_states.Box; None: none),
    by the nearest image."""
    if len(diameter) < 2:
        return numpy.zeros(0)
    size = numpy.zeros(3) if box is None else numpy.where(box.periodic, box.edges, 0.0)  # 0: the direction does not repeat
    repeats = size > 0
    place = numpy.array(position, dtype=float)
    if repeats.any():
        place[:, repeats] = (place[:, repeats] - numpy.array(box.low)[repeats]) % size[repeats]
        place[:, repeats] %= size[repeats]  # -1e-20 % L is L
    # A tree finds pairs within one distance; with sizes far apart it finds many that do not touch.
    pairs = cKDTree(place, boxsize=size if repeats.any() else None).query_pairs(float(diameter.max()), output_type="ndarray")
    i, j = pairs[:, 0], pairs[:, 1]
    apart = place[i] - place[j]
    apart[:, repeats] -= size[repeats] * numpy.round(apart[:, repeats] / size[repeats])
    overlap = (diameter[i] + diameter[j]) / 2 - numpy.sqrt((apart**2).sum(axis=1))
    touching = overlap > 0
    return overlap[touching] / numpy.minimum(diameter[i], diameter[j])[touching]


def overlap_counts(values):
    """Number of overlaps in each bin of OVERLAP_EDGES."""
    inside = numpy.clip(values, OVERLAP_EDGES[0], OVERLAP_EDGES[-1])
    return numpy.histogram(inside, OVERLAP_EDGES)[0]


@functools.lru_cache(maxsize=None)
def ball_points(count):
    """Points [count, 3] of equal weight that stand for a ball of radius 1.

    A golden spiral over shells of equal volume, each point with its antipode: the centre of mass is exact; the second
    moments are made so (1/5 along each axis).
    """
    half = count // 2
    n = numpy.arange(half) + 0.5
    radius = (n[::-1] * 0.6180339887498949 % 1) ** (1 / 3)
    height = n / half
    angle = 2 * numpy.pi * n * 0.7548776662466927
    across = numpy.sqrt(1 - height**2)
    points = radius[:, None] * numpy.column_stack([across * numpy.cos(angle), across * numpy.sin(angle), height])
    points = numpy.concatenate([points, -points])
    values, axes = numpy.linalg.eigh(points.T @ points / count)
    return points @ (axes / numpy.sqrt(5 * values)) @ axes.T


def solid_fraction(position, diameter, mesh, points=SPLIT):
    """(solid fraction of each cell [nx, ny, nz], spheres left out) on a `BoxMesh`.

    A sphere's volume goes to the cells in which it lies: whole where it crosses no face of a cell, else by `points` of
    equal weight in it. Points beyond the mesh's end, of a sphere that presses into a wall, count in the cell at the
    wall, so that solid volume is conserved. Spheres with their centre outside the mesh are left out and counted.
    """
    low, size = numpy.array(mesh.low), (numpy.array(mesh.high) - mesh.low) / mesh.cells
    last = numpy.array(mesh.cells) - 1
    place = (position - low) / size
    inside = ((place >= 0) & (place <= last + 1)).all(axis=1)
    place, diameter = place[inside], diameter[inside]
    reach = diameter[:, None] / 2 / size
    volume = numpy.pi / 6 * diameter**3
    stride = numpy.array([mesh.cells[1] * mesh.cells[2], mesh.cells[2], 1])
    count = int(numpy.prod(mesh.cells))

    first = numpy.clip(numpy.floor(place - reach).astype(numpy.int64), 0, last)
    whole = (first == numpy.clip(numpy.floor(place + reach).astype(numpy.int64), 0, last)).all(axis=1)
    solid = numpy.zeros(count)
    solid += numpy.bincount(first[whole] @ stride, volume[whole], minlength=count)
    split = ~whole
    place, reach, share = place[split], reach[split], volume[split] / points
    for point in ball_points(points):
        cell = numpy.clip(numpy.floor(place + reach * point).astype(numpy.int64), 0, last)
        solid += numpy.bincount(cell @ stride, share, minlength=count)
    return (solid / mesh.cell_volume).reshape(mesh.cells), int((~inside).sum())
