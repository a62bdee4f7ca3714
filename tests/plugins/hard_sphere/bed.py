# SPDX-License-Identifier: GPL-3.0-or-later
"""Beds of hard spheres poured into a box by interphase-liggghts with the plug-in hard_sphere, and what came of them."""

import math
import os

import numpy
from scipy.spatial import cKDTree

import support
from interphase import data_file, launch

# of cases/sscp1
DIAMETER, DENSITY, STIFFNESS, RESTITUTION = 3.256e-3, 1131.0, 800.0, 0.84

SCRIPT = """
units           si
atom_style      granular
atom_modify     map array
boundary        f f f
newton          off
communicate     single vel yes
processors      * 1 1
read_data       bed.data
atom_modify     sort 500 ${sortSize}
neighbor        ${skin} bin
neigh_modify    delay 0
fix en all property/global coefficientRestitution peratomtypepair 2 0.84 0.92 0.92 0.92
fix et all property/global tangentialRestitution peratomtypepair 2 0.84 0.92 0.92 0.92
fix mu all property/global coefficientFriction peratomtypepair 2 0.35 0.35 0.35 0.35
fix left   all wall/tdhs primitive type 2 xplane 0.0
fix right  all wall/tdhs primitive type 2 xplane ${width}
fix front  all wall/tdhs primitive type 2 yplane 0.0
fix back   all wall/tdhs primitive type 2 yplane ${depth}
fix bottom all wall/tdhs primitive type 2 zplane 0.0
fix gravity all gravity 9.81 vector 0.0 0.0 -1.0
fix move all tdhs ${words}
timestep        ${solidStep}
compute         centre all com
variable        now equal step*dt
variable        kinetic equal ke
variable        count equal atoms
variable        height equal c_centre[3]
fix record all print ${every} "${now} ${count} ${kinetic} ${height}" file record.txt screen no title "t[s] spheres kinetic_energy[J] mean_height[m]"
thermo_style    custom step atoms ke
thermo          ${steps}
thermo_modify   norm no lost ignore   # a test counts them
run             ${steps}
write_dump      all custom last.dump id x y z radius modify sort id format "%d %.17g %.17g %.17g %.17g"
"""


def collision_time(diameter):
    """Of two spheres with the springs of cases/sscp1 [s]."""
    mass = DENSITY * math.pi / 6 * diameter**3
    return math.sqrt(0.5 * mass / STIFFNESS * (math.pi**2 + math.log(RESTITUTION) ** 2))


def lattice(count, pitch, width, depth):
    """`count` sites of a cubic lattice of at least `pitch` in a box, from below: [count, 3]."""
    nx, ny = int(width / pitch), int(depth / pitch)
    number = numpy.arange(count)
    site = numpy.stack([number % nx, number // nx % ny, number // (nx * ny)], axis=1)
    return (site + 0.5) * [width / nx, depth / ny, pitch]


class Bed:
    """Spheres thrown about at up to 0.5 m/s on a loose lattice, to fall into a box of `width` x `depth` [m]."""

    def __init__(self, width, depth, seed=1):
        self.width, self.depth = width, depth
        self.random = numpy.random.default_rng(seed)
        self.centres, self.diameters = numpy.zeros((0, 3)), numpy.zeros(0)

    def equal(self, count, diameter):
        pitch = 1.12 * diameter
        self.centres = lattice(count, pitch, self.width, self.depth)
        self.centres += self.random.uniform(-0.05, 0.05, (count, 3)) * diameter
        self.diameters = numpy.full(count, diameter)
        return self

    def mixed(self, small, diameter, ratio):
        """As much volume of small spheres as of ones `ratio` times as large, which lie dispersed among them."""
        large = round(small / ratio**3)
        pitch = 1.12 * diameter
        coarse = lattice(large, 1.35 * ratio * diameter, self.width, self.depth)
        layers = int(2 * (coarse[-1, 2] / pitch + 2 * ratio))
        across = int(self.width / pitch) * int(self.depth / pitch)
        sites = lattice(across * layers, pitch, self.width, self.depth)
        free = cKDTree(coarse).query(sites)[0] > (0.5 * ratio + 0.62) * diameter
        sites = sites[free][:small]
        sites += self.random.uniform(-0.05, 0.05, sites.shape) * diameter
        self.centres = numpy.concatenate([sites, coarse])
        self.diameters = numpy.concatenate([numpy.full(len(sites), diameter), numpy.full(large, ratio * diameter)])
        return self

    def write(self, path):
        n, beyond = len(self.centres), self.diameters.max()
        velocities = self.random.uniform(-0.5, 0.5, (n, 3))
        top = 2 * self.centres[:, 2].max()
        support.write(path, data_file.text(f"{n} spheres", 3 * [-beyond], numpy.array([self.width, self.depth, top]) + beyond, self.centres,
                                           self.diameters, DENSITY, velocity=velocities))  # fmt: skip

    def pour(self, folder, seconds, step, ranks=1, words="", timeout=support.LONGEST):
        """Lets it fall and lie for `seconds` at the solid step `step` [s]: a Lying. `words`: of fix tdhs."""
        self.write(os.path.join(folder, "bed.data"))
        support.write(os.path.join(folder, "in.liggghts"), SCRIPT)
        steps = round(seconds / step)
        given = {"width": self.width, "depth": self.depth, "solidStep": step, "steps": steps,
                 "every": max(1, round(0.005 / step)), "skin": 0.6 * self.diameters.max(),
                 "sortSize": 1.5 * self.diameters.max(), "words": words}  # fmt: skip
        launch.liggghts("in.liggghts", folder, given, ["hard_sphere"], ranks, timeout)
        return Lying(folder)


class Lying:
    """What a poured bed left: series over time, and the last positions."""

    def __init__(self, folder):
        record = numpy.loadtxt(os.path.join(folder, "record.txt"), skiprows=1)
        self.time, self.count, self.kinetic, self.height = record.T
        rows = numpy.loadtxt(os.path.join(folder, "last.dump"), skiprows=9)
        self.centres, self.radii = rows[:, 1:4], rows[:, 4]

    def unrest(self):
        """Kinetic energy at the end over the most there was when the spheres fell."""
        return self.kinetic[-1] / self.kinetic.max()

    def drift(self):
        """Of the mean height over the last half second [m/s]."""
        late = self.time > self.time[-1] - 0.5
        return numpy.polyfit(self.time[late], self.height[late], 1)[0]

    def overlaps(self):
        """Of all pairs that overlap, over the smaller one's diameter."""
        tree = cKDTree(self.centres)
        small = self.radii < 1.01 * self.radii.min()
        pairs = tree.query_pairs(2 * self.radii.min(), output_type="ndarray")
        if not small.all():  # large ones are few
            large = numpy.flatnonzero(~small)
            near = tree.query_ball_point(self.centres[large], 2 * self.radii.max())
            more = [(i, j) for i, others in zip(large, near) for j in others if small[j] or j > i]
            pairs = numpy.concatenate([pairs[small[pairs].all(axis=1)], numpy.array(more).reshape(-1, 2)])
        i, j = pairs.T
        gap = numpy.linalg.norm(self.centres[i] - self.centres[j], axis=1) - self.radii[i] - self.radii[j]
        return (-gap / (2 * numpy.minimum(self.radii[i], self.radii[j])))[gap < 0]
