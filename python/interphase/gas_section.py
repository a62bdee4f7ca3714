# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of the gas in the cells that an upright plane cuts, of a run that is whole or in the pieces of its ranks."""

import os
from dataclasses import dataclass

import numpy

from interphase import foam_field, gas_mesh, parts
from interphase.input_error import InputError


@dataclass(frozen=True)
class Section:
    """`polygons`: corners [k, 2] (x, z), m, of each cell; `values` [n] or [n, 3] there; `middles` [n, 2] of the cells' polygons, at `time` [s]."""

    time: float
    polygons: list
    middles: numpy.ndarray
    values: numpy.ndarray


class GasSections:
    """What the plane at `y` [m] cuts of the gas of the run in `folder`; meshes are read once."""

    def __init__(self, folder, y):
        self.folder, self.y = folder, y
        self._cells, self._times = {}, {}

    def times(self, field):
        """{time [s]: folders that together hold `field` at it}, ascending; looked for once."""
        if field not in self._times:
            self._times[field] = self._find(field)
        return self._times[field]

    def _find(self, field):
        found = {}
        whole = gas_mesh.pieces(self.folder) == [self.folder]
        ranks = parts.ranks(self.folder)
        for name, time in parts.times(ranks[0]).items() if ranks else ():
            if all(foam_field.path_of(os.path.join(rank, name), field) for rank in ranks):
                found[time] = [os.path.join(rank, name) for rank in ranks]
        for name, time in parts.times(self.folder).items():
            if whole and foam_field.path_of(os.path.join(self.folder, name), field):
                found[time] = [os.path.join(self.folder, name)]
        for time in {min(found, default=None), max(found, default=None)} - {None}:
            # The start is what the case asks for, maybe in the words of its `parameters`; the last one may still be being written.
            if not all(_has_values(foam_field.path_of(folder, field)) for folder in found[time]):
                del found[time]
        return dict(sorted(found.items()))

    def nearest(self, field, time):
        """The `Section` of `field` at the time that is nearest to `time` [s]; InputError where it was never written."""
        there = self.times(field)
        if not there:
            if parts.collated(self.folder):
                raise InputError(f"{self.folder}: the gas is in the pieces of its ranks, collated: reconstructPar -case {self.folder} puts them together")
            raise InputError(f"{self.folder}: no {field} of the gas was written; writeInterval in system/controlDict asks for it, and a mesh must be "
                             "beside it")  # fmt: skip
        chosen = min(there, key=lambda each: abs(each - time))
        found = [self._part(folder, field) for folder in there[chosen]]
        polygons = [each for part in found for each in part[0]]
        middles = numpy.array([each.mean(axis=0) for each in polygons]).reshape(-1, 2)
        return Section(chosen, polygons, middles, numpy.concatenate([part[1] for part in found]))

    def _part(self, folder, field):
        base = os.path.dirname(folder)
        if base not in self._cells:
            mesh = gas_mesh.read(base)
            self._cells[base] = (*gas_mesh.polygons(mesh, gas_mesh.cut(mesh, self.y)), mesh.cells)
        cells, polygons, count = self._cells[base]
        path = foam_field.path_of(folder, field)
        found = foam_field.internal_field(path)
        if not found.uniform and len(found.values) != count:
            raise InputError(f"{path}: {len(found.values)} values, and the mesh in {base} has {count} cells: it is another mesh's")
        values = numpy.broadcast_to(found.values, (count, found.values.shape[1]))[cells]
        return polygons, values[:, 0] if values.shape[1] == 1 else values


def _has_values(path):
    try:
        foam_field.internal_field(path)
    except (InputError, ValueError):
        return False
    return True
