# SPDX-License-Identifier: GPL-3.0-or-later
"""What a particle and the gas around it are to each other: dimensionless numbers, minimum fluidization, Geldart's group. SI units."""

from dataclasses import dataclass

from scipy.optimize import brentq

LOOSE_VOIDAGE = 0.42  # of a bed of spheres that begins to float; of cases/sscp1's by the paper that the methods come from
FASTEST = 1e6  # m/s: where a root is no longer looked for
HEAVIEST_GAS = 100.0  # kg/m3: Geldart's groups are of beds that gases fluidize


@dataclass(frozen=True)
class Grain:
    """A real particle of `diameter` [m] and `density` [kg/m3] in a gas of `gas_density` [kg/m3] and `viscosity` [Pa s]; `gravity` [m/s2] > 0."""

    diameter: float
    density: float
    gas_density: float
    viscosity: float
    gravity: float

    @property
    def archimedes(self):
        """Ar = rho (rho_p - rho) g d^3/mu^2; below 0 where it rises."""
        return self.gas_density * (self.density - self.gas_density) * self.gravity * self.diameter**3 / self.viscosity**2

    def reynolds(self, velocity):
        """Re = rho u d/mu."""
        return self.gas_density * velocity * self.diameter / self.viscosity

    def stokes(self, velocity):
        """St = rho_p d u/(9 mu) of an impact at `velocity`: below some 10 the gas takes up the rebound, above 1000 it is not felt (Joseph, Zenit,
        Hunt and Rosenwinkel, J. Fluid Mech. 433 (2001) 329)."""
        return self.density * self.diameter * velocity / (9 * self.viscosity)

    def drag_rate(self, law, voidage, slip):
        """k/V_p = 18 mu eps F/d^2 [kg/(m3 s)] by a `law` of drag_laws at a slip [m/s] between gas and particle."""
        return 18 * self.viscosity * voidage * law(voidage, voidage * self.reynolds(slip)) / self.diameter**2

    def relaxation_time(self, law, voidage, slip):
        """m/k [s]."""
        return self.density / self.drag_rate(law, voidage, slip)

    @property
    def viscous_relaxation_time(self):
        """tau_p = rho_p d^2/(18 mu) [s], eq. 29 of the paper: that of Stokes's drag, right for Re << 1 only."""
        return self.density * self.diameter**2 / (18 * self.viscosity)

    @property
    def _weight(self):
        """Less buoyancy, over its volume [N/m3], upwards where it rises."""
        return abs(self.density - self.gas_density) * self.gravity

    def minimum_fluidization(self, law, voidage=LOOSE_VOIDAGE):
        """The superficial velocity [m/s] at which the drag `law` carries a packing of that voidage: 18 mu F U/(eps d^2) = (rho_p - rho) g with
        Re = rho U d/mu (cases/packed-bed). None without a weight."""
        if self._weight == 0:
            return None
        return _root(lambda speed: self.drag_rate(law, voidage, speed / voidage) * speed / voidage**2 - self._weight)

    @property
    def minimum_fluidization_by_wen_yu(self):
        """U_mf [m/s] by Re_mf = (33.7^2 + 0.0408 Ar)^(1/2) - 33.7: Wen and Yu, AIChE J. 12 (1966) 610; of 284 beds within 34 % (their
        standard deviation), Re_mf 0.001 to 4000."""
        reynolds = (33.7**2 + 0.0408 * abs(self.archimedes)) ** 0.5 - 33.7
        return reynolds * self.viscosity / (self.gas_density * self.diameter)

    def terminal_velocity(self, law):
        """Of one alone in gas at rest [m/s], by the drag `law` and buoyancy; None without a weight."""
        if self._weight == 0:
            return None
        return _root(lambda speed: self.drag_rate(law, 1.0, speed) * speed - self._weight)

    @property
    def geldart_group(self):
        """A, B, C or D; None in a liquid, or where it rises.

        A to B at (rho_p - rho) d = 225 um g/cm3, B to D at (rho_p - rho) d^2 = 10^6 um2 g/cm3: Geldart, Powder Technol. 7 (1973) 285, for air at
        ambient conditions. C to A at 10 (rho_p - rho) d^3 g = 0.01 F with the cohesive force F = 8.76e-8 N of soft powders: Molerus, Powder
        Technol. 33 (1982) 81.
        """
        difference = self.density - self.gas_density
        if self.gas_density > HEAVIEST_GAS or difference <= 0:
            return None
        micrometres, heavier = 1e6 * self.diameter, 1e-3 * difference
        if heavier * micrometres**2 >= 1e6:
            return "D"
        if heavier * micrometres >= 225:
            return "B"
        return "A" if 10 * difference * self.diameter**3 * 9.81 >= 0.01 * 8.76e-8 else "C"


def _root(balance):
    """The speed [m/s] at which what rises with it from below 0 on passes 0."""
    end = 1e-9
    while balance(end) < 0 and end < FASTEST:
        end *= 2
    return brentq(balance, 0.0, end)
