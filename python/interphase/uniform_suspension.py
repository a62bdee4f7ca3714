# SPDX-License-Identifier: GPL-3.0-or-later
"""What a drag law says of a uniform suspension: hindered velocity, relaxation time, equilibrium in a stream, minimum fluidization.

SI units; velocities are magnitudes.
"""

import math
from dataclasses import dataclass

from interphase.drag_laws import LAWS


def where(function, target, low=1e-9, high=1e3):
    """The argument at which the rising `function` reaches `target`, by bisection of its logarithm."""
    for _ in range(200):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if function(middle) < target else (low, middle)
    return math.sqrt(low * high)


@dataclass(frozen=True)
class Suspension:
    """Equal particles at the solid fraction `phi` in a fluid."""

    phi: float
    diameter: float
    particle_density: float
    density: float
    viscosity: float
    law: str
    gravity: float = 9.81

    @property
    def voidage(self):
        """1 - phi."""
        return 1 - self.phi

    def rate(self, slip):
        """Drag per volume of particle and slip [kg/(m3 s)]."""
        re = self.voidage * self.density * slip * self.diameter / self.viscosity
        return 18 * self.viscosity * self.voidage * LAWS[self.law](self.voidage, re) / self.diameter**2

    def carrying_slip(self):
        """Slip at which drag and pressure gradient carry the particles [m/s]: rate slip = eps (rho_p - rho) g."""
        weight = self.voidage * (self.particle_density - self.density) * self.gravity
        return where(lambda slip: self.rate(slip) * slip, weight)

    def hindered_velocity(self):
        """Of the particles where nothing flows through the mixture: a closed box [m/s]."""
        return self.voidage * self.carrying_slip()

    def carrying_velocity(self):
        """Superficial velocity at which particles stand [m/s]; at the packing of a bed that of minimum fluidization."""
        return self.voidage * self.carrying_slip()

    def relaxation_time(self, superficial=None):
        """m/k [s] of particles that stand in a stream of this superficial velocity, of carried ones by default."""
        slip = self.carrying_slip() if superficial is None else superficial / self.voidage
        return self.particle_density / self.rate(slip)

    def pressure_gradient(self, superficial):
        """Of p - rho g.x through particles at rest [Pa/m]: eps dp/dz = phi rate slip."""
        slip = superficial / self.voidage
        return self.phi * self.rate(slip) * slip / self.voidage

    def weight_gradient(self):
        """Of p - rho g.x that carries the particles [Pa/m]."""
        return self.phi * (self.particle_density - self.density) * self.gravity
