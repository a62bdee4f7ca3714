# SPDX-License-Identifier: GPL-3.0-or-later
"""Data files of LIGGGHTS, as read_data reads them with atom_style granular: spheres, SI units."""

import re
from dataclasses import dataclass

import numpy

from interphase import data_file
from interphase.input_error import InputError


@dataclass
class ParticleFile:
    """What stands above the spheres (`types`: of atoms, `low` and `high` [3]: corners of the box, m), and of each sphere what a
    run does not change: ids [n], kind [n] (LIGGGHTS's type), diameter [n] in m, density [n] in kg/m3."""

    types: int
    low: numpy.ndarray
    high: numpy.ndarray
    ids: numpy.ndarray
    kind: numpy.ndarray
    diameter: numpy.ndarray
    density: numpy.ndarray


def read(path):
    """The `ParticleFile` at `path`; InputError where it is another kind of file."""
    try:
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from None
    parts = re.split(r"^[ \t]*([A-Z]\w*(?:[ \t]\w+)*)[ \t]*(?:#.*)?\n[ \t]*\n", text.partition("\n")[2], flags=re.MULTILINE)
    sections = dict(zip(parts[1::2], parts[2::2]))
    others = set(sections) - {"Atoms", "Velocities"}
    if others or "Atoms" not in sections:
        raise InputError(f"{path}: sections {', '.join(sections) or 'none'}; a file of spheres has Atoms and may have Velocities")
    rows = [line.split("#")[0].split() for line in sections["Atoms"].splitlines()]
    try:
        rows = numpy.array([row[:7] for row in rows if row], dtype=float).reshape(-1, 7)
        types = int(_above(path, parts[0], r"(\d+)\s+atom types")[0])
        edges = numpy.array([_above(path, parts[0], rf"(\S+)\s+(\S+)\s+{axis}lo\s+{axis}hi") for axis in "xyz"], dtype=float)
    except ValueError as error:
        raise InputError(f"{path}: {error}; rows of atom_style granular are: id type diameter density x y z") from None
    if re.search(r"\bxy\s+xz\s+yz\b", parts[0]):
        raise InputError(f"{path}: its box is oblique; give one along the axes")
    return ParticleFile(types, edges[:, 0], edges[:, 1], rows[:, 0].astype(int), rows[:, 1].astype(int), rows[:, 2], rows[:, 3])


def _above(path, head, pattern):
    found = re.search(rf"^\s*{pattern}", head, flags=re.MULTILINE)
    if found is None:
        raise InputError(f"{path}: no line like '{pattern}' above its spheres; is it a data file of LIGGGHTS?")
    return found.groups()


def write(path, remark, spheres, position, velocity, spin):
    """The `ParticleFile` `spheres` at `position` [n, 3] in m with `velocity` [n, 3] in m/s and `spin` [n, 3] in rad/s, every digit
    kept. `remark`: for the first line, which LIGGGHTS passes over."""
    data_file.write(path, remark, spheres.low, spheres.high, position, spheres.diameter, spheres.density, spheres.kind, velocity, spin,
                    spheres.types, spheres.ids)  # fmt: skip
