# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres of several sizes without order and without overlap that fill a box evenly, between walls.

As even_bed.py, with each pair's own distance: centres of a scrambled Halton sequence, the sizes dealt out at random, are pushed apart
until no two overlap and none reaches beyond a wall.
"""

import numpy
from scipy.spatial import cKDTree
from scipy.stats import qmc

from interphase.input_error import InputError


OVERSHOOT = 1.2  # share of a pair's overlap that a pass takes away
PASSES, SPREADING = 4000, 100  # at most; those that are spent on more distance than touching
LARGEST_SPREAD = 1.10  # distance that spheres keep where there is room, over that of touching
SPREAD = 0.55  # packing at which they keep no more than touching
MARGIN = 1.004  # distance that is pushed for when touching is enough: the last thousandths would take most passes
SAFETY = 1e-6  # of a distance, that round-off and the digits of a file do not make an overlap


def close_pairs(place, reach):
    """Pairs [n, 2] of spheres nearer than the sum of their `reach` [count], each once, size class by size class."""
    order = numpy.argsort(reach)
    edges = [0]
    while edges[-1] < len(order):  # a class ends where reach has doubled
        edges.append(int(numpy.searchsorted(reach[order], 2 * reach[order[edges[-1]]], side="right")))
    classes = [order[a:b] for a, b in zip(edges, edges[1:])]
    trees = [cKDTree(place[members]) for members in classes]
    found = []
    for k, members in enumerate(classes):
        found.append(members[trees[k].query_pairs(2 * reach[members].max(), output_type="ndarray")])
        for j in range(k):
            near = trees[j].sparse_distance_matrix(trees[k], reach[classes[j]].max() + reach[members].max(), output_type="coo_matrix")
            found.append(numpy.stack([classes[j][near.row], members[near.col]], axis=1))
    pairs = numpy.concatenate(found)
    distance = numpy.linalg.norm(place[pairs[:, 0]] - place[pairs[:, 1]], axis=1)
    near = distance < reach[pairs[:, 0]] + reach[pairs[:, 1]]
    return pairs[near], distance[near]


def mixed_bed(diameters, low, high, seed=1):
    """Centres [count, 3] of spheres of `diameters` [count] inside walls from `low` to `high` [m, 3], in the order of the diameters."""
    diameters, low, high = (numpy.asarray(values, float) for values in (diameters, low, high))
    size, count, radius = high - low, len(diameters), diameters / 2
    packing = numpy.sum(numpy.pi / 6 * diameters**3) / numpy.prod(size)
    if (size < diameters.max()).any():
        raise InputError(f"{' x '.join(f'{x:g}' for x in size)} m is less than the largest diameter of {diameters.max():g} m in a direction")
    draw = numpy.random.default_rng(seed)
    room = size - diameters[:, None]
    least, most = radius[:, None] + 0.5 * SAFETY * room, size - radius[:, None] - 0.5 * SAFETY * room
    place = numpy.empty((count, 3))
    place[draw.permutation(count)] = qmc.Halton(3, scramble=True, seed=seed).random(count) * size
    place = numpy.clip(place, least, most)
    spread = min(LARGEST_SPREAD, max(1.0, (SPREAD / packing) ** (1 / 3)))
    worst = 1.0
    for done in range(PASSES):
        kept = (1 + 2 * SAFETY) * (spread if done < SPREADING else MARGIN)
        pairs, distance = close_pairs(place, kept * radius)
        touching = radius[pairs[:, 0]] + radius[pairs[:, 1]]
        worst = float(numpy.min(distance / touching, initial=1 + 2 * SAFETY))
        if worst >= 1 + SAFETY and done >= (SPREADING if spread > 1 else 0):
            break
        apart = place[pairs[:, 0]] - place[pairs[:, 1]]
        push = OVERSHOOT * (kept * touching - distance) / numpy.maximum(distance, 1e-12 * touching)
        # the smaller one gives way, as it has the more room to go
        share = radius[pairs[:, 1]] / (radius[pairs[:, 0]] + radius[pairs[:, 1]])
        first, second = (push * share)[:, None] * apart, (push * (1 - share))[:, None] * apart
        move = numpy.stack([
            numpy.bincount(pairs[:, 0], first[:, k], count) - numpy.bincount(pairs[:, 1], second[:, k], count) for k in range(3)
        ], axis=1)
        neighbours = numpy.bincount(pairs.ravel(), minlength=count)
        place = numpy.clip(place + move / numpy.sqrt(numpy.maximum(neighbours, 1))[:, None], least, most)
    if worst < 1:
        raise InputError(
            f"{count} spheres of {diameters.min():g} to {diameters.max():g} m found no places of their own at a packing of {packing:.3g}: "
            f"{1 - worst:.2g} of a distance is the largest overlap left; take fewer or a larger box"
        )
    return low + place
