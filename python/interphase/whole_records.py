# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a run's records is whole. The rest, which a full disk, a copy that was cut or an older version may have left, is
left out with a word."""

import sys

import h5py

from interphase.input_error import InputError

UNREADABLE = (KeyError, OSError, RuntimeError, TypeError, ValueError)  # what h5py raises where a file is torn

_told = set()


def whole_snapshots(file):
    """(time [s], name, group) of the snapshots of an open particles.h5 that can be read, in order of time.

    The last one may also lack parts. InputError where another one has no time.
    """
    try:
        groups = file["snapshots"] if "snapshots" in file else {}
        names = sorted(groups)
    except UNREADABLE as error:
        tell(f"{file.filename}: the list of snapshots is torn ({error}): none can be read")
        return []
    found = []
    for name in names:
        try:
            group = groups[name]
            lengths = {_read_end(group[data]) for data in group}
            if name == names[-1]:
                if len(lengths) != 1:
                    raise ValueError("data sets of different lengths" if lengths else "no data sets")
                float(group.attrs["time"])
        except UNREADABLE as error:
            tell(f"{file.filename}: snapshot {name} is torn ({error}) and left out")
            continue
        try:
            found.append((float(group.attrs["time"]), name, group))
        except UNREADABLE:
            raise InputError(f"{file.filename}:/snapshots/{name}: no attribute `time` that is a number of seconds") from None
    return sorted(found, key=lambda each: each[:2])


def _read_end(data):
    """The rows of a data set whose last one is there."""
    data[-1:]
    return len(data)


def whole_rows(group):
    """The number of rows that all columns of a table have (an open group of results.h5, such as /series)."""
    lengths = [len(column) for column in group.values() if isinstance(column, h5py.Dataset) and column.ndim > 0]
    rows = min(lengths, default=0)
    if rows < max(lengths, default=0):
        tell(f"{group.file.filename}: {group.name} has {rows} whole rows; of its last {max(lengths) - rows} columns are missing: "
             "they are left out")
    return rows


def tell(words):
    """On standard error, once."""
    if words not in _told:
        _told.add(words)
        print(f"warning: {words}", file=sys.stderr)
