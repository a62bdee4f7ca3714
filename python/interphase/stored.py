# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of an HDF5 file with their units."""

import os
from dataclasses import dataclass, field

import h5py
import numpy

from interphase.input_error import InputError


def open_h5(path):
    """The file at `path`, open for reading; InputError where it cannot be."""
    try:
        return h5py.File(path, "r")
    except OSError as error:
        raise InputError(f"{path}: cannot be read as HDF5: {error}; is the run still writing, or was it killed?") from None


def word(value):
    """An attribute as text where it is one, else as the number that it is."""
    if isinstance(value, bytes):  # as runs up to version 0.1 have them
        return value.decode("utf-8", "replace")
    return value.item() if isinstance(value, numpy.generic) else value


@dataclass
class Stored:
    """`values` of a data set in `unit`, and its other `attributes`."""

    values: numpy.ndarray
    unit: str
    attributes: dict = field(default_factory=dict)


def stored(dataset):
    """An open data set as `Stored`."""
    attributes = {name: word(value) for name, value in dataset.attrs.items()}
    return Stored(dataset[()], attributes.pop("unit", ""), attributes)


def attributes(path, group):
    """{name: number or text} of the attributes of `group` in the file at `path`; {} where either is not there."""
    if not os.path.isfile(path):
        return {}
    with open_h5(path) as file:
        return {name: word(value) for name, value in file[group].attrs.items()} if group in file else {}


def below(path, groups):
    """{path in the file: Stored} of all data sets below `groups` in the file at `path`; {} where there are none."""
    if not os.path.isfile(path):
        return {}
    with open_h5(path) as file:
        return within(file, groups)


def within(file, groups):
    """The same of an open file."""
    found = {}
    for group in groups:
        if group in file:
            file[group].visititems(
                lambda name, item, group=group: found.update({f"{group}/{name}": stored(item)}) if isinstance(item, h5py.Dataset) else None
            )
    return found
