# SPDX-License-Identifier: GPL-3.0-or-later
"""Write a bed of spheres as a LIGGGHTS data file (`read_data`, atom_style granular).

Three kinds of bed:

  loose   --count N with --fill HEIGHT or --packing FRACTION: a jittered lattice that fills the box from its
          bottom, without overlaps and clear of the walls. The same arguments give the same bed, byte for
          byte, and spheres are numbered layer by layer from the bottom, so a run starts from the same
          state however many ranks it has.
  exact   --grid --voidage E: a regular lattice of exactly that voidage. A whole number of its unit cells
          must fit the region, so that a mesh can be laid whose every cell holds the same spheres.
  mixed   --sizes D:SHARE ... or --lognormal MEDIAN DEVIATION in place of --diameter: spheres of several sizes in
          disorder, evenly over the region up to --fill or --packing, without overlaps and clear of the walls.
          --count is that of real particles; with --weights W they are tracked as parcels of W, of diameter
          d W^(1/3). The sizes follow the distribution as closely as so many particles can.

Lengths in m, density in kg/m3. Spheres have type 1, with --type-per-size each size its own; higher types are for
walls.

  bed --sizes 1e-3:0.3 2e-3:0.7 --shares mass --count 5000 --packing 0.5 ...
  bed --lognormal 1e-3 1.3 --cut 5e-4 2e-3 --count 5000 --fill 0.05 ...
"""

import argparse
import math
import random
import sys
from dataclasses import dataclass

from interphase import data_file, sizes
from interphase.input_error import InputError

# Places of the spheres in a unit cell, as fractions of its edge, symmetric about its middle, so that the same
# lattice starts and ends half a spacing from the faces of the region. The bottom ones first.
LATTICES = {
    "cubic": ((0.5, 0.5, 0.5),),
    "bcc": ((0.25, 0.25, 0.25), (0.75, 0.75, 0.75)),
    "fcc": ((0.25, 0.25, 0.25), (0.75, 0.75, 0.25), (0.75, 0.25, 0.75), (0.25, 0.75, 0.75)),
}
NEAREST = {"cubic": 1.0, "bcc": math.sqrt(3) / 2, "fcc": math.sqrt(2) / 2}  # distance of neighbours per edge


@dataclass(frozen=True)
class Box:
    """An axis-aligned box: (low, high) along x, y, z [m]."""

    low: tuple
    high: tuple

    @classmethod
    def from_six(cls, six):
        box = cls(tuple(six[0::2]), tuple(six[1::2]))
        for axis, low, high in zip("xyz", box.low, box.high):
            if not low < high:
                raise InputError(f"box is empty along {axis}: {axis}lo = {low:g} m, {axis}hi = {high:g} m")
        return box

    @property
    def lengths(self):
        return tuple(high - low for low, high in zip(self.low, self.high))


def sphere_volume(diameter):
    return math.pi / 6 * diameter**3


def loose_sites(count, diameter, box, fill):
    """Numbers of lattice sites (nx, ny, nz) that hold `count` spheres up to `fill` [m] above the bottom with the
    widest gap between neighbours."""
    width, depth, _ = box.lengths
    best, best_gap = None, -math.inf
    for nx in range(1, int(width / diameter) + 1):
        for ny in range(1, int(depth / diameter) + 1):
            nz = -(-count // (nx * ny))
            gap = min(width / nx, depth / ny, fill / nz) - diameter
            if gap > best_gap:
                best, best_gap = (nx, ny, nz), gap
    return best, best_gap


def spread_evenly(count, places):
    """`count` of the numbers 0 .. places - 1, evenly spaced."""
    return [(2 * i + 1) * places // (2 * count) for i in range(count)]


def loose_bed(count, diameter, box, fill, jitter, seed):
    """Centres of `count` spheres on a jittered lattice up to `fill` [m] above the bottom of `box`."""
    height = box.lengths[2]
    solid = count * sphere_volume(diameter) / (box.lengths[0] * box.lengths[1])
    what = f"{count} spheres of {diameter:g} m"
    if fill > height * (1 + 1e-12):
        raise InputError(f"{what} would reach {fill:g} m above the bottom, the box is {height:g} m high")
    sites, gap = loose_sites(count, diameter, box, fill)
    if sites is None:
        raise InputError(f"the box is narrower than one sphere of {diameter:g} m: {box.lengths[0]:g} x {box.lengths[1]:g} m")
    if gap < 0:
        nx, ny = int(box.lengths[0] / diameter), int(box.lengths[1] / diameter)
        least = -(-count // (nx * ny)) * diameter
        raise InputError(
            f"{what} do not fit into {fill:g} m above the bottom (packing {solid / fill:.4g}) without overlap; "
            f"a lattice in this box needs {least:.6g} m (packing {solid / least:.4g})"
            + ("" if least <= height else f", which is more than its height of {height:g} m")
        )
    nx, ny, nz = sites
    spacing = (box.lengths[0] / nx, box.lengths[1] / ny, fill / nz)
    # Moved by at most half the gap, two neighbours keep a diameter along the axis on which they differ.
    reach = [jitter * 0.5 * (s - diameter) for s in spacing]
    # Python promises the sequence of random() for a given seed to stay what it is.
    draw = random.Random(seed).random
    centres = []
    for k in range(nz):
        left = count - k * nx * ny
        for site in range(nx * ny) if left >= nx * ny else spread_evenly(left, nx * ny):
            where = (site % nx, site // nx, k)
            centres.append(tuple(box.low[a] + (where[a] + 0.5) * spacing[a] + reach[a] * (2 * draw() - 1) for a in range(3)))
    return centres


def grid_bed(voidage, lattice, diameter, region):
    """Centres of a regular lattice of exactly `voidage` that fills `region`."""
    places = LATTICES[lattice]
    edge = (len(places) * sphere_volume(diameter) / (1 - voidage)) ** (1 / 3)
    if NEAREST[lattice] * edge < diameter * (1 - 1e-12):
        touching = diameter / NEAREST[lattice]
        least = 1 - len(places) * sphere_volume(diameter) / touching**3
        raise InputError(f"spheres on a {lattice} lattice overlap below a voidage of {least:.4g}, asked for {voidage:g}")
    cells = []
    for axis, length in zip("xyz", region.lengths):
        n = round(length / edge)
        if n < 1 or abs(length / n - edge) > 1e-6 * edge:
            raise InputError(
                f"along {axis} the region ({length:.9g} m) holds {length / edge:.6g} unit cells of {edge:.9g} m "
                f"(voidage {voidage:g}, {lattice}); make it a whole number, say {max(n, 1) * edge:.9g} m"
            )
        cells.append(n)
    spacing = [length / n for length, n in zip(region.lengths, cells)]
    centres = []
    for k in range(cells[2]):
        for level in sorted({place[2] for place in places}):
            for j in range(cells[1]):
                for i in range(cells[0]):
                    for place in (p for p in places if p[2] == level):
                        centres.append(
                            tuple(
                                region.low[a] + (corner + place[a]) * spacing[a]
                                for a, corner in enumerate((i, j, k))
                            )
                        )
    return centres


def mixed_bed(spheres, region, fill, packing, seed):
    """Atoms (type, diameter, x, y, z) of sizes.Spheres, from the bottom up, evenly in `region` up to `fill` or at `packing`."""
    from interphase import mixed_bed as mixed  # numpy and scipy, which other beds do not need

    diameters = [s.diameter for s in spheres for _ in range(s.count)]
    solid = math.fsum(map(sphere_volume, diameters))
    area = region.lengths[0] * region.lengths[1]
    fill = fill or solid / (packing * area)
    if fill > region.lengths[2] * (1 + 1e-12):
        raise InputError(
            f"{len(diameters)} spheres would reach {fill:g} m above the bottom, the box is {region.lengths[2]:g} m high"
        )
    if solid >= 0.74 * fill * area:
        raise InputError(f"{len(diameters)} spheres in {fill:g} m above the bottom are a packing of {solid / (fill * area):.3g}")
    centres = mixed.mixed_bed(diameters, region.low, (*region.high[:2], region.low[2] + fill), seed)
    kinds = [s.type for s in spheres for _ in range(s.count)]
    return sorted(zip(kinds, diameters, *(map(float, along) for along in centres.T)), key=lambda atom: atom[4])


def write_script(path, spheres):
    """Commands of LIGGGHTS that give each parcel its weight."""
    with open(path, "w", encoding="ascii") as out:
        out.write("# Weights of the parcels (tools/bed); after read_data, before walls and integrator\n")
        out.write(f"fix weights all property/atom weight scalar yes no no {spheres[0].weight!r}\nrun 0\n")
        for kind, weight in sorted({(s.type, s.weight) for s in spheres}):
            out.write(f"set type {kind} property/atom weight {weight!r}\n")


def write(path, atoms, density, box, types):
    """The data file of atoms (type, diameter, x, y, z)."""
    kinds, diameters, *_ = zip(*atoms)
    data_file.write(path, f"{len(atoms)} spheres (tools/bed)", box.low, box.high, [atom[2:] for atom in atoms], diameters, density, kinds,
                    types=types)  # fmt: skip


def arguments(argv):
    parser = argparse.ArgumentParser(prog="bed", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    six = {"nargs": 6, "type": float, "metavar": ("XLO", "XHI", "YLO", "YHI", "ZLO", "ZHI")}
    parser.add_argument("--out", required=True, metavar="FILE", help="data file to write")
    size = parser.add_mutually_exclusive_group(required=True)
    size.add_argument("--diameter", type=float, metavar="M", help="of every sphere [m]")
    size.add_argument("--sizes", nargs="+", metavar="D:SHARE", help="diameters [m] and their shares")
    size.add_argument(
        "--lognormal", nargs=2, type=float, metavar=("MEDIAN", "DEVIATION"),
        help="median diameter [m] and geometric standard deviation",
    )
    parser.add_argument("--density", required=True, type=float, metavar="R", help="of the spheres [kg/m3]")
    parser.add_argument("--box", required=True, **six, help="the LIGGGHTS domain [m]")
    parser.add_argument("--region", **six, help="part of the box to fill [m] (default: all of it)")
    parser.add_argument("--types", type=int, default=2, metavar="N", help="atom types of the scene (default 2: spheres, walls)")
    mixed = parser.add_argument_group("mixed bed")
    mixed.add_argument("--shares", choices=("number", "mass"), help="what shares and median are of (default number)")
    mixed.add_argument("--cut", nargs=2, type=float, metavar=("LOW", "HIGH"), help="of a lognormal distribution [m]")
    mixed.add_argument(
        "--weights", nargs="+", type=float, metavar="W", help="real particles per parcel: one, or one of each size (default 1)"
    )
    mixed.add_argument("--type-per-size", action="store_true", help="types 1, 2, ... in the order of --sizes, those of walls after")
    mixed.add_argument("--script", metavar="FILE", help="write commands of LIGGGHTS that give each type its weight")
    loose = parser.add_argument_group("loose and mixed bed")
    loose.add_argument("--count", type=int, metavar="N", help="number of spheres; of a mixed bed, of real particles")
    height = loose.add_mutually_exclusive_group()
    height.add_argument("--fill", type=float, metavar="H", help="height of the bed above the bottom [m]")
    height.add_argument("--packing", type=float, metavar="F", help="solid fraction of the bed, instead of --fill")
    loose.add_argument("--jitter", type=float, metavar="J", help="share of the free gap used for disorder, 0 to 1 (default 0.9)")
    loose.add_argument("--seed", type=int, metavar="S", help="of the disorder (default 1)")
    exact = parser.add_argument_group("exact bed")
    exact.add_argument("--grid", action="store_true", help="regular lattice of exactly --voidage")
    exact.add_argument("--voidage", type=float, metavar="E", help="of the lattice")
    exact.add_argument("--lattice", choices=sorted(LATTICES), help="cubic: voidage above 0.476; bcc: 0.320 (default); fcc: 0.260")
    options = parser.parse_args(argv)

    def needs(holds, message):
        if not holds:
            parser.error(message)

    options.mixed = options.diameter is None
    needs(options.mixed or options.diameter > 0, f"--diameter must be positive, got {options.diameter} m")
    needs(options.density > 0, f"--density must be positive, got {options.density:g} kg/m3")
    needs(options.types >= 1, f"--types must be 1 or more, got {options.types}")
    needs(options.count is None or options.count >= 1, f"--count must be 1 or more, got {options.count}")
    for name in ("shares", "cut", "weights", "script"):
        needs(options.mixed or getattr(options, name) is None, f"--{name} is for mixed beds, --diameter was given")
    needs(options.mixed or not options.type_per_size, "--type-per-size is for mixed beds, --diameter was given")
    needs(not options.mixed or not options.grid, "--grid needs --diameter: a lattice of one size")
    needs(not options.mixed or options.jitter is None, "--jitter is for beds of one size")
    needs(options.cut is None or options.lognormal is not None, "--cut needs --lognormal")
    if options.grid:
        for name in ("fill", "packing", "jitter", "seed"):
            needs(getattr(options, name) is None, f"--{name} is for loose beds, --grid was given")
        needs(options.voidage is not None, "--grid needs --voidage")
        needs(0 < options.voidage < 1, f"--voidage must be between 0 and 1, got {options.voidage:g}")
        options.lattice = options.lattice or "bcc"
    else:
        for name in ("voidage", "lattice"):
            needs(getattr(options, name) is None, f"--{name} needs --grid")
        needs(options.count is not None, "--count is missing (or --grid, for a regular lattice)")
        needs(options.fill is not None or options.packing is not None, "--fill or --packing is missing")
        needs(options.fill is None or options.fill > 0, f"--fill must be positive, got {options.fill} m")
        packing = options.packing
        needs(packing is None or 0 < packing < 1, f"--packing must be between 0 and 1, got {packing}")
        options.jitter = 0.9 if options.jitter is None else options.jitter
        options.seed = 1 if options.seed is None else options.seed
        needs(0 <= options.jitter <= 1, f"--jitter must be between 0 and 1, got {options.jitter:g}")
    return options


def mixture(options):
    """sizes.Spheres of the options."""
    by_mass = options.shares == "mass"
    if options.lognormal:
        distribution = sizes.Lognormal(*options.lognormal, by_mass, *(options.cut or ()))
    else:
        pairs = [word.split(":") for word in options.sizes]
        try:
            table = [(float(diameter), float(share)) for diameter, share in pairs]
        except ValueError:
            raise InputError(f"--sizes wants D:SHARE ..., two numbers each, got {' '.join(options.sizes)}") from None
        distribution = sizes.Table(*zip(*table), by_mass)
        if options.type_per_size and options.types < len(table):
            raise InputError(f"--types {options.types} is less than the {len(table)} types that --type-per-size gives")
    return sizes.tracked(distribution, options.count, tuple(options.weights or (1.0,)), options.type_per_size)


def main(argv=None):
    options = arguments(argv)
    try:
        box = Box.from_six(options.box)
        region = Box.from_six(options.region) if options.region else box
        slack = 1e-9 * max(box.lengths)
        for a, axis in enumerate("xyz"):
            if region.low[a] < box.low[a] - slack or region.high[a] > box.high[a] + slack:
                raise InputError(
                    f"the region ({region.low[a]:g} to {region.high[a]:g} m) leaves the box "
                    f"({box.low[a]:g} to {box.high[a]:g} m) along {axis}"
                )
        if options.mixed:
            spheres = mixture(options)
            atoms = mixed_bed(spheres, region, options.fill, options.packing, options.seed)
            if options.script:
                write_script(options.script, spheres)
        elif options.grid:
            centres = grid_bed(options.voidage, options.lattice, options.diameter, region)
            if options.count not in (None, len(centres)):
                raise InputError(f"the lattice has {len(centres)} spheres in this region, --count asks for {options.count}")
        else:
            area = region.lengths[0] * region.lengths[1]
            fill = options.fill or options.count * sphere_volume(options.diameter) / (options.packing * area)
            centres = loose_bed(options.count, options.diameter, region, fill, options.jitter, options.seed)
        if not options.mixed:
            atoms = [(1, options.diameter, *centre) for centre in centres]
        write(options.out, atoms, options.density, box, options.types)
    except InputError as error:
        sys.exit(f"bed: {error}")
    except OSError as error:
        sys.exit(f"bed: cannot write '{options.out}': {error.strerror}")
    top = max(z + 0.5 * diameter for _, diameter, _, _, z in atoms) - region.low[2]
    smallest, largest = min(atom[1] for atom in atoms), max(atom[1] for atom in atoms)
    width = f"{smallest:.6g} m" if smallest == largest else f"{smallest:.6g} to {largest:.6g} m"
    mass = options.density * math.fsum(sphere_volume(atom[1]) for atom in atoms)
    print(f"bed: {len(atoms)} spheres of {width}, {mass:.6g} kg, {top:.4g} m high, in {options.out}")


if __name__ == "__main__":
    main()
