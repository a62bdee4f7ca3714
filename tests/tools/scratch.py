# SPDX-License-Identifier: GPL-3.0-or-later
"""A folder of each test's own, and files and records of runs that are made up in it."""

import os
import stat
import tempfile
import unittest

import h5py


def write(path, text, executable=False):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)
    if executable:
        os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)


def read(*parts):
    with open(os.path.join(*parts), encoding="utf-8") as stream:
        return stream.read()


def write_snapshots(folder, snapshots):
    """particles.h5 of `snapshots` [(time [s], {data set: values}), ...], in order."""
    os.makedirs(folder, exist_ok=True)
    with h5py.File(os.path.join(folder, "particles.h5"), "w") as file:
        file.create_group("snapshots")
        for number, (time, data) in enumerate(snapshots):
            group = file.create_group(f"snapshots/{number:06d}")
            group.attrs["time"] = time
            for name, values in data.items():
                group[name] = values


def write_results(folder, series=None, **meta):
    """results.h5 with a /series {name: values} where there is one, and attributes of /meta."""
    os.makedirs(folder, exist_ok=True)
    with h5py.File(os.path.join(folder, "results.h5"), "w") as file:
        file.create_group("meta").attrs.update(meta)
        for name, values in (series or {}).items():
            file[f"series/{name}"] = values


class InFolder(unittest.TestCase):
    """`root`: the folder, gone when the test ends."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="interphase-")
        self.addCleanup(folder.cleanup)
        self.root = folder.name
