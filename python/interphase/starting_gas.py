# SPDX-License-Identifier: GPL-3.0-or-later
"""The gas of a run as that of a prepared case: cells take the values of that time, boundaries stay the case's own.

On the same mesh the values are the run's to the last bit, with `phi`, the flux through the faces. On another mesh of the same
vessel OpenFOAM's mapFields interpolates. Otherwise the case's own 0/ stays, and why is told.
"""

import os
import re
import shutil
import tempfile

import numpy

from interphase import foam_field, foam_file, launch, parts
from interphase.case_folder import CONTROL, PARAMETERS, Dictionaries
from interphase.input_error import InputError
from interphase.same_time import same_time

MESH = ("points", "faces", "owner", "neighbour")
START = "0"
NEAR = 0.01  # of a vessel's size, that meshes of the same one may differ by: a round one's facets lie elsewhere
FLUX, PRESSURE = "phi", "p_rgh"
# Boundary conditions that give a pressure, and the entry that does
GIVES = {"fixedValue": "value", "prghPressure": "p", "totalPressure": "p0", "prghTotalPressure": "p0"}


def put(start, folder, environment):
    """Write the gas of the `StartingRun` into 0/ of the case in `folder`; a phrase that says what was done."""
    time, in_parts = _time_folder(start)
    if start.time == 0:
        return "the gas starts from the case's own 0/: the run's time is 0"
    if time is None:
        written = _nearest_times(start)
        return f"the gas starts from the case's own 0/: {start.folder} wrote none at t = {start.time:.9g} s" + (
            f", but at {written}" if written else "")
    if foam_field.points(start.folder) is None:
        return f"the gas starts from the case's own 0/: {start.folder} has no mesh in constant/polyMesh"
    same = all(_same(start.folder, folder, name) for name in MESH)
    if not same and (why := _other_vessel(start.folder, folder)):
        return f"the gas starts from the case's own 0/: {why}"
    with tempfile.TemporaryDirectory(prefix=".from-", dir=folder) as scratch:
        source = os.path.join(start.folder, time)
        if in_parts:
            source = _reconstructed(start.folder, time, scratch, folder, environment)
        names = [name for name in _fields(os.path.join(folder, START)) if foam_field.path_of(source, name)]
        if not same:
            source = _mapped(source, time, start.folder, scratch, folder, environment)
        more = _pressure_above(start.folder, folder)
        for name in names:
            _take(foam_field.path_of(source, name), os.path.join(folder, START), name, more if name == PRESSURE else 0.0)
        if same and _same(start.folder, folder, "boundary") and (flux := foam_field.path_of(source, FLUX)) and FLUX not in names:
            foam_field.internal_values(flux)  # refuses a torn one
            shutil.copy(flux, os.path.join(folder, START))
            names.append(FLUX)
    how = "on the same mesh" if same else "interpolated to another mesh by mapFields"
    level = f" (p_rgh moved by {more:.9g} Pa, to the level of the case's patches)" if more else ""
    return f"the gas starts from t = {time} s of {start.folder}, {how}: {', '.join(names)}{level}"


def _times(folder):
    """{name: time [s]} of the time folders that hold U."""
    return {name: time for name, time in parts.times(folder).items() if foam_field.path_of(os.path.join(folder, name), "U")}


def _parts(folder):
    """The first folder of the parts of a parallel run; None where there is none."""
    names = sorted(name for name in os.listdir(folder) if name == "processor0" or re.fullmatch(r"processors\d+(_0-\d+)?", name))
    return os.path.join(folder, names[0]) if names else None


def _time_folder(start):
    """(name, whether it is in parts) of the time folder of the snapshot; (None, False) where there is none."""
    for folder in (start.folder, _parts(start.folder)):
        for name, time in _times(folder).items() if folder else ():
            if same_time(time, start.time):
                return name, folder != start.folder
    return None, False


def _nearest_times(start):
    times = {time for folder in (start.folder, _parts(start.folder)) if folder for time in _times(folder).values() if time > 0}
    near = sorted(sorted(times, key=lambda time: abs(time - start.time))[:3])
    return ", ".join(f"{time:.9g}" for time in near) + " s" if near else ""


def _same(one, other, name):
    """Whether a file of two meshes says the same, apart from its header."""
    paths = [foam_field.mesh_file(folder, name) for folder in (one, other)]
    if None in paths:
        return paths == [None, None]
    a, b = (foam_field.content(path) for path in paths)
    if foam_field.header(a, "format") == foam_field.header(b, "format") or name == "boundary":
        return foam_field.body(a) == foam_field.body(b)
    # One in binary, one in text, whose digits may be less; faces go with their cells and points then
    components, near = {"points": (3, 1e-9), "owner": (1, 0.0), "neighbour": (1, 0.0), "faces": (0, 0.0)}[name]
    if components == 0:
        return True
    a, b = (foam_field.whole_list(path, data, components, components == 1) for path, data in zip(paths, (a, b)))
    return a.shape == b.shape and numpy.abs(a - b).max(initial=0.0) <= near * numpy.abs(a).max(initial=0.0)


def _patches(folder):
    path = foam_field.mesh_file(folder, "boundary")
    return sorted(re.findall(r"(\w+)\s*\{", foam_field.body(foam_field.content(path)).decode()))


def _other_vessel(one, other):
    """Why fields of one mesh cannot be interpolated to the other; None where they can."""
    boxes = [(points.min(axis=0), points.max(axis=0)) for points in map(foam_field.points, (one, other))]
    size = (boxes[1][1] - boxes[1][0]).max()
    if max(numpy.abs(a - b).max() for a, b in zip(*boxes)) > NEAR * size:
        told = [", ".join(f"{axis} {a:.6g} to {b:.6g}" for axis, a, b in zip("xyz", *box)) for box in boxes]
        return f"the run's mesh is of another vessel ({told[0]} m, here {told[1]} m)"
    patches = [_patches(folder) for folder in (one, other)]
    if patches[0] != patches[1]:
        return f"the run's mesh has other patches ({', '.join(patches[0])}; here {', '.join(patches[1])})"
    return None


def _fields(folder):
    """Names of the fields of cells in a time folder."""
    found = []
    for file in sorted(os.listdir(folder)):
        path = os.path.join(folder, file)
        if os.path.isfile(path) and (foam_field.header(foam_field.content(path), "class") or "").startswith("vol"):
            found.append(file[:-3] if file.endswith(".gz") else file)
    return found


def _linked(folder, case, names):
    """A case in `folder` whose parts are those of `case`."""
    os.makedirs(folder)
    for name in names:
        if os.path.exists(os.path.join(case, name)):
            os.symlink(os.path.join(case, name), os.path.join(folder, name))
    return folder


def _reconstructed(run, time, scratch, folder, environment):
    pieces = [name for name in os.listdir(run) if re.fullmatch(r"processors?\d+(_\d+-\d+)?", name)]
    case = _linked(os.path.join(scratch, "parts"), run, ["constant", "system", "parameters", *pieces])
    log = os.path.join(folder, "log.from.reconstructPar")
    launch.step(["reconstructPar", "-case", case, "-time", time], log, environment, case)
    return os.path.join(case, time)


def _mapped(source, time, run, scratch, folder, environment):
    """The time folder `source` of `run` on the mesh of `folder`."""
    origin = _linked(os.path.join(scratch, "origin"), run, ["constant", "system", "parameters"])
    os.symlink(source, os.path.join(origin, time))
    target = _linked(os.path.join(scratch, "target"), folder, ["constant", "parameters"])
    for part in ("system", START):
        shutil.copytree(os.path.join(folder, part), os.path.join(target, part))
    control = Dictionaries(target)
    for entry, value in (("startFrom", "startTime"), ("startTime", START)):
        if control.value(CONTROL, entry) is not None:
            control.set(CONTROL, entry, value)
    control.write_into(target)
    log = os.path.join(folder, "log.from.mapFields")
    launch.step(["mapFields", origin, "-case", target, "-consistent", "-sourceTime", time], log, environment, target)
    return os.path.join(target, START)


def _pressure_above(run, folder):
    """By how much the pressure is higher at the patches of the case in `folder` that give it than at those of the case that ran [Pa].

    Only gradients of it move gas and particles: another level is taken on, or the first step would feel a jump at the patch. 0 where the
    difference is not the same at all patches, which then drives the gas.
    """
    levels = [_fixed_pressures(case) for case in (run, folder)]
    more = {levels[1][patch] - levels[0][patch] for patch in levels[0].keys() & levels[1].keys()}
    return more.pop() if len(more) == 1 else 0.0


def _fixed_pressures(case):
    """{patch: value} of the patches with one pressure, as 0/ has them; those of p_rgh and of p differ by what a case does not change."""
    path = foam_field.path_of(os.path.join(case, START), PRESSURE)
    text = foam_field.content(path).decode("latin-1") if path else ""
    found = {}
    try:
        boundaries = foam_file.parse(text[text.index("boundaryField") :]) if "boundaryField" in text else foam_file.Dictionary("")
        numbers = Dictionaries(case)
        for patch in (each for whole in boundaries.entries for each in getattr(whole, "entries", ())):
            entries = {entry.key: entry.value for entry in getattr(patch, "entries", ()) if isinstance(entry, foam_file.Entry)}
            value = re.sub(r"\$[:.]*\{?(\w+)\}?", lambda macro: _parameter(numbers, macro), entries.get(GIVES.get(entries.get("type")), ""))
            if (number := re.fullmatch(r"uniform\s+([-+.\deE]+)", value)):
                found[foam_file.unquoted(patch.key)] = float(number[1])
    except InputError:
        return {}
    return found


def _parameter(case, macro):
    return case.value(PARAMETERS, macro[1], macro[0]) if case.has(PARAMETERS) else macro[0]


def _take(source, folder, name, more):
    """internalField of the file `source`, with `more` added, for the field `name` in `folder`, whose boundaries stay."""
    path = foam_field.path_of(folder, name)
    values = foam_field.internal_values(source, more)
    data = foam_field.content(path)
    kinds = [foam_field.header(each, "class") for each in (data, foam_field.content(source))]
    if kinds[0] != kinds[1]:
        raise InputError(f"--from: {source} is a {kinds[1]}, {path} a {kinds[0]}")
    if foam_field.header(data, "format") == "binary" and b"nonuniform" in foam_field.body(data):
        raise InputError(f"--from: {path} holds binary lists, which are not rewritten: give the case's 0/ in ASCII (foamFormatConvert)")
    try:
        text = data.decode()
        entry = foam_file.find(text, "internalField")
        text = text[: entry.start] + "\0" + text[entry.end :]
        # what boundaries take from it is the case's own value, too
        text = re.sub(r"\$[:.]*(?:internalField\b|\{[:.]*internalField\})", lambda _: entry.value, text).replace("\0", values)
    except (UnicodeDecodeError, foam_file.FoamFileError) as error:
        raise InputError(f"--from: {path}: {error}") from None
    text = re.sub(r"(FoamFile\s*\{[^}]*?\bformat\s+)binary\b", r"\1ascii", text, count=1)
    os.remove(path)
    with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
        stream.write(text)
