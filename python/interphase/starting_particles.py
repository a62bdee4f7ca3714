# SPDX-License-Identifier: GPL-3.0-or-later
"""The particles of a run as those of a case: in place of the ones in the file that the case's script reads.

Positions, velocities, spins and diameters are the snapshot's, to the last bit. Types and densities are too where it has them
(`type`, `density`); otherwise they come from the run's own file, by id, or where spheres of one diameter have one type and density
only, by that. Box and number of types are those of the case's file, which also says what spheres its script is for.
"""

import os

import numpy

from interphase import methods, particle_file
from interphase.case_folder import Dictionaries
from interphase.input_error import InputError
from interphase.particle_script import particle_source

# Of a radius. Springs are chosen for overlaps of some 2 % (a diameter's hundredth): at ten times that they hold a hundred times the
# energy of the fastest contact they are for. The program tells of overlaps from 5 % on.
DEEPEST = 0.2
ROUND_OFF = 1e-9  # relative, of diameters and densities that went through texts and halves
CONVENTION = "the particles of a run go into the one file that the script reads by `read_data FILE`, and stay as they are there"


def check_script(source, name):
    """InputError where a script has no place for particles of another run, or would change them."""
    if source.others:
        what = "also makes or changes particles" if source.file else "makes its particles itself"
        raise InputError(f"--from: the script of {name} {what} ({'; '.join(source.others[:3])}): {CONVENTION}; "
                        "take that out of the script" + ("" if source.file else " and put `read_data dem/bed.data` in its place"))
    if source.file is None:
        raise InputError(f"--from: the script of {name} reads no particles: {CONVENTION}; add `read_data dem/bed.data` and the file")


def check_weight(start, weight, name):
    """InputError where tracked spheres of the run stand for other numbers of particles than those of the case."""
    own = start.particles.quantities.get("weight")
    if own is not None and (own != weight).any():
        raise InputError(f"--from: {start.where}: spheres stand for {own.min():g} to {own.max():g} particles, and {name} has weight "
                        f"{weight:g} for all; parcels can neither be split nor joined: start from a run of one weight, {weight:g}")
    if own is None and start.weight is None:
        raise InputError(f"--from: {start.folder} tells its weight neither in results.h5 nor in run.json: it is no whole record of a run")
    if own is None and start.weight != weight:
        raise InputError(f"--from: spheres of {start.folder} stand for {start.weight:g} particles each, and {name} has weight {weight:g}; "
                        f"parcels can neither be split nor joined: give {_with(start.weight)}, or start from a run of weight {weight:g}")


def check_springs(start, method):
    """InputError where springs would begin with overlaps far deeper than they are made for."""
    def of_springs(name):
        known = methods.of_tree().get(name)
        return known is not None and known.contacts == "resolved"

    if not of_springs(method) or of_springs(start.method):
        return
    from interphase import bed_statistics  # scipy

    depths = 2 * bed_statistics.overlaps(start.particles.quantities["position"], start.particles.quantities["diameter"])
    deep = depths > DEEPEST
    if deep.any():
        parcels = start.weight != 1
        raise InputError(
            f"--from: {deep.sum()} pairs of {start.where} overlap by more than {100 * DEEPEST:g} % of a radius, the deepest by "
            f"{100 * depths.max():.3g} %: "
            f"the springs of {method} would burst the bed apart. Let hard spheres part them first: tools/run ... --method "
            f"{'CGHS' if parcels else 'TDHS'} --from {start.folder}@{start.time:.9g} for some tenths of a second, then --from that run")


def _with(weight):
    return "--method DEM or TDHS" if weight == 1 else f"--weight {weight:g} with --method CGPM, CGHS or MPPIC"


def put(start, folder, name, moved=0.0):
    """Write the particles of the `StartingRun` into the file of the prepared case in `folder`, all moved by `moved` [m] along x.

    Returns the number of spheres that the file held before. InputError where they do not belong there.
    """
    source = particle_source(Dictionaries(folder))
    check_script(source, name)
    path = os.path.join(folder, source.file)
    own = particle_file.read(path)
    state = start.particles.quantities
    kind, density = _kinds(start, own, source.file)
    _check_kinds(own, source.file, kind, state["diameter"], density, start, name)
    position = state["position"] + (moved, 0.0, 0.0) if moved else state["position"]
    outside = ~source_holds(position, own.low, own.high, source.periodic)
    refuse_outside(outside, start, position, f"the box of {source.file} in {name}", own.low, own.high)
    spheres = particle_file.ParticleFile(own.types, own.low, own.high, start.particles.ids, kind, state["diameter"], density)
    particle_file.write(path, f"{len(kind)} spheres of {start.where}", spheres, position, state["velocity"], state["spin"])
    return len(own.ids)


def source_holds(position, low, high, periodic):
    """Which centres [n, 3] are inside, along the directions that do not repeat: [n]."""
    inside = (position >= low) & (position < high)
    return (inside | numpy.array(periodic)).all(axis=1)


def refuse_outside(outside, start, position, what, low, high):
    """InputError with number and place of the particles that `outside` [n] marks."""
    if not outside.any():
        return
    ids, centres = start.particles.ids[outside], position[outside]
    spans = ", ".join(f"{axis} {a:.6g} to {b:.6g}" for axis, a, b in zip("xyz", centres.min(axis=0), centres.max(axis=0)))
    box = ", ".join(f"{axis} {a:.6g} to {b:.6g}" for axis, a, b in zip("xyz", low, high))
    raise InputError(f"--from: {len(ids)} of {len(outside)} particles of {start.where} are outside of {what} ({box} m): they are at "
                     f"{spans} m, the first is particle {ids[0]}; a bed goes into a vessel that holds it")


def _kinds(start, own, file):
    """Type and density of each sphere, [n] each."""
    state = start.particles.quantities
    if "type" in state and "density" in state:
        return state["type"].astype(int), state["density"]
    theirs, inserts = _file_of(start.folder)
    if theirs is not None and not inserts:
        order = numpy.argsort(theirs.ids)
        at = numpy.searchsorted(theirs.ids[order], start.particles.ids).clip(max=len(order) - 1)
        rows = order[at]
        if (theirs.ids[rows] == start.particles.ids).all() and _equal(theirs.diameter[rows], state["diameter"]).all():
            return theirs.kind[rows], theirs.density[rows]
    files = [own] if theirs is None else [theirs, own]
    known = sorted({row for each in files for row in zip(each.diameter.tolist(), each.kind.tolist(), each.density.tolist())})
    kind, density = numpy.zeros(len(start.particles.ids), dtype=int), numpy.zeros(len(start.particles.ids))
    for diameter in numpy.unique(state["diameter"]):
        fit = {row[1:] for row in known if _equal(row[0], diameter)}
        if len(fit) != 1:
            found = "none" if not fit else "; ".join(f"type {k}, {rho:g} kg/m3" for k, rho in sorted(fit))
            raise InputError(
                f"--from: {start.where} has neither types nor densities, and for its spheres of {diameter:.9g} m they follow from no file of "
                f"particles: found {found} (in {file} and the file of {start.folder}); start from a run that reads its particles from "
                "a file, or prepare the case for spheres of that diameter")
        mine = state["diameter"] == diameter
        kind[mine], density[mine] = fit.pop()
    return kind, density


def _equal(a, b):
    return numpy.abs(a - b) <= ROUND_OFF * numpy.abs(b)


def _file_of(folder):
    """(the run's own file of particles or None, whether particles came later)."""
    try:
        source = particle_source(Dictionaries(folder), missing=[])
        return (particle_file.read(os.path.join(folder, source.file)) if source.file else None), source.inserts
    except InputError:
        return None, False


def _check_kinds(own, file, kind, diameter, density, start, name):
    """The case's springs, walls and books are made for the spheres of its own file."""
    for each in numpy.unique(kind):
        mine, prepared = kind == each, own.kind == each
        if not prepared.any():
            raise InputError(f"--from: {start.where} has {mine.sum()} spheres of type {each}, and {file} of {name} none; its script is not "
                             "made for them")
        for what, unit, values, of_case in (("diameter", "m", diameter, own.diameter), ("density", "kg/m3", density, own.density)):
            low, high = of_case[prepared].min() * (1 - ROUND_OFF), of_case[prepared].max() * (1 + ROUND_OFF)
            wrong = mine & ((values < low) | (values > high))
            if wrong.any():
                raise InputError(
                    f"--from: {wrong.sum()} of {mine.sum()} spheres of type {each} in {start.where} have another {what} than those of {name}: "
                    f"{_range(values[wrong])} {unit}, and {file} has {_range(of_case[prepared])} {unit}; give the case the run's "
                    "(tools/run --set), as contacts and drag are made for it")


def _range(values):
    low, high = values.min(), values.max()
    return f"{low:.9g}" if low == high else f"{low:.9g} to {high:.9g}"
