# SPDX-License-Identifier: GPL-3.0-or-later
"""The particles of a run at the times of its snapshots."""

import os
from collections.abc import Sequence

import numpy

from interphase import stored
from interphase.input_error import InputError
from interphase.run import no_such
from interphase.same_time import same_time
from interphase.stored import open_h5
from interphase.whole_records import whole_snapshots


class Snapshot:
    """The tracked particles at `time` [s], in ascending order of id. Nothing is read before it is asked for."""

    def __init__(self, path, group, time):
        self.time = time
        self._path, self._group = path, group

    def read(self, name):
        """The data set `name` as `Stored`: values [n] or [n, 3] and unit. InputError where it was not recorded."""
        with open_h5(self._path) as file:
            group = file["snapshots"][self._group]
            if name not in group:
                raise no_such(f"{self._path}:/snapshots/{self._group}", name, list(group))
            found = stored.stored(group[name])
            found.values = found.values[numpy.argsort(group["id"][()], kind="stable")]
        return found

    def arrays(self):
        """{name: values [n] or [n, 3]} of all data sets, in the units of `read`."""
        with open_h5(self._path) as file:
            group = file["snapshots"][self._group]
            order = numpy.argsort(group["id"][()], kind="stable")
            return {name: data[()][order] for name, data in group.items()}

    @property
    def names(self):
        """What was recorded of the particles."""
        with open_h5(self._path) as file:
            return sorted(file["snapshots"][self._group])

    @property
    def ids(self):
        """[n]"""
        return self.read("id").values

    @property
    def positions(self):
        """[n, 3] of the centres, m."""
        return self.read("position").values

    @property
    def velocities(self):
        """[n, 3], m/s."""
        return self.read("velocity").values

    @property
    def spins(self):
        """[n, 3], angular velocities, rad/s."""
        return self.read("angular_velocity").values

    @property
    def forces(self):
        """[n, 3], N."""
        return self.read("force").values

    @property
    def diameters(self):
        """[n] of the tracked spheres, m; a parcel's is that of its sphere, not of the real particles in it."""
        return self.read("diameter").values

    @property
    def types(self):
        """[n], LIGGGHTS's type of each."""
        return self.read("type").values

    @property
    def densities(self):
        """[n], kg/m3."""
        return self.read("density").values

    def __repr__(self):
        return f"<Snapshot at {self.time:.9g} s>"


class Snapshots(Sequence):
    """Snapshots in order of time; `at(time)` takes one by its time."""

    def __init__(self, path):
        self._found = []
        if os.path.isfile(path):
            with open_h5(path) as file:
                self._found = [Snapshot(path, name, time) for time, name, _ in whole_snapshots(file)]
        self._path = path

    def __len__(self):
        return len(self._found)

    def __iter__(self):
        return iter(self._found)  # Sequence's own would ask for the first where there is none

    def __getitem__(self, which):
        if not self._found and not isinstance(which, slice):
            raise InputError(f"{self._path}: no snapshots so far; snapshotInterval of records in couplingDict asks for them")
        return self._found[which]

    @property
    def times(self):
        """[n], s."""
        return numpy.array([each.time for each in self._found])

    def at(self, time):
        """The Snapshot at `time` [s]; InputError with the nearest where there is none."""
        nearest = min(self._found, key=lambda each: abs(each.time - time), default=None)
        if nearest is None or not same_time(nearest.time, time):
            raise InputError(f"{self._path}: no snapshot at {time:.9g} s" + (f"; the nearest is at {nearest.time:.9g} s" if nearest else ""))
        return nearest
