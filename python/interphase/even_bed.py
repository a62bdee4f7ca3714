# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres without order that fill a box evenly, from dilute to a solid fraction of 0.6; without overlap, or as parcels that may.

Centres of a scrambled Halton sequence are pushed apart until all keep a distance that would make them a packing of `SPREAD` (their
diameter where they are denser): so there are neither clusters nor lattice planes. The box repeats in space, so that they are as
dense along its faces as inside: between walls, layers form.
"""

import numpy
from scipy.spatial import cKDTree
from scipy.stats import qmc

from interphase.input_error import InputError

SPREAD = 0.50  # packing that the spheres would make if the distance they keep were their diameter
OVERSHOOT = 1.2  # share of a pair's overlap that a pass takes away
PASSES, SPREADING = 4000, 300  # at most; those that are spent on more distance than a diameter
A_FEW = 20  # after which the numbers in gas cells are as even as after 300: what is left moves neighbours
TOLERANCE = 1e-4  # of the diameter: overlap that is none


def even_bed(count, diameter, low, high, seed=1, may_overlap=False):
    """Centres [count, 3] between `low` and `high` [m, 3]; a sphere at one face keeps its distance from those at the other.

    Where they `may_overlap`, as parcels of MP-PIC, which do not collide, they are only spread: in a second for ten thousand.
    """
    low, high = numpy.asarray(low, float), numpy.asarray(high, float)
    size = high - low
    packing = count * numpy.pi / 6 * diameter**3 / numpy.prod(size)
    kept = diameter * max(1.0 + 2 * TOLERANCE, (SPREAD / packing) ** (1 / 3))
    if (size < 2 * diameter).any():
        raise InputError(f"{' x '.join(f'{x:g}' for x in size)} m is less than two diameters of {diameter:g} m in a direction")
    kept = min(kept, 0.99 * size.min() / 2)
    place = qmc.Halton(3, scramble=True, seed=seed).random(count) * size  # any part holds its share already
    closest = 0.0
    for done in range(A_FEW if may_overlap else PASSES):
        place %= size
        place[place >= size] = 0.0  # -1e-20 % L is L
        pairs = cKDTree(place, boxsize=size).query_pairs(kept, output_type="ndarray")
        apart = place[pairs[:, 0]] - place[pairs[:, 1]]
        apart -= size * numpy.rint(apart / size)
        distance = numpy.linalg.norm(apart, axis=1)
        closest = distance.min(initial=kept)
        if closest >= diameter and (done >= SPREADING or closest >= (1 - TOLERANCE) * kept):
            break
        push = (0.5 * OVERSHOOT * (kept - distance) / numpy.maximum(distance, 1e-12 * diameter))[:, None] * apart
        move = numpy.stack([
            numpy.bincount(pairs[:, 0], along, count) - numpy.bincount(pairs[:, 1], along, count) for along in push.T
        ], axis=1)
        neighbours = numpy.bincount(pairs.ravel(), minlength=count)
        place += move / numpy.sqrt(numpy.maximum(neighbours, 1))[:, None]
    place %= size
    if closest < (1 - TOLERANCE) * diameter and not may_overlap:
        raise InputError(
            f"{count} spheres of {diameter:g} m found no places of their own at a packing of {packing:.3g}: "
            f"{1 - closest / diameter:.2g} of a diameter is the largest overlap left; take fewer or a larger box"
        )
    return low + place[numpy.argsort(place[:, 2], kind="stable")]
