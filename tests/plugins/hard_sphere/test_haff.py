# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 600
"""A gas of smooth inelastic spheres cools as Haff's law says, at the rate of Enskog's kinetic theory; an elastic one keeps its energy
as far as its collisions are binary.

T(t) = T0/(1 + t/tau)^2 (Haff, J. Fluid Mech. 134 (1983) 401), 1/tau = (1 - e^2)/6 omega0, omega0 = 4 n d^2 g0 sqrt(pi T0/m)
collisions of one sphere per time, g0 = (1 - phi/2)/(1 - phi)^3 (Carnahan and Starling, J. Chem. Phys. 51 (1969) 635); van Noije
and Ernst, Granul. Matter 1 (1998) 57, whose correction for the tails of the distribution is 0.2 % of the rate at most here.
The box is small enough, about 30 diameters, that no clusters form while T falls to a twentieth.
"""

import measured
import numpy

from hard_spheres import HardSphereTest, Scene, Spheres

DIAMETER, EDGE = 1e-3, 16  # [m], spheres along an edge of the box
COUNT = EDGE**3
STEP = 2e-5  # the mean sphere moves a thirtieth of a diameter [s]


def gas(solid_fraction, e, seed=1):
    """Spheres on a shaken lattice, T0/m = 1 m2/s2 exactly, no momentum."""
    draw = numpy.random.default_rng(seed)
    spacing = DIAMETER * (numpy.pi / 6 / solid_fraction) ** (1 / 3)
    lattice = numpy.stack([k.ravel() for k in numpy.mgrid[0:EDGE, 0:EDGE, 0:EDGE]], axis=1) + 0.5
    position = spacing * lattice + (spacing - DIAMETER) * draw.uniform(-0.49, 0.49, (COUNT, 3))
    velocity = draw.normal(size=(COUNT, 3))
    velocity -= velocity.mean(axis=0)
    velocity /= numpy.sqrt((velocity**2).sum(axis=1).mean() / 3)
    edge = float(spacing * EDGE)
    return Scene(Spheres(DIAMETER, position, velocity), (0.0, 0.0, 0.0), (edge, edge, edge), e=e, types=2, boundary="p p p",
                 skin=0.5 * DIAMETER, words="resting_speed 0", thermo="step atoms ke v_hs_binary_collisions v_hs_cluster_contacts")  # fmt: skip


def collision_frequency(solid_fraction):
    """Of one sphere, at T/m = 1 m2/s2 [1/s]."""
    number = 6 * solid_fraction / (numpy.pi * DIAMETER**3)
    at_contact = (1 - solid_fraction / 2) / (1 - solid_fraction) ** 3
    return 4 * number * DIAMETER**2 * at_contact * numpy.sqrt(numpy.pi)


class HomogeneousCooling(HardSphereTest):
    def temperature(self, solid_fraction, e, steps, every):
        """(time, T/T0)"""
        scene = gas(solid_fraction, e)
        table = self.run_scene(scene, STEP, steps, every=every).thermo()
        self.assertTrue((table[:, 1] == COUNT).all())
        return table[:, 0] * STEP, table[:, 2] / table[0, 2], table

    def test_rate(self):
        for solid_fraction, e in ((0.08, 0.8), (0.08, 0.9), (0.05, 0.9), (0.08, 0.95)):
            tau = 6 / ((1 - e * e) * collision_frequency(solid_fraction))
            steps = int(3 * tau / STEP)
            time, t, table = self.temperature(solid_fraction, e, steps, max(1, steps // 60))
            # 1/sqrt(T) is a straight line; its first part belongs to the lattice and to velocities that no collision has seen
            later = (time > 0.2 * tau)
            slope, start = numpy.polyfit(time[later] / tau, 1 / numpy.sqrt(t[later]), 1)
            bend = abs(1 / numpy.sqrt(t[later]) - slope * time[later] / tau - start).max()
            print(f"phi = {solid_fraction}, e = {e}: rate {slope:.4f} of Enskog's, off the straight line by {bend:.3f}, T/T0 = {t[-1]:.4f} at "
                  f"the end; {table[:, 3].mean():.0f} binary collisions and {table[:, 4].mean():.0f} contacts of clusters a step")
            with self.subTest(solid_fraction=solid_fraction, e=e):
                # From 4096 spheres the rate comes to 1 %.
                measured.within(self, f"cooling gas of 4096 spheres, e = {e}, solid fraction {solid_fraction}: rate over Enskog's", slope, 1, 0.05, "",
                                "Haff, J. Fluid Mech. 134 (1983) 401; van Noije and Ernst (1998)")  # fmt: skip
                self.assertAlmostEqual(start, 1, delta=0.05)

    def test_elastic(self):
        solid_fraction, collisions = 0.08, 20
        steps = int(collisions / collision_frequency(solid_fraction) / STEP)
        _, t, table = self.temperature(solid_fraction, 1.0, steps, max(1, steps // 20))
        print(f"e = 1: kinetic energy {t[-1] - 1:+.1e}, at most {abs(t - 1).max():.1e}, after {collisions} collisions of each sphere; "
              f"{table[1:, 3].mean():.0f} binary collisions and {table[1:, 4].mean():.1f} contacts of clusters a step")
        # Where spheres meet several others within one step, four passes leave energy behind: 0.24 % of it per collision of each
        # sphere at 0.03 collisions a step. Binary collisions keep it exactly: the next test.
        self.assertLess(abs(t - 1).max(), 0.003 * collisions)
        self.assertLess(t.max(), 1 + 1e-6)


class Billiard(HardSphereTest):
    def test_binary_collisions_keep_the_energy(self):
        """100 elastic spheres in a box: the steps in which none meets two others, added up."""
        draw = numpy.random.default_rng(12)
        n, edge, diameter, step, steps = 100, 0.1, 4e-3, 2e-5, 25000
        position = (numpy.stack([k.ravel() for k in numpy.mgrid[0:5, 0:5, 0:4]], axis=1) + 0.5) * 0.02
        walls = tuple(f"primitive type 2 {axis}plane {at}" for axis in "xyz" for at in (0.0, edge))
        scene = Scene(Spheres(diameter, position, draw.normal(size=(n, 3))), (-0.01,) * 3, (0.11,) * 3, e=1, walls=walls,
                      thermo="step atoms ke v_hs_binary_collisions v_hs_cluster_contacts")  # fmt: skip
        table = self.run_scene(scene, step, steps, every=steps, thermo_every=1).thermo()
        self.assertEqual(len(table), steps + 1)
        change = numpy.diff(table[:, 2]) / table[0, 2]
        binary = table[1:, 4] == 0
        print(f"billiard: {table[1:, 3][binary].sum():.0f} binary collisions change the energy by {change[binary].sum():+.1e}, "
              f"{table[1:, 4].sum():.0f} contacts of clusters by {change[~binary].sum():+.1e}")
        self.assertGreater(table[1:, 3][binary].sum(), 1000)
        measured.below(self, f"elastic billiard: energy that {table[1:, 3][binary].sum():.0f} binary collisions change", abs(change[binary]).sum(), 1e-10, "",
                       "conservation")
