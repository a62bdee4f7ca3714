# SPDX-License-Identifier: GPL-3.0-or-later
"""The text of LIGGGHTS's data files (`read_data`, atom_style granular): spheres in SI units, every digit of each number.

Lines of Atoms are `id type diameter density x y z`, as LIGGGHTS's atom_vec_sphere.cpp reads them, those of Velocities
`id vx vy vz omegax omegay omegaz`. Needs nothing beyond Python's standard library: arrays of numpy will do, and lists.
"""

from itertools import repeat

LONGEST_REMARK = 200  # bytes: LIGGGHTS takes what is beyond 255 of the first line for the second


def _rows(values, count):
    """`values` [count, 3] as lists of floats; zeros for None."""
    if values is None:
        return repeat((0.0, 0.0, 0.0), count)
    return [[float(x) for x in row] for row in (values.tolist() if hasattr(values, "tolist") else values)]


def _column(values, count, kind=float):
    """`values` [count], or one for all."""
    if hasattr(values, "__len__"):
        return map(kind, values.tolist() if hasattr(values, "tolist") else values)
    return repeat(kind(values), count)


def text(remark, low, high, position, diameter, density, kind=1, velocity=None, spin=None, types=2, ids=None):
    """The file of the spheres at `position` [n, 3] in m, in the box from `low` [3] to `high` [3] in m.

    `diameter` in m, `density` in kg/m3 and `kind` (LIGGGHTS's type): [n] or one for all; `velocity` [n, 3] in m/s and `spin` [n, 3] in
    rad/s, at rest where neither is given; `types`: of atoms in the scene; `ids` [n], 1 to n where None. `remark` goes into the first line.
    """
    position = _rows(position, 0)
    count = len(position)
    first = f"LIGGGHTS data file, atom_style granular, SI units: {remark}".encode("ascii", "replace").decode()
    lines = ["".join(each if each.isprintable() else " " for each in first[:LONGEST_REMARK]), "", f"{count} atoms", f"{types} atom types", ""]
    lines += [f"{float(a)!r} {float(b)!r} {axis}lo {axis}hi" for axis, a, b in zip("xyz", low, high)]
    ids = list(_column(range(1, count + 1) if ids is None else ids, count, int))
    lines += ["", "Atoms", ""]
    lines += [
        f"{i} {k} {d!r} {rho!r} {x!r} {y!r} {z!r}"
        for i, k, d, rho, (x, y, z) in zip(ids, _column(kind, count, int), _column(diameter, count), _column(density, count), position)
    ]
    if velocity is not None or spin is not None:
        lines += ["", "Velocities", ""]
        lines += [f"{i} {u!r} {v!r} {w!r} {a!r} {b!r} {c!r}"
                  for i, (u, v, w), (a, b, c) in zip(ids, _rows(velocity, count), _rows(spin, count))]  # fmt: skip
    return "\n".join(lines) + "\n"


def write(path, *columns, **more):
    """The `text` of the same arguments into the file at `path`."""
    with open(path, "w", encoding="ascii") as out:
        out.write(text(*columns, **more))
