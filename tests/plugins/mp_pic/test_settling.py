# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 900
# processors: 1
"""Parcels that settle in a closed column of gas: the clear front above them sinks with the hindered velocity of the drag law, the packed
one rises as mass conservation wants it, and the bed that is left keeps to close packing in every cell.

In a closed column phi u_s + (1 - phi) u_g = 0, and a parcel's weight is carried by drag and pressure:
    beta (u_g - u_s) = phi (1 - phi) (rho_p - rho_g) g,   u_s = (1 - phi) (u_s - u_g).
The front of the bed, whose solid fraction is phi_b where it grows, rises at u_s phi / (phi_b - phi).
"""

import os

import numpy

import boxes
import measured
import support

G = 9.81
GAS = (1.2, 1.8e-5)


def bvk(voidage, reynolds):
    """F of Beetstra, van der Hoef and Kuipers (2007) as in the paper's eq. 19."""
    eps, phi = voidage, 1 - voidage
    return (10 * phi / eps**2 + eps**2 * (1 + 1.5 * phi**0.5)
            + 0.413 * reynolds / (24 * eps**2) * (1 / eps + 3 * eps * phi + 8.4 * reynolds**-0.343)
            / (1 + 10 ** (3 * phi) * reynolds ** (-0.5 - 2 * phi)))  # fmt: skip


def hindered_velocity(diameter, density, phi):
    eps, slip = 1 - phi, 1e-3
    for _ in range(200):
        factor = bvk(eps, eps * GAS[0] * slip * diameter / GAS[1])
        beta = 18 * GAS[1] * eps * phi * factor / diameter**2
        slip = phi * eps * (density - GAS[0]) * G / beta
    return eps * slip


class Fronts(support.ProgramTest):
    SIZE, CELLS = (0.0025, 0.0025, 0.04), (1, 1, 64)
    DIAMETER, DENSITY, PHI = 1.2e-4, 1000.0, 0.3
    COUNTS = (8, 8, 128)

    def test_move_as_mass_conservation_wants(self):
        weight = self.PHI * numpy.prod(self.SIZE) / (numpy.pi / 6 * self.DIAMETER**3) / numpy.prod(self.COUNTS)
        # P_s as low as the suspension bears: it breaks into bubbles below, and the bed's front smears above
        box = boxes.Box(self.SIZE, self.CELLS, float(self.DIAMETER * weight ** (1 / 3)), self.DENSITY, boxes.lattice(self.SIZE, self.COUNTS),
                        weight=float(weight), gravity=G, fluid=GAS, step=2.5e-4, end=0.3, write_every=0.025,
                        integrator="fix move all mp_pic stress harris_crighton 4 3\n")  # fmt: skip
        done = self.run_case(box.write(os.path.join(self.root, "column")))
        cell = self.SIZE[2] / self.CELLS[2]
        speed = hindered_velocity(self.DIAMETER, self.DENSITY, self.PHI)
        times, clear, settled = [], [], []
        for time in numpy.arange(1, 13) * 0.025:
            phi = 1 - boxes.field(done.folder, time, "voidage")
            height = numpy.arange(len(phi) + 1) * cell
            # where the solids above, as a suspension of PHI, begin: their amount says it, and no threshold does
            middle = numpy.flatnonzero(abs(phi - self.PHI) < 0.01)
            low = middle[len(middle) // 2]
            clear.append(height[low] + phi[low:].sum() * cell / self.PHI)
            # solids in excess of the suspension, up to its middle
            settled.append((phi[:low] - self.PHI).sum() * cell)
            times.append(time)
        late = slice(1, None)  # the start, where all are at rest, aside
        sinks = -numpy.polyfit(times[late], clear[late], 1)[0]
        gains = numpy.polyfit(times[late], settled[late], 1)[0]
        front, rate = self.packed_front(done, times, cell, speed)
        for name, found, exact, source in (
            ("clear front sinks", sinks, speed, "hindered velocity, BVK"), ("solids gained by the bed below", gains, speed * self.PHI, "mass conservation"),
            ("packed front rises", front, rate, "mass conservation"),
        ):  # fmt: skip
            measured.within(self, f"MP-PIC: suspension of solid fraction 0.3 settling in a closed column: {name}", found, exact, 0.03 * exact, "m/s", source)

    def packed_front(self, done, times, cell, speed):
        """(Speed of the place where the bed begins, and what mass conservation gives with the solid fraction that is added below it). The
        bed begins a tenth of the way from the suspension's solid fraction to its own: farther down, the front's own spreading counts."""
        place, mean = [], []
        for time in times:
            phi = 1 - boxes.field(done.folder, time, "voidage")
            level = self.PHI + 0.1 * (phi[: len(phi) // 2].max() - self.PHI)
            k = numpy.flatnonzero(phi[: len(phi) // 2] > level).max()
            share = (phi[k] - level) / (phi[k] - phi[k + 1])
            place.append((k + 0.5 + share) * cell)
            # solids below the front, the bed's and the suspension's part of the cell that it cuts
            mean.append((phi[: k + 1].sum() + share * phi[k + 1]) * cell)
        front = numpy.polyfit(times[2:], place[2:], 1)[0]
        density = numpy.polyfit(place[2:], mean[2:], 1)[0]  # of what is added
        return front, speed * self.PHI / (density - self.PHI)


class BedAtRest(support.ProgramTest):
    CLOSE_PACKING = 0.6

    def test_keeps_to_close_packing_in_every_cell(self):
        """A bed of 8-fold parcels of 3.3 mm spheres falls from a packing of 0.4 and lies for 10 s."""
        size, cells, counts = (0.0572, 0.0572, 0.3), (4, 4, 16), (8, 8, 20)
        diameter = 3.256e-3 * 2
        height = numpy.prod(counts) * numpy.pi / 6 * diameter**3 / (0.4 * size[0] * size[1])
        draw = numpy.random.default_rng(1)
        place = boxes.lattice((size[0], size[1], height), counts) + draw.uniform(-2e-4, 2e-4, (numpy.prod(counts), 3))
        place = numpy.clip(place, diameter / 2, numpy.array(size) - diameter / 2)
        box = boxes.Box(size, cells, diameter, 1131.0, place, weight=8.0, gravity=G, e=0.84, en=0.92, et=0.92, step=1e-3, end=12.0,
                        write_every=0.05, sides="noSlip")  # fmt: skip
        done = self.run_case(box.write(os.path.join(self.root, "bed")), timeout=800)
        time, fullest = done.column("series/time"), 1 - done.column("series/lowest_voidage")
        relieved, energy = done.column("ledger/cells_relieved")[-1], done.column("series/kinetic_energy")
        rest = time > 3  # it falls, and sloshes until 2.6 s
        measured.below(self, "MP-PIC: bed of 1,280 parcels at rest for 9 s: fullest cell, close packing being 0.6", fullest[rest].max(), 1.02 * self.CLOSE_PACKING)
        self.assertEqual(relieved, 0)  # nothing was handed on to keep it so
        measured.below(self, "the same: kinetic energy at most, of that at the start of its fall", energy[rest].max() / energy[1], 0.01)  # nothing wakes it up
