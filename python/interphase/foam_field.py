# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists of numbers in OpenFOAM's files: values of a field, points of a mesh; ASCII or binary, packed by gzip or not."""

import gzip
import os
import re
import zlib
from dataclasses import dataclass

import numpy

from interphase.input_error import InputError

COMPONENTS = {"scalar": 1, "vector": 3, "sphericalTensor": 1, "symmTensor": 6, "tensor": 9}


def path_of(folder, name):
    """The path of a file that may be packed; None where it is not there."""
    return next((path for path in (os.path.join(folder, name), os.path.join(folder, name + ".gz")) if os.path.isfile(path)), None)


def content(path):
    """Its bytes, unpacked."""
    try:
        with gzip.open(path) if path.endswith(".gz") else open(path, "rb") as stream:
            return stream.read()
    except (OSError, EOFError, zlib.error) as error:
        raise InputError(f"{path}: cannot be read: {error}") from None


def header(data, key):
    """The value of `key` in FoamFile, None where there is none."""
    found = re.search(rb"FoamFile\s*\{(.*?)\}", data, re.DOTALL)
    value = found and re.search(rb"\b" + key.encode() + rb"\s+(\"[^\"]*\"|[^;]+);", found[1])
    return value[1].decode().strip().strip('"') if value else None


def body(data):
    """What follows on FoamFile { ... }."""
    found = re.search(rb"FoamFile\s*\{.*?\}", data, re.DOTALL)
    return data[found.end():] if found else data


@dataclass
class InternalField:
    """Values of a field in cells or faces: `kind` (scalar, vector, ...), `values` [n, components]; one row, n = 1, where `uniform`."""

    kind: str
    values: numpy.ndarray
    uniform: bool


def internal_field(path, data=None):
    """The `InternalField` of the file of a field, uniform or not; InputError where there is none, or a torn one.
    `data`: its content, where that is read already."""
    data = content(path) if data is None else data
    found = re.search(rb"\binternalField\s+uniform\s+([^;$]+);", data)
    if found:
        values = numpy.array(found[1].replace(b"(", b" ").replace(b")", b" ").split(), dtype=float).reshape(1, -1)
        kinds = [kind for kind, components in COMPONENTS.items() if components == values.shape[1]]
        return InternalField(kinds[0], values, True)
    found = re.search(rb"\binternalField\s+nonuniform\s+(?:List<(\w+)>\s*)?(\d+)\s*([({])", data)
    # A list of nothing, of a rank without cells, is written without its kind.
    kind = found and (found[1].decode() if found[1] else _kind_by_class(header(data, "class")))
    if kind not in COMPONENTS:
        raise InputError(f"{path}: no internalField with values of cells or faces")
    count = int(found[2])
    return InternalField(kind, _numbers(path, data, found.end(), count, COMPONENTS[kind], found[3] == b"{"), False)


def _kind_by_class(name):
    """`volVectorField` -> vector."""
    word = re.fullmatch(r"(?:vol|surface)(\w+)Field", name or "")
    return word and word[1][0].lower() + word[1][1:]


def internal_values(path, more=0.0):
    """internalField, `more` added to each number, as text for an ASCII file, every digit kept: `uniform V`, or `nonuniform List<T> ...`."""
    data = content(path)
    uniform = re.search(rb"\binternalField\s+(uniform\s+[^;$]+);", data)
    if uniform:
        text = uniform[1].decode()
        return text if more == 0 else f"uniform {float(text.split()[1]) + more!r}"
    found = internal_field(path, data)
    kind, values = found.kind, found.values + more
    count = len(values)
    rows = (repr(v[0]) for v in values.tolist()) if COMPONENTS[kind] == 1 else ("(" + " ".join(map(repr, v)) + ")" for v in values.tolist())
    return f"nonuniform List<{kind}>\n{count}\n(\n" + "\n".join(rows) + "\n)"


def mesh_file(folder, name):
    """The path of a file of the mesh in the case `folder`; None where it is not there."""
    return path_of(os.path.join(folder, "constant/polyMesh"), name)


def points(folder):
    """Of the mesh in the case `folder` [n, 3], m; None where there are none."""
    path = mesh_file(folder, "points")
    return path and whole_list(path, content(path), 3)


def whole_list(path, data, components, labels=False):
    """The list [n, components] that a file of a mesh is; of whole numbers with `labels`."""
    start = body(data)
    found = re.search(rb"(?:^|\n)\s*(\d+)\s*([({])", start)
    if found is None:
        raise InputError(f"{path}: holds no list")
    return _numbers(path, data, len(data) - len(start) + found.end(), int(found[1]), components, found[2] == b"{", labels)


def _numbers(path, data, at, count, components, repeated, labels=False):
    """[count, components] from the place behind the opening bracket on. InputError where some are missing."""
    if header(data, "format") == "binary":
        arch = header(data, "arch") or ""
        size = 8 if f"{'label' if labels else 'scalar'}=64" in arch or not (labels or "scalar=32" in arch) else 4
        kind = f"{'>' if 'MSB' in arch else '<'}{'i' if labels else 'f'}{size}"
        size = count * components * numpy.dtype(kind).itemsize
        if len(data) < at + size + 1 or data[at + size : at + size + 1] != b")":
            raise InputError(f"{path}: its {count} values are not all there: the file is torn; take another time")
        return numpy.frombuffer(data, kind, count * components, at).astype(float).reshape(count, components)
    end = re.compile(rb"\}" if repeated else rb"\)\s*(?:;|$|\n\s*//)").search(data, at)
    words = data[at : end.start() if end else at].replace(b"(", b" ").replace(b")", b" ").split()
    try:
        values = numpy.array(words, dtype=float)
    except ValueError:
        values = numpy.zeros(0)
    if repeated and len(values) == components:
        values = numpy.tile(values, count)
    if len(values) != count * components:
        raise InputError(f"{path}: its {count} values are not all there: the file is torn; take another time")
    return values.reshape(count, components)
