# SPDX-License-Identifier: GPL-3.0-or-later
"""The vessel that runs share, and the spheres in it, as their records tell: what windows and meshes are made of by default."""

from dataclasses import dataclass
from typing import Optional

import numpy

from interphase.input_error import InputError

SAMPLES = 10  # snapshots of a run that tell its spheres' sizes and mean height


@dataclass(frozen=True)
class Vessel:
    """Corners `low` and `high` [m] of a box about the vessel, and `whence` it is known.

    Of the spheres: `smallest` and `largest` diameter, that of the `mean` volume, and the mean height of their volume `middle` [m];
    None where no snapshot has any.
    """

    low: tuple
    high: tuple
    whence: str
    smallest: Optional[float] = None
    largest: Optional[float] = None
    mean: Optional[float] = None
    middle: Optional[float] = None

    def is_box(self, low, high):
        """Whether the box between two corners [m] is this one, within a millionth of its size."""
        size = numpy.subtract(self.high, self.low).max()
        return bool(numpy.allclose([low, high], [self.low, self.high], rtol=0, atol=1e-6 * size))


def domain_of(run):
    """(low, high) corners [m] of the box about the gas mesh of `Records`, from /meta; None where it is not recorded (no gas)."""
    found = run.meta.get("domain")
    if found is None:
        return None
    box = numpy.asarray(found, dtype=float)
    if box.shape != (2, 3) or not numpy.isfinite(box).all() or not (box[1] > box[0]).all():
        raise InputError(f"{run.results}: /meta attribute domain = {box.tolist()}: two corners (x y z), low and high, are expected")
    return box


def box_of(run, mesh):
    """(corners [2, 3] in m, whence they are known) of the vessel of `Records`: its domain, else its `BoxMesh` where that is not None; None
    where neither tells."""
    domain = domain_of(run)
    if domain is not None:
        return domain, "the gas mesh's domain"
    return None if mesh is None else (numpy.array([mesh.low, mesh.high]), "the box of blockMeshDict")


def vessel_of(runs, boxes, chosen):
    """(`Vessel`, notes) that holds all `runs`; Vessel None: neither mesh nor spheres tell of one.

    `boxes`: per run (corners [2, 3] of its mesh, whence they are known), or None: then the box about its spheres is taken.
    `chosen(time)`: whether a snapshot counts.
    """
    spheres = _Spheres()
    about, notes, whence = [], [], []
    for run, box in zip(runs, boxes):
        times = [frame.time for frame in run.frames() if chosen(frame.time)]
        step = 1 if box is None else -(-len(times) // SAMPLES)
        wanted = set(times[::step] if times else ())
        own = _Spheres()
        for frame in run.frames(only=("position", "diameter")):
            if frame.time in wanted:
                state = frame.load().quantities
                own.add(state.get("position"), state.get("diameter"))
        spheres.join(own)
        if box is not None:
            about.append(box[0])
            whence.append(box[1])
        elif own.count:
            about.append(numpy.array([own.low, own.high]))
            whence.append("the box about all spheres")
    if not about:
        return None, notes
    box = numpy.array([numpy.min([b[0] for b in about], axis=0), numpy.max([b[1] for b in about], axis=0)])
    whence = " and ".join(dict.fromkeys(whence))
    known = [box[0] for box in boxes if box is not None]
    if any(not numpy.allclose(b, known[0], rtol=0, atol=1e-6 * numpy.ptp(known[0], axis=0).max()) for b in known[1:]):
        sizes = "; ".join(" x ".join(f"{edge:.4g}" for edge in b[1] - b[0]) + " m" for b in known)
        notes.append(f"the runs' vessels differ ({sizes}): what is not given is of the box about all of them")
    if not spheres.count:
        return Vessel(tuple(box[0]), tuple(box[1]), whence), notes
    return Vessel(tuple(box[0]), tuple(box[1]), whence, spheres.smallest, spheres.largest,
                  float(numpy.cbrt(spheres.volume / spheres.count)), float(spheres.moment / spheres.volume)), notes


class _Spheres:
    """Sums over spheres: number, volume (diameter^3) and its moment about z = 0; extremes of place and diameter."""

    def __init__(self):
        self.count, self.volume, self.moment = 0, 0.0, 0.0
        self.low, self.high = numpy.full(3, numpy.inf), numpy.full(3, -numpy.inf)
        self.smallest, self.largest = numpy.inf, 0.0

    def add(self, position, diameter):
        if position is None or diameter is None:
            return  # measuring tells which is missing
        good = numpy.isfinite(position).all(axis=1) & (diameter > 0) & numpy.isfinite(diameter)
        position, diameter = position[good], diameter[good]
        if not len(diameter):
            return
        self.count += len(diameter)
        self.volume += float((diameter**3).sum())
        self.moment += float((diameter**3 * position[:, 2]).sum())
        self.low = numpy.minimum(self.low, (position - diameter[:, None] / 2).min(axis=0))
        self.high = numpy.maximum(self.high, (position + diameter[:, None] / 2).max(axis=0))
        self.smallest, self.largest = min(self.smallest, float(diameter.min())), max(self.largest, float(diameter.max()))

    def join(self, other):
        self.count += other.count
        self.volume += other.volume
        self.moment += other.moment
        self.low, self.high = numpy.minimum(self.low, other.low), numpy.maximum(self.high, other.high)
        self.smallest, self.largest = min(self.smallest, other.smallest), max(self.largest, other.largest)
